// Scalars: the number types that the library computes with, and the branch-free choice that laws use.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <concepts>
#include <cstdint>
#include <numbers>

#include <arenite/core/instruction_set.hpp>

namespace arenite {

/// Number of a node, a cell or a point. 32 bits: half the memory traffic of `std::size_t`.
using Index = std::uint32_t;

/// Marks "no cell", "no node".
inline constexpr Index none = static_cast<Index>(-1);

}  // namespace arenite

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A scalar in which a scene can be computed.
template <class T>
concept real_scalar = std::floating_point<T>;

/// Also the half circle in radians.
inline constexpr double pi = std::numbers::pi;

/// `mask ? a : b`, written as a function so that the same source serves a scalar and a pack of scalars.
template <real_scalar T>
constexpr T select(bool mask, T a, T b) {
  return mask ? a : b;
}

/// Whether a mask is true anywhere: for a scalar the mask itself.
constexpr bool any_of(bool mask) { return mask; }

/// Whether a mask is true everywhere: for a scalar the mask itself.
constexpr bool all_of(bool mask) { return mask; }

/// 1 / x; for a pack to a few units in the last place where that spares the divider.
template <real_scalar T>
constexpr T reciprocal(T x) {
  return 1 / x;
}
/// 1 / sqrt(x), x > 0; for a pack to a few units in the last place.
template <real_scalar T>
T reciprocal_root(T x) {
  return 1 / std::sqrt(x);
}

/// x^2
template <class T>
constexpr T square(T x) {
  return x * x;
}

namespace detail {

/// Type of one lane: T itself, or that of a pack's lanes.
template <class T>
struct ScalarOf {
  using type = T;
};
template <class T>
requires requires { typename T::scalar; }
struct ScalarOf<T> {
  using type = typename T::scalar;
};

}  // namespace detail

/// The scalar of a pack; T itself where it is one.
template <class T>
using scalar_of = typename detail::ScalarOf<T>::type;

/// Stands in for a member, or for a value, that a composition does not need; made of anything.
struct Nothing {
  Nothing() = default;
  template <class... Any>
  constexpr explicit Nothing(const Any&...) {}
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
