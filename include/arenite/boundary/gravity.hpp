// Gravity: one acceleration for all matter, constant or in time.
#pragma once

#include <array>
#include <utility>

#include <arenite/boundary/place_function.hpp>
#include <arenite/core/error.hpp>
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
  static constexpr bool reads_start_state = false;
  Vec<T, D> g;
  Vec<T, D> acceleration(double) const { return g; }
};

template <class Site>
BoundGravity<typename Site::T, Site::D> bind_part(const Gravity& gravity, const Site&) {
  return {vector_argument<typename Site::T, Site::D>("gravity", gravity.g)};
}

/// Acceleration of all matter in time, m/s2.
struct GravityInTime {
  VectorFunction g;
};
/// `gravity({0, -9.81}, Ramp{.over = 0.5})`: a vector times a function of time.
inline GravityInTime gravity(const Triple& g, const ScalarFunction& factor) {
  require(factor.is_uniform(), "gravity: factor", "f(x, t)",
          "must be a function of time alone; use body_force");
  return {VectorFunction(g, factor)};
}
/// Any function of time that returns (x, y, z), m/s2.
template <class F>
requires(PlaceFunction<Triple>::of_time<F>) GravityInTime gravity(F g) { return {std::move(g)}; }

template <class T, int D>
struct BoundGravityInTime {
  static constexpr bool reads_start_state = false;
  VectorFunction g;
  Vec<T, D> acceleration(double time) const {
    return value_at(g, Vec<T, D>(Vec<T, D>::Zero()), time, "gravity");
  }
};

template <class Site>
BoundGravityInTime<typename Site::T, Site::D> bind_part(const GravityInTime& gravity, const Site&) {
  return {gravity.g};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
