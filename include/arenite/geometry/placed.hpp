// A shape moved and turned.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/geometry/contact_segment.hpp>
#include <arenite/geometry/shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// How `placed` moves a shape: turned about its origin, then the origin moved to `at`.
struct Placement {
  std::array<double, 3> at{};      ///< m
  std::array<double, 3> turned{};  ///< rotation vector: axis times angle, rad; in the plane {0, 0, angle}
};

/// A shape at another place. As exact as the shape.
template <class Shape>
class Placed {
 public:
  /// Throws `error` unless the placement is finite.
  Placed(Shape shape, const Placement& p)
      : shape_{std::move(shape)},
        at_{vector_argument<double, 3>("Placement.at", p.at)},
        turn_{rotation(vector_argument<double, 3>("Placement.turned", p.turned))},
        is_plane_{p.at[2] == 0 && p.turned[0] == 0 && p.turned[1] == 0} {}

  template <int D>
  requires(signed_distance<Shape, D>) double operator()(const Vec<double, D>& x) const {
    return shape_(own_place(x));
  }
  template <int D>
  bool contains(const Vec<double, D>& x) const requires requires(const Shape s) {
    s.contains(x);
  }
  { return shape_.contains(own_place(x)); }

  template <int D>
  Box<std::size_t{D}> bounds() const {
    return moved_box<D>(bounds_of<D>(shape_), turn_.template topLeftCorner<D, D>(), at_.template head<D>());
  }
  template <int D>
  requires(has_contact_segments<Shape, D>) std::vector<ContactSegment> contact_segments()
  const {
    auto all = contact_segments_of<D>(shape_);
    for (auto& s : all) {
      s.a = moved(s.a);
      s.b = moved(s.b);
    }
    return all;
  }

 private:
  std::array<double, 3> moved(const std::array<double, 3>& x) const {
    const auto y = moved(Vec<double, 3>(x[0], x[1], x[2]), turn_);
    return {y[0], y[1], y[2]};
  }
  // Templates over the scalar, so that only programs that place a shape instantiate these expressions.
  template <class Real>
  Vec<Real, 3> moved(const Vec<Real, 3>& x, const Mat<Real, 3>& turn) const {
    return turn * x + at_;
  }
  /// Rodrigues' formula.
  template <class Real>
  static Mat<Real, 3> rotation(const Vec<Real, 3>& vector) {
    const Real angle = vector.norm();
    if (angle == 0) return Mat<Real, 3>::Identity();
    const Vec<Real, 3> n = vector / angle;
    Mat<Real, 3> cross;
    cross << 0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0;
    return Mat<Real, 3>::Identity() + std::sin(angle) * cross + (1 - std::cos(angle)) * cross * cross;
  }

  template <int D>
  Vec<double, D> own_place(const Vec<double, D>& x) const {
    if constexpr (D == 2)
      require(is_plane_, "Placement", vector_text(at_), "must move and turn a plane shape in its plane");
    return turn_.template topLeftCorner<D, D>().transpose() * (x - at_.template head<D>());
  }

  Shape shape_;
  Vec<double, 3> at_;
  Mat<double, 3> turn_;
  bool is_plane_;
};

/// `placed(Box<2>{{-1, 0}, {1, 2}}, {.at = {3, 0, 0}, .turned = {0, 0, 30_deg}})`.
template <class Shape>
Placed<Shape> placed(Shape shape, const Placement& p) {
  return {std::move(shape), p};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
