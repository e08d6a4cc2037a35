// Regions and signed distances made of several: unions, intersections, differences.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <utility>

#include <arenite/fill/region.hpp>
#include <arenite/geometry/placed.hpp>
#include <arenite/geometry/polygon.hpp>
#include <arenite/geometry/solids.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Regions with a test of whether they contain a position: all but `Cells`.
template <class R>
concept region_of_positions =
    !std::same_as<R, Cells> && !std::same_as<R, AnyRegion> && (region_type<R, 2> || region_type<R, 3>);

/// Two regions, combined by `Rule`: whether a, and whether b, contains a position. Two signed distances give
/// another, with the right sign everywhere; where it is not exact its magnitude is too small.
template <class A, class B, class Rule>
struct Combined {
  A a;
  B b;
  template <int D>
  requires(region_type<A, D>&& region_type<B, D>) bool contains(const Vec<double, D>& x) const {
    return Rule::contains(a.contains(x), b.contains(x));
  }
  template <int D>
  requires(signed_distance<A, D>&& signed_distance<B, D>) double operator()(const Vec<double, D>& x) const {
    return Rule::distance(a(x), b(x));
  }
  template <int D>
  auto bounds() const {
    return Rule::bounds(bounds_of<D>(a), bounds_of<D>(b));
  }
};

/// In one of them, or both. The distance is exact outside.
struct InEither {
  static bool contains(bool a, bool b) { return a || b; }
  static double distance(double a, double b) { return std::min(a, b); }
  template <std::size_t D>
  static Box<D> bounds(Box<D> a, const Box<D>& b) {
    for (std::size_t k = 0; k < D; ++k) {
      a.lower[k] = std::min(a.lower[k], b.lower[k]);
      a.upper[k] = std::max(a.upper[k], b.upper[k]);
    }
    return a;
  }
};
/// In both. The distance is exact inside.
struct InBoth {
  static bool contains(bool a, bool b) { return a && b; }
  static double distance(double a, double b) { return std::max(a, b); }
  template <std::size_t D>
  static Box<D> bounds(Box<D> a, const Box<D>& b) {
    for (std::size_t k = 0; k < D; ++k) {
      a.lower[k] = std::max(a.lower[k], b.lower[k]);
      a.upper[k] = std::min(a.upper[k], b.upper[k]);
    }
    return a;
  }
};
/// In the first, not in the second. The distance is exact inside.
struct InFirst {
  static bool contains(bool a, bool b) { return a && !b; }
  static double distance(double a, double b) { return std::max(a, -b); }
  template <std::size_t D>
  static Box<D> bounds(const Box<D>& a, const Box<D>&) {
    return a;
  }
};

/// `a | b`: in one of them, or both.
template <class A, class B>
using UnionOf = Combined<A, B, InEither>;
/// `a & b`: in both.
template <class A, class B>
using IntersectionOf = Combined<A, B, InBoth>;
/// `a - b`: in a, not in b.
template <class A, class B>
using DifferenceOf = Combined<A, B, InFirst>;

template <region_of_positions A, region_of_positions B>
UnionOf<A, B> operator|(A a, B b) {
  return {std::move(a), std::move(b)};
}
template <region_of_positions A, region_of_positions B>
IntersectionOf<A, B> operator&(A a, B b) {
  return {std::move(a), std::move(b)};
}
template <region_of_positions A, region_of_positions B>
DifferenceOf<A, B> operator-(A a, B b) {
  return {std::move(a), std::move(b)};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
