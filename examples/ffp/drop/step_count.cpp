#include "step_count.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace arenite::ffp {

std::string cause_of_steps(const DropOptions& o, double smallest) {
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

}  // namespace arenite::ffp
