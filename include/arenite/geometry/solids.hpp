// Balls, rounded boxes, capsules and cylinders: regions and exact signed distances.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/geometry/box.hpp>
#include <arenite/geometry/contact_segment.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

template <std::size_t D>
auto finite_place(std::string_view name, const std::array<double, D>& x) {
  Vec<double, static_cast<int>(D)> place;
  for (std::size_t k = 0; k < D; ++k) {
    require(std::isfinite(x[k]), {name, "[", k, "]"}, x[k], "must be finite");
    place[static_cast<int>(k)] = x[k];
  }
  return place;
}

template <int D>
std::array<double, 3> padded(const Vec<double, D>& x) {
  if constexpr (D == 2)
    return {x[0], x[1], 0};
  else
    return {x[0], x[1], x[2]};
}

}  // namespace detail

/// Positions nearer than the radius, m: `Ball({0.5, 1}, 0.2)` a disc in the plane (in axisymmetry a torus, or
/// a ball if the centre lies on the axis), `Ball({0, 1, 0}, 0.2)` a ball in space.
template <std::size_t D>
class Ball {
 public:
  using Place = Vec<double, static_cast<int>(D)>;
  std::array<double, D> lower, upper;  ///< bounds, m

  /// Throws `error` unless the centre is finite and the radius positive.
  Ball(const std::array<double, D>& centre, double radius) : radius_{radius} {
    require(radius > 0 && std::isfinite(radius), "Ball.radius", radius, "must be positive");
    centre_ = detail::finite_place("Ball.centre", centre);
    for (std::size_t k = 0; k < D; ++k) {
      lower[k] = centre[k] - radius;
      upper[k] = centre[k] + radius;
    }
  }
  Ball(const double (&centre)[D], double radius) : Ball(std::to_array(centre), radius) {}

  bool contains(const Place& x) const { return (x - centre_).squaredNorm() < radius_ * radius_; }
  template <int Other>
  bool contains(const Vec<double, Other>& x) const = delete;  // of another dimension
  double operator()(const Place& x) const { return (x - centre_).norm() - radius_; }
  template <int Other>
  double operator()(const Vec<double, Other>& x) const = delete;
  Box<D> bounds() const { return {lower, upper}; }
  std::vector<ContactSegment> contact_segments() const {
    return {{detail::padded(centre_), detail::padded(centre_), radius_}};
  }

 private:
  Place centre_;
  double radius_;
};

/// A box whose edges and corners are rounded with a radius, m.
template <std::size_t D>
class RoundedBox {
 public:
  using Place = Vec<double, static_cast<int>(D)>;

  /// Throws `error` unless twice the radius fits into each extent.
  RoundedBox(const Box<D>& box, double radius) : core_{box}, radius_{radius} {
    require(radius >= 0, "RoundedBox.radius", radius, "must not be negative");
    for (std::size_t k = 0; k < D; ++k) {
      const double extent = box.upper[k] - box.lower[k];
      require(extent > 0 && std::isfinite(extent), {"RoundedBox.upper[", k, "]"}, box.upper[k],
              "must be finite and exceed lower");
      require(2 * radius <= extent, "RoundedBox.radius", radius,
              {"must not exceed half of the extent ", extent, " along axis ", k});
      core_.lower[k] += radius;
      core_.upper[k] = std::max(core_.upper[k] - radius, core_.lower[k]);
    }
  }
  RoundedBox(const double (&lower)[D], const double (&upper)[D], double radius)
      : RoundedBox(unchecked(lower, upper), radius) {}

  bool contains(const Place& x) const { return (*this)(x) < 0; }
  double operator()(const Place& x) const { return core_(x) - radius_; }
  Box<D> bounds() const {
    Box<D> box = core_;
    for (std::size_t k = 0; k < D; ++k) {
      box.lower[k] -= radius_;
      box.upper[k] += radius_;
    }
    return box;
  }
  std::vector<ContactSegment> contact_segments() const { return contact_segments_of_box(core_, radius_); }

 private:
  static Box<D> unchecked(const double (&lower)[D], const double (&upper)[D]) {
    Box<D> box;
    box.lower = std::to_array(lower);
    box.upper = std::to_array(upper);
    return box;
  }

  Box<D> core_;
  double radius_;
};

/// Positions nearer than the radius to the line from a to b, m: a cylinder with half balls at its ends; in
/// the plane a strip with round ends.
template <std::size_t D>
class Capsule {
 public:
  using Place = Vec<double, static_cast<int>(D)>;

