// Initial stress of a body: at rest under level ground, or any function of the position.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/core/vector_argument.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Initial stress of level ground at rest under the scene's gravity: vertical stress from the weight above,
/// horizontal stress k0 times that. The weight is that of the body's own matter up to the surface, and of the
/// layers above it: other bodies with a `Geostatic`, by the bounds of their regions.
struct Geostatic {
  double surface =
      std::numeric_limits<double>::quiet_NaN();  ///< height of the free surface, m; required, any
  double k0 =
      std::numeric_limits<double>::quiet_NaN();  ///< horizontal over vertical stress, -; required, >= 0
  double surcharge = 0;                          ///< pressure on the surface, Pa, >= 0
  bool may_move = false;                         ///< ground that is not at rest is no mistake: a dam breaks

  /// Throws `error` unless all is given.
  void check() const;
};

/// The scene's data for the geostatic stress of a body.
struct Ground {
  struct Layer {
    double density;                      ///< kg/m3
    std::array<double, 3> lower, upper;  ///< bounds, m; may be infinite
  };
  std::array<double, 3> gravity{};  ///< when the body is filled, m/s2
  double time = 0;                  ///< then, s
  std::vector<Layer> above{};       ///< of other matter above the body

  /// The axis along which gravity pulls. Throws `error` if there is none.
  std::size_t axis() const;
};

/// `Geostatic{..}`, or a function of the position (x, y, z = 0 in two dimensions), m, that returns a stress
/// as a `std::array<double, 6>` (xx, yy, zz, xy, yz, zx), Pa, tension positive. In two dimensions zz is the
/// stress out of the plane (axisymmetry: hoop stress), yz and zx are zero.
class InitialStress {
 public:
  using Position = std::array<double, 3>;
  using Six = std::array<double, 6>;

  InitialStress(const Geostatic& ground) : geostatic_{ground} {}
  template <class F>
  requires std::is_invocable_r_v<Six, const F&, const Position&> InitialStress(F f) : at_{std::move(f)} {}

  const std::optional<Geostatic>& geostatic() const { return geostatic_; }

  /// A `Geostatic` as a function of the position in a ground, for matter of a density, kg/m3.
  InitialStress in(const Ground& ground, double density) const;
  /// Stress at a position, m; of a `Geostatic`: once it is `in` a ground. Throws `error` that names the
  /// position unless it is finite and one of the scene's dimensions.
  template <class T, int D>
  Sym<T, D> at(const Vec<T, D>& x) const {
    const Six given = checked(in_space(x), D);
    Sym<T, D> stress{};
    for (std::size_t k = 0; k < stress.size; ++k) stress[k] = static_cast<T>(given[k]);
    return stress;
  }

 private:
  Six checked(const Position& x, std::size_t dimensions) const;

  std::optional<Geostatic> geostatic_{};
  std::function<Six(const Position&)> at_{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <algorithm>
#include <cmath>
#include <span>

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

#endif  // ARENITE_HAS_COLD
