// Initial stress of a body: at rest under level ground, or any function of the position.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>

#include <arenite/core/vector_argument.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Initial stress of level ground at rest: vertical stress from the weight above, horizontal stress k0 times
/// that.
struct Geostatic {
  double surface = std::numeric_limits<double>::quiet_NaN();  ///< height of the free surface along `axis`, m
  double k0 = std::numeric_limits<double>::quiet_NaN();       ///< horizontal over vertical stress, -
  double gravity = 9.81;                                      ///< m/s2
  int axis = 1;                                               ///< vertical axis

  /// Throws `error` unless all is given, and fits `dimensions`.
  void check(int dimensions) const {
    require(std::isfinite(surface), "Geostatic.surface", surface, "must be given");
    require(k0 >= 0 && std::isfinite(k0), "Geostatic.k0", k0, "must be given, and not negative");
    require(std::isfinite(gravity), "Geostatic.gravity", gravity, "must be finite");
    require(axis >= 0 && axis < dimensions, "Geostatic.axis", axis, "must be an axis of the scene");
  }
};

/// `Geostatic{..}`, or a function of the position (x, y, z = 0 in two dimensions), m, that returns a stress
/// as a `std::array<double, 6>` (xx, yy, zz, xy, yz, zx), Pa, tension positive. In two dimensions zz is the
/// stress out of the plane (axisymmetry: hoop stress), yz and zx are zero.
class InitialStress {
 public:
  using Position = std::array<double, 3>;
  using Six = std::array<double, 6>;

  InitialStress(const Geostatic& ground)
      : check_{[ground](int dimensions) { ground.check(dimensions); }},
        at_{[ground](const Position& x, double density) {
          const auto vertical = static_cast<std::size_t>(ground.axis);
          const double pressure = density * ground.gravity * std::max(0.0, ground.surface - x[vertical]);
          Six stress{};
          for (std::size_t k = 0; k < 3; ++k) stress[k] = -pressure * (k == vertical ? 1.0 : ground.k0);
          return stress;
        }} {}
  template <class F>
  requires std::is_invocable_r_v<Six, const F&, const Position&> InitialStress(F f)
      : at_{[f = std::move(f)](const Position& x, double) -> Six { return f(x); }} {}

  /// Throws `error` where it does not fit a scene of so many dimensions.
  void check(int dimensions) const {
    if (check_) check_(dimensions);
  }
  /// Stress at a position, m, of matter of a density, kg/m3. Throws `error` that names the position unless it
  /// is finite and one of the scene's dimensions.
  template <class T, int D>
  Sym<T, D> at(const Vec<T, D>& x, double density) const {
    static constexpr std::array<const char*, 6> names{"xx", "yy", "zz", "xy", "yz", "zx"};
    const Six given = at_(in_space(x), density);
    Sym<T, D> stress{};
    for (std::size_t k = 0; k < 6; ++k) {
      const auto name = [&] {
        return joined_text("FillOptions.stress, ", names[k], " at ", vector_text(x), " m");
      };
      if (!std::isfinite(given[k])) require(false, name(), given[k], "must be finite");
      if (k < stress.size)
        stress[k] = static_cast<T>(given[k]);
      else if (given[k] != 0)
        require(false, name(), given[k], "must be zero in two dimensions");
    }
    return stress;
  }

 private:
  std::function<void(int)> check_{};
  std::function<Six(const Position&, double)> at_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
