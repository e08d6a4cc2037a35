// Whether a drop takes too many steps, and which option makes them so many.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <arenite/core/error.hpp>
#include <arenite/run/run.hpp>

#include "../options/options.hpp"
#include "../text/words.hpp"

namespace arenite::ffp {

/// Steps that a run takes without `--force`: half a day of the default drop.
inline constexpr double most_steps = 1e8;

/// The option, and its value, that adds most to the number of steps, beside the default drop. `smallest`: the
/// least size of a mesh's cells, m.
inline std::string cause_of_steps(const DropOptions& o, double smallest) {
  const DropOptions usual;
  const auto stiffness = [](double poisson) {  // constrained over Young's modulus
    return (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
  };
  const auto option = [](const char* name, double value, double factor) {
    return std::pair{factor, joined_text({name, " = ", exactly(value)})};
  };
  const bool elastic = o.device == DeviceKind::elastic;
  const double none = 0;
  const std::array causes{
      option("--courant", o.courant_number(), usual.courant_number() / o.courant_number()),
      option("--end", o.end, o.end / usual.end),
      option("--young", o.young, std::sqrt(o.young / usual.young)),
      option("--poisson", o.poisson, std::sqrt(stiffness(o.poisson) / stiffness(usual.poisson))),
      option("--unit-weight", o.unit_weight, std::sqrt(usual.unit_weight / o.unit_weight)),
      option("--device-young", o.device_young,
             elastic ? std::sqrt(o.device_young / usual.device_young) : none),
      option("--device-poisson", o.device_poisson,
             elastic ? std::sqrt(stiffness(o.device_poisson) / stiffness(usual.device_poisson)) : none),
      option("--mass", o.device_mass(), elastic ? std::sqrt(usual.device_mass() / o.device_mass()) : none),
      option("--cell", o.cell_size(),
             o.mesh.empty() && !o.cell_at_cone ? usual.cell_size() / o.cell_size() : none),
      option("--cell-at-cone", o.cell_at_cone.value_or(0),
             o.cell_at_cone ? usual.cell_size() / *o.cell_at_cone : none),
      std::pair{o.mesh.empty() ? none : usual.cell_size() / smallest,
                joined_text({"--mesh = ", shown(o.mesh), " (smallest cell ", rounded(smallest), " m)"})}};
  return std::max_element(causes.begin(), causes.end(),
                          [](const auto& a, const auto& b) { return a.first < b.first; })
      ->second;
}

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
