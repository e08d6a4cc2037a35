// Gravity: one acceleration for all matter, constant or in time.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <utility>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/functions/place_function.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Acceleration of all matter, m/s2.
struct Gravity {
  std::array<double, 3> g{};
  int components = 0;  ///< that were given; 0: (x, y, z), z = 0 in two dimensions
};
/// `gravity({0, -9.81})`: as many components as the scene has dimensions.
template <std::size_t N>
constexpr Gravity gravity(const double (&g)[N]) {
  static_assert(N == 2 || N == 3, "gravity: two components in the plane, three in space");
  Gravity all{.components = static_cast<int>(N)};
  for (std::size_t k = 0; k < N; ++k) all.g[k] = g[k];
  return all;
}
constexpr Gravity gravity(const Triple& g) { return {g}; }

namespace detail {

/// Throws `error` unless a vector was given with the components that the scene has.
template <int D>
void check_components(int given) {
  require(given == 0 || given == D, "gravity: components", given,
          {"must be ", D, ", as many as the scene has dimensions"});
}

}  // namespace detail

/// Gravity in a scene: a part that accelerates.
template <class T, int D>
struct BoundGravity {
  static constexpr bool reads_start_state = false;
  Vec<T, D> g;
  using OnlyOne = Gravity;
  Vec<T, D> acceleration(double) const { return g; }
};

template <class Traits>
BoundGravity<typename Traits::T, Traits::D> bind_part(const Gravity& gravity, const Traits&) {
  detail::check_components<Traits::D>(gravity.components);
  return {vector_argument<typename Traits::T, Traits::D>("gravity", gravity.g)};
}

/// Acceleration of all matter in time, m/s2.
struct GravityInTime {
  VectorFunction g;
  int components = 0;  ///< as in `Gravity`
};
/// `gravity({0, -9.81}, Ramp{.over = 0.5})`: a vector times a function of time.
inline GravityInTime gravity(const Triple& g, const ScalarFunction& factor) {
  require(factor.is_uniform(), "gravity: factor", "f(x, t)",
          "must be a function of time alone; use body_force");
  return {VectorFunction(g, factor)};
}
template <std::size_t N>
GravityInTime gravity(const double (&g)[N], const ScalarFunction& factor) {
  const Gravity given = gravity(g);
  GravityInTime in_time = gravity(given.g, factor);
  in_time.components = given.components;
  return in_time;
}
/// Any function of time that returns (x, y, z), m/s2.
template <class F>
requires(PlaceFunction<Triple>::of_time<F>) GravityInTime gravity(F g) { return {std::move(g)}; }

template <class T, int D>
struct BoundGravityInTime {
  static constexpr bool reads_start_state = false;
  VectorFunction g;
  using OnlyOne = Gravity;
  Vec<T, D> acceleration(double time) const { return value_at(g, zeros<Vec<T, D>>(), time, "gravity"); }
};

template <class Traits>
BoundGravityInTime<typename Traits::T, Traits::D> bind_part(const GravityInTime& gravity, const Traits&) {
  detail::check_components<Traits::D>(gravity.components);
  return {gravity.g};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
