// Strength of frictional matter, the part that Mohr-Coulomb and Drucker-Prager share: its constants and their
// rules.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <arenite/core/error.hpp>
#include <arenite/law/elasticity.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// Greatest angle of friction, rad: 88.8 deg. The round-off of a return grows with 1 / (pi/2 - friction); in
/// float it is here 3e-5 of the trial stress.
inline constexpr double greatest_friction = 1.55;

/// Throws `error` unless the constants make sense: friction in [0, 1.55], dilatancy in [0, friction],
/// cohesion >= 0
/// and positive where there is no friction, tension >= 0, greatest volume ratio >= 1.
inline void check_strength(std::string_view law, double friction, double cohesion, double dilatancy,
                           double tension, double greatest_volume_ratio) {
  check(friction >= 0 && friction <= greatest_friction, law, "friction", friction,
        "must lie in [0, 1.55] rad (88.8 deg)");
  check(cohesion >= 0 && std::isfinite(cohesion), law, "cohesion", cohesion, "must not be negative (Pa)");
  check(friction > 0 || cohesion > 0, law, "cohesion", cohesion,
        "must be positive where friction is 0: matter without both has no strength");
  check(dilatancy >= 0 && dilatancy <= friction, law, "dilatancy", dilatancy, "must lie in [0, friction]");
  check(tension >= 0, law, "tension", tension, "must not be negative (Pa)");
  check(greatest_volume_ratio >= 1, law, "greatest_volume_ratio", greatest_volume_ratio,
        "must be at least 1");
}

/// Mean stress at the tip of the cone, c cot(phi), Pa; infinite without friction.
inline double apex(double friction, double cohesion) {
  return friction > 0 ? cohesion / std::tan(friction) : std::numeric_limits<double>::infinity();
}

/// The memory of a separation is one number: it can stand for matter that opened on all sides, not for a
/// crack.
inline void check_memory(std::string_view law, bool remembers, double tension, double apex) {
  check(!remembers || tension >= apex, law, "tension", tension,
        "a law that remembers its opening needs the cut-off at the apex (leave tension out)");
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
