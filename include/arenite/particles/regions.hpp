// Regions to fill and to choose points by: balls, polygons, and what is made of several.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <arenite/particles/region.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Positions nearer than the radius, m: `Ball({0.5, 1}, 0.2)` a disc in the plane (in axisymmetry a torus, or
/// a ball if the centre lies on the axis), `Ball({0, 1, 0}, 0.2)` a ball in space.
template <std::size_t D>
class Ball {
 public:
  std::array<double, D> lower, upper;  ///< bounds, m

  /// Throws `error` unless the centre is finite and the radius positive.
  Ball(const std::array<double, D>& centre, double radius) : centre_{centre}, radius_{radius} {
    require(radius > 0 && std::isfinite(radius), "Ball.radius", radius, "must be positive");
    for (std::size_t k = 0; k < D; ++k) {
      require(std::isfinite(centre[k]), joined_text("Ball.centre[", k, "]"), centre[k], "must be finite");
      lower[k] = centre[k] - radius;
      upper[k] = centre[k] + radius;
    }
  }
  Ball(const double (&centre)[D], double radius) : Ball(std::to_array(centre), radius) {}

  bool contains(const Vec<double, static_cast<int>(D)>& x) const {
    double square_distance = 0;
    for (std::size_t k = 0; k < D; ++k) square_distance += square(x[static_cast<int>(k)] - centre_[k]);
    return square_distance < square(radius_);
  }
  template <int Other>
  bool contains(const Vec<double, Other>& x) const = delete;  // of another dimension

 private:
  std::array<double, D> centre_;
  double radius_;
};

/// The inside of a closed line of corners (x, y), m, in either sense; the last corner is joined to the first.
/// Where the line crosses itself: what an odd number of turns encloses. Polygons that share sides share no
/// position and leave none out.
class Polygon {
 public:
  using Corner = std::array<double, 2>;
  Corner lower, upper;  ///< bounds, m

  /// Throws `error` unless there are three corners or more, all finite, and they enclose an area.
  explicit Polygon(std::vector<Corner> corners) : corners_{std::move(corners)} {
    require(corners_.size() >= 3, "Polygon.corners", corners_.size(), "must be at least three");
    lower = upper = corners_.front();
    for (std::size_t i = 0; i < corners_.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        require(std::isfinite(corners_[i][k]), joined_text("Polygon.corners[", i, "][", k, "]"),
                corners_[i][k], "must be finite");
        lower[k] = std::min(lower[k], corners_[i][k]);
        upper[k] = std::max(upper[k], corners_[i][k]);
      }
    require(lower[0] < upper[0] && lower[1] < upper[1], "Polygon.corners", corners_.size(),
            "must enclose an area");
  }

  bool contains(const Vec<double, 2>& x) const {
    bool inside = false;
    for (std::size_t i = 0, before = corners_.size() - 1; i < corners_.size(); before = i++) {
      // From the lower end to the upper one, so that both polygons at a side compute the same.
      const Corner* a = &corners_[before];
      const Corner* b = &corners_[i];
      if ((*a)[1] > (*b)[1]) std::swap(a, b);
      if ((*a)[1] <= x[1] && x[1] < (*b)[1]) {
        const double across = ((*b)[0] - (*a)[0]) * (x[1] - (*a)[1]) - (x[0] - (*a)[0]) * ((*b)[1] - (*a)[1]);
        if (across > 0) inside = !inside;
      }
    }
    return inside;
  }
  template <int Other>
  bool contains(const Vec<double, Other>& x) const = delete;  // in space

 private:
  std::vector<Corner> corners_;
};

/// Regions that tell whether they contain a position: all but `Cells`.
template <class R>
concept region_of_positions =
    !std::same_as<R, Cells> && !std::same_as<R, AnyRegion> && (region_type<R, 2> || region_type<R, 3>);

/// Two regions: `Rule` of whether a, and whether b, contains a position.
template <class A, class B, class Rule>
struct Combined {
  A a;
  B b;
  template <int D>
  requires(region_type<A, D>&& region_type<B, D>) bool contains(const Vec<double, D>& x) const {
    return Rule{}(a.contains(x), b.contains(x));
  }
};
/// The first and not the second.
struct AndNot {
  bool operator()(bool first, bool second) const { return first && !second; }
};

/// `a | b`: in one of them, or both.
template <class A, class B>
using UnionOf = Combined<A, B, std::logical_or<>>;
/// `a & b`: in both.
template <class A, class B>
using IntersectionOf = Combined<A, B, std::logical_and<>>;
/// `a - b`: in a, not in b.
template <class A, class B>
using DifferenceOf = Combined<A, B, AndNot>;

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
