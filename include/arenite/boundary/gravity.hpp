// Gravity: one acceleration for all matter.
#pragma once

#include <array>

#include <arenite/core/tensor.hpp>
#include <arenite/core/vector_argument.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Acceleration of all matter, m/s2.
struct Gravity {
  std::array<double, 3> g{};
};
/// `gravity({0, -9.81})`: as many components as the scene has dimensions, or fewer.
constexpr Gravity gravity(const std::array<double, 3>& g) { return {g}; }

/// Gravity in a scene: a part that accelerates.
template <class T, int D>
struct BoundGravity {
  Vec<T, D> g;
  Vec<T, D> acceleration(double) const { return g; }
};

template <class Site>
BoundGravity<typename Site::T, Site::D> bind_part(const Gravity& gravity, const Site&) {
  return {vector_argument<typename Site::T, Site::D>("gravity", gravity.g)};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
