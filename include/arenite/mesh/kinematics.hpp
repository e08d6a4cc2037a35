// Kinematics: what the dimensions of a scene mean. Each scene's first argument is a value of one of these.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Two dimensions, x and y, unit thickness (1 m) and no strain out of plane.
struct PlaneStrain {
  static constexpr int dimension = 2;
  static constexpr bool hoop = false;
  static constexpr const char* name = "plane strain";
  /// Volume per unit area, m.
  template <class T>
  static constexpr T thickness(const Vec<T, 2>&) {
    return T(1);
  }
};

/// Two dimensions, x = r >= 0 and y along the axis, the full circle: masses, volumes and forces are those of
/// the whole body, not of a radian. The hoop strain is u_r / r.
struct Axisymmetric {
  static constexpr int dimension = 2;
  static constexpr bool hoop = true;
  static constexpr bool reads_start_state = false;
  static constexpr const char* name = "axisymmetric";
  /// Circumference 2 pi r, m.
  template <class T>
  static constexpr T thickness(const Vec<T, 2>& x) {
    return T(2 * pi) * x[0];
  }
  /// The kinematics are a part of the scene: nothing moves radially on the axis.
  template <class Nodes>
  void constrain(Nodes& nodes) const {
    for (Index i = 0; i < nodes.size(); ++i) {
      if (!nodes.is_used(i)) continue;
      const double r = nodes.position(i)[0];
      require(r >= -nodes.tolerance(), "Axisymmetric: r", r, "nodes must have r >= 0");
      if (r <= nodes.tolerance()) nodes.block(i, Nodes::V::Unit(0));
    }
  }
};

/// Three dimensions.
struct ThreeDimensional {
  static constexpr int dimension = 3;
  static constexpr bool hoop = false;
  static constexpr const char* name = "solid";
  template <class T>
  static constexpr T thickness(const Vec<T, 3>&) {
    return T(1);
  }
};

/// - `dimension`: 2 or 3; `hoop`: whether there is a hoop strain u_r / r;
/// - `thickness(x)`: volume per unit area (or volume) at x, m (or -).
/// Kinematics may also play a role of a part (`part/roles.hpp`).
template <class K>
concept kinematics_type = requires {
  { K::dimension } -> std::convertible_to<int>;
  { K::hoop } -> std::convertible_to<bool>;
}
&&(K::dimension == 2 || K::dimension == 3);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
