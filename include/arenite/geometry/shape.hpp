// Shapes: what is a region and a signed distance in one, and their bounds.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>
#include <limits>

#include <arenite/geometry/box.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Callable with a position [D], m: the distance to the body, m, negative inside. It is called from several
/// threads at once. Optional `bounds()`, or `bounds<D>()` where it serves both dimensions: a `Box<D>` around
/// the body; outside of it the distance must not be smaller than that to the box. The shapes of `geometry/`
/// also have `contains(x)`, so that they are regions.
template <class F, int D>
concept signed_distance = requires(const F f, const Vec<double, D> x) {
  { f(x) } -> std::convertible_to<double>;
};

/// Box around a shape, m: its `bounds()`, `bounds<D>()`, or `lower` and `upper`; infinite if it has none.
template <int D, class S>
Box<std::size_t{D}> bounds_of(const S& shape) {
  Box<std::size_t{D}> box;
  if constexpr (requires { shape.template bounds<D>(); }) {
    box = shape.template bounds<D>();
  } else if constexpr (requires { Box<std::size_t{D}>(shape.bounds()); }) {
    box = shape.bounds();
  } else if constexpr (requires { shape.lower[0] < shape.upper[0]; }) {
    for (std::size_t k = 0; k < D; ++k) {
      box.lower[k] = shape.lower[k];
      box.upper[k] = shape.upper[k];
    }
  } else {
    box.lower.fill(-std::numeric_limits<double>::infinity());
    box.upper.fill(std::numeric_limits<double>::infinity());
  }
  return box;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
