// Whether a drop takes too many steps, and which option is the reason.
#pragma once

#include <algorithm>
#include <string>

#include <arenite/core/error.hpp>
#include <arenite/run/run.hpp>

#include "../options/options.hpp"
#include "../text/words.hpp"

namespace arenite::ffp {

/// Steps that a run takes without `--force`: half a day of the default drop.
inline constexpr double most_steps = 1e8;

/// The option, and its value, that adds most to the number of steps, beside the default drop. `smallest`: the
/// least size of a mesh's cells, m.
std::string cause_of_steps(const DropOptions& o, double smallest);

/// Throws `error` that names the option to change if there are too many steps and `--force` is not given.
/// `smallest()`: see `cause_of_steps`.
template <class Smallest>
void accept_steps(const ExpectedSteps& expected, const DropOptions& o, Smallest&& smallest) {
  if (expected.count <= most_steps || o.force) return;
  throw error(joined_text({cause_of_steps(o, smallest()), ": makes the run take about ",
                           rounded(expected.count), " steps of ", rounded(expected.length),
                           " s; must be at most ", rounded(most_steps), " steps, or --force be given"}));
}

/// `expected_steps` of the drop, if `accept_steps` lets them pass.
template <class Scene>
ExpectedSteps accepted_steps(const Scene& scene, const DropOptions& o) {
  const ExpectedSteps expected = expected_steps(scene, {.end = o.end, .courant = o.courant_number()});
  accept_steps(expected, o, [&] {
    auto smallest = scene.mesh.size(0);
    for (Index c = 1; c < scene.mesh.cell_count(); ++c) smallest = std::min(smallest, scene.mesh.size(c));
    return smallest;
  });
  return expected;
}

}  // namespace arenite::ffp
