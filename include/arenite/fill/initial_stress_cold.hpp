// Cold functions of initial_stress.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <span>

#include <arenite/fill/initial_stress.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void Geostatic::check() const {
  require(std::isfinite(surface), "Geostatic.surface", surface, "must be given");
  require(k0 >= 0 && std::isfinite(k0), "Geostatic.k0", k0, "must be given, and not negative");
  require(surcharge >= 0 && std::isfinite(surcharge), "Geostatic.surcharge", surcharge,
          "must be finite, and not negative");
}

ARENITE_COLD std::size_t Ground::axis() const {
  std::size_t along = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(gravity[k]) > std::abs(gravity[along])) along = k;
  const auto text = [&] { return vector_text(gravity); };
  require(gravity[along] != 0, {"Geostatic: gravity at t = ", time, " s"}, text(),
          "must act when the ground is filled; a stress without gravity is a function of the position");
  for (std::size_t k = 0; k < 3; ++k)
    require(k == along || std::abs(gravity[k]) <= 1e-9 * std::abs(gravity[along]), "Geostatic: gravity",
            text(),
            "must act along an axis: on a slope give the stress as a function of the position, and settle");
  return along;
}

ARENITE_COLD InitialStress InitialStress::in(const Ground& ground, double density) const {
  if (!geostatic_) return *this;
  geostatic_->check();
  const std::size_t vertical = ground.axis();
  const double up = ground.gravity[vertical] < 0 ? 1 : -1, g = std::abs(ground.gravity[vertical]);
  return [o = *geostatic_, above = ground.above, density, vertical, up, g](const Position& x) {
    const double depth = up * (o.surface - x[vertical]);
    double pressure = density * g * std::max(0.0, depth);
    if (depth > 0) pressure += o.surcharge;
    for (const auto& layer : above) {
      bool covers = true;
      for (std::size_t k = 0; k < 3; ++k)
        covers = covers && (k == vertical || (layer.lower[k] <= x[k] && x[k] <= layer.upper[k]));
      if (!covers) continue;
      const auto [low, high] = std::minmax({up * layer.lower[vertical], up * layer.upper[vertical]});
      pressure += (layer.density - density) * g *
                  std::max(0.0, std::min(high, up * o.surface) - std::max(low, up * x[vertical]));
    }
    Six stress{};
    for (std::size_t k = 0; k < 3; ++k) stress[k] = -pressure * (k == vertical ? 1.0 : o.k0);
    return stress;
  };
}

ARENITE_COLD InitialStress::Six InitialStress::checked(const Position& x, std::size_t dimensions) const {
  static constexpr std::array<const char*, 6> names{"xx", "yy", "zz", "xy", "yz", "zx"};
  const Six given = at_(x);
  for (std::size_t k = 0; k < 6; ++k) {
    const bool is_finite = std::isfinite(given[k]);
    if (is_finite && (dimensions == 3 || k < 4 || given[k] == 0)) continue;
    const std::string place = vector_text(std::span(x).first(dimensions));
    refuse({"FillOptions.stress, ", names[k], " at ", place, " m"}, given[k],
           {is_finite ? "must be zero in two dimensions" : "must be finite"});
  }
  return given;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
