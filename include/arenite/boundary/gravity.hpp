// Gravity: one acceleration for all matter.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Acceleration of all matter, m/s2.
struct Gravity {
  std::array<double, 3> g{};
};
/// `gravity({0, -9.81})`: as many components as the scene has dimensions, or fewer.
inline Gravity gravity(std::initializer_list<double> g) {
  require(g.size() <= 3, "gravity: components", g.size(), "must be at most 3");
  Gravity out;
  std::copy(g.begin(), g.end(), out.g.begin());
  return out;
}

/// Gravity in a scene: a part that accelerates.
template <class T, int D>
struct BoundGravity {
  Vec<T, D> g;
  Vec<T, D> acceleration(double) const { return g; }
};

template <class Site>
BoundGravity<typename Site::T, Site::D> bind_part(const Gravity& gravity, const Site&) {
  BoundGravity<typename Site::T, Site::D> bound;
  for (std::size_t k = 0; k < 3; ++k) {
    const double g = gravity.g[k];
    require(std::isfinite(g), "gravity", g, "must be finite");
    if (k < Site::D)
      bound.g[static_cast<int>(k)] = static_cast<typename Site::T>(g);
    else
      require(g == 0, "gravity", g, "must be zero along an axis that the scene does not have");
  }
  return bound;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