  /// Throws `error` unless both ends are finite and the radius positive.
  Capsule(const std::array<double, D>& a, const std::array<double, D>& b, double radius)
      : a_{detail::finite_place("Capsule.a", a)},
        along_{detail::finite_place("Capsule.b", b) - a_},
        radius_{radius} {
    require(radius > 0 && std::isfinite(radius), "Capsule.radius", radius, "must be positive");
  }
  Capsule(const double (&a)[D], const double (&b)[D], double radius)
      : Capsule(std::to_array(a), std::to_array(b), radius) {}

  bool contains(const Place& x) const { return (*this)(x) < 0; }
  double operator()(const Place& x) const {
    const double length2 = along_.squaredNorm();
    const double t = length2 > 0 ? std::clamp((x - a_).dot(along_) / length2, 0.0, 1.0) : 0;
    return (x - a_ - t * along_).norm() - radius_;
  }
  Box<D> bounds() const {
    Box<D> box;
    for (std::size_t k = 0; k < D; ++k) {
      const double from = a_[static_cast<int>(k)], to = from + along_[static_cast<int>(k)];
      box.lower[k] = std::min(from, to) - radius_;
      box.upper[k] = std::max(from, to) + radius_;
    }
    return box;
  }
  /// Both ends, and in space the line between them.
  std::vector<ContactSegment> contact_segments() const {
    const auto a = detail::padded(a_), b = detail::padded(Place(a_ + along_));
    std::vector<ContactSegment> all{{a, a, radius_}, {b, b, radius_}};
    if constexpr (D == 3) all.push_back({a, b, radius_});
    return all;
  }

 private:
  Place a_, along_;
  double radius_;
};

/// Circular cylinder in space, with flat ends at a and b on its axis, m.
template <std::size_t D>
class Cylinder {
 public:
  static_assert(D == 3, "Cylinder: a and b are {x, y, z}; in the plane take a Box, or a Capsule");
  using Place = Vec<double, static_cast<int>(D)>;

  /// Throws `error` unless the ends are finite and apart, and the radius positive.
  Cylinder(const std::array<double, D>& a, const std::array<double, D>& b, double radius) : radius_{radius} {
    require(radius > 0 && std::isfinite(radius), "Cylinder.radius", radius, "must be positive");
    const Place from = detail::finite_place("Cylinder.a", a), to = detail::finite_place("Cylinder.b", b);
    require((to - from).norm() > 0, "Cylinder.b", vector_text(to), "must not be a");
    middle_ = (from + to) / 2;
    half_ = (to - from).norm() / 2;
    axis_ = (to - from).normalized();
  }

  Cylinder(const double (&a)[D], const double (&b)[D], double radius)
      : Cylinder(std::to_array(a), std::to_array(b), radius) {}

  bool contains(const Place& x) const { return (*this)(x) < 0; }
  double operator()(const Place& x) const {
    const double along = (x - middle_).dot(axis_);
    const double beside = (x - middle_ - along * axis_).norm() - radius_, beyond = std::abs(along) - half_;
    if (beside > 0 && beyond > 0) return std::hypot(beside, beyond);
    return std::max(beside, beyond);
  }
  Box<3> bounds() const {
    Box<3> box;
    for (int k = 0; k < 3; ++k) {
      const double reach =
          half_ * std::abs(axis_[k]) + radius_ * std::sqrt(std::max(0.0, 1 - axis_[k] * axis_[k]));
      box.lower[static_cast<std::size_t>(k)] = middle_[k] - reach;
      box.upper[static_cast<std::size_t>(k)] = middle_[k] + reach;
    }
    return box;
  }
  /// Of a prism with 32 sides within it: both rims lie up to 0.5 % of the radius too far inside.
  std::vector<ContactSegment> contact_segments() const {
    constexpr int sides = 32;
    const Place beside = axis_.unitOrthogonal(), across = axis_.cross(beside);
    std::vector<ContactSegment> all;
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * pi * k / sides;
      const Place out = radius_ * (std::cos(angle) * beside + std::sin(angle) * across);
      const auto a = detail::padded(Place(middle_ - half_ * axis_ + out));
      const auto b = detail::padded(Place(middle_ + half_ * axis_ + out));
      all.insert(all.end(), {{a, a, 0}, {b, b, 0}, {a, b, 0}});
    }
    return all;
  }

 private:
  Place middle_, axis_;
  double half_, radius_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
