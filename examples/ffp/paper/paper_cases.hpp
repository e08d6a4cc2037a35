// The drops that the paper made, and the same with another law of the sand.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "../options/options.hpp"
#include "../options/paper_options.hpp"

namespace arenite::ffp {

/// Friction angles between sand and penetrometer: from the paper's best fit to fully rough, deg.
inline constexpr std::array paper_deltas{20, 24, 28, 32, 36, 40};

/// One drop. The name, that of its folder, says what it is.
struct PaperCase {
  std::string name;
  DropOptions options;
};

/// "slice-elastic-20", "rigid-32-log-rate".
std::string name_of_case(Kinematics kinematics, DeviceKind device, int delta, LawKind law);

/// All cases in the order in which they run: half-sections before slices, the cheap before the dear.
std::vector<PaperCase> paper_cases(const PaperOptions& o);

}  // namespace arenite::ffp
