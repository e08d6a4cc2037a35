// Points at which two rigid bodies touch or soon may: the corners and edges of one against the signed
// distance of the other.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <arenite/geometry/signed_distance.hpp>
#include <arenite/rigid/body/pose.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A rigid body as others touch it. Its own frame is that of the scene at the start.
template <int D>
struct TouchingBody {
  std::string name{};
  const AnyDistance* distance = nullptr;
  const std::vector<ContactSegment>* segments = nullptr;
  double size = 0;  ///< least extent of the shape, m; infinite if not known
  enum class Kind { driven, with_mass, wall, smooth_wall } kind = Kind::with_mass;
  Pose<D> begin{}, end{};
  Twist<double, D> twist = Twist<double, D>::Zero();  ///< at the end of the step
  /// Change of the twist by an impulse and its moment.
  Mat<double, D + rotations<D>> mobility = Mat<double, D + rotations<D>>::Zero();
  Twist<double, D> impulse = Twist<double, D>::Zero();  ///< of the other rigid bodies in the step

  Vec<double, D> centre() const { return begin.centre + begin.displacement; }
  bool moves() const { return !mobility.isZero(0); }
  bool is_wall() const { return kind == Kind::wall || kind == Kind::smooth_wall; }
  /// Greatest speed of its points, m/s, within `reach` from the centre.
  double speed(double reach) const {
    return linear_part<D>(twist).norm() + angular_part<D>(twist).norm() * reach;
  }
};

/// One point at which a body touches another, or may within the step.
template <int D>
struct RigidTouch {
  std::size_t first, second;  ///< numbers of the bodies; a corner or edge of the first one
  Vec<double, D> own;         ///< centre of its rounding, in the first body's frame, m
  double radius;              ///< m
  Vec<double, D> place;       ///< of the first body's surface at the start of the step, m
  Vec<double, D> normal;      ///< out of the second body
  double gap;                 ///< at the start of the step, m; negative where they overlap
  double end_gap = 0;         ///< at its end, m
  Vec<double, D> impulse = Vec<double, D>::Zero();  ///< on the first body, N s
};

template <int D>
class ContactPoints {
 public:
  using V = Vec<double, D>;
  using Bodies = std::vector<TouchingBody<D>>;
  using Touches = std::vector<RigidTouch<D>>;

  /// All points of the first body nearer than `margin`, m, to the second, at the start of the step.
  static void find(const Bodies& bodies, std::size_t first, std::size_t second, double margin,
                   Touches& touches) {
    const auto &a = bodies[first], &b = bodies[second];
    for (const ContactSegment& s : *a.segments) {
      const V from = at_begin(a, b, s.a), to = at_begin(a, b, s.b);
      if (is_beyond(*b.distance, from, to, margin + s.radius)) continue;
      const auto touch = [&](double share) {
        const V own = in_plane(s.a) + share * (in_plane(s.b) - in_plane(s.a));
        add(bodies, {first, second, own, s.radius, V::Zero(), V::Zero(), 0}, margin, touches);
      };
      if ((to - from).squaredNorm() == 0)
        touch(0);
      else
        touch_along(*b.distance, from, to, margin + s.radius, 1e-5 * std::min(a.size, b.size), touch);
    }
  }

  /// Gap with the bodies where they are at the end of the step.
  static double end_gap(const Bodies& bodies, const RigidTouch<D>& t) {
    const auto &a = bodies[t.first], &b = bodies[t.second];
    const V x = b.end.to_body(in_scene(a.end, t.own));
    const double gap = at(*b.distance, x) - t.radius;
    const V before = in_scene(a.begin, t.own), on_second = b.begin.to_body(before);
    const V way = in_scene(a.end, t.own) - in_scene(b.end, on_second);
    const double straight = t.gap + way.dot(t.normal);
    if (gap <= straight || straight >= 0) return gap;
    // Along a curved face, past an edge, or along another face (equal boxes side by side) and through the
    // body?
    const double facing = b.end.to_scene(slope(*b.distance, x, step_of(a, b))).dot(t.normal);
    const bool past = facing >= 0 && gap > 1e-3 * std::min(a.size, b.size);
    return facing >= 0.5 || past ? gap : straight;
  }

 private:
  static V in_plane(const std::array<double, 3>& x) {
    if constexpr (D == 2)
      return {x[0], x[1]};
    else
      return {x[0], x[1], x[2]};
  }
  static V in_scene(const Pose<D>& pose, const V& own) {
    return pose.centre + pose.displacement + pose.rotation * (own - pose.centre);
  }
  /// In the frame of b.
  static V at_begin(const TouchingBody<D>& a, const TouchingBody<D>& b, const std::array<double, 3>& x) {
    return b.begin.to_body(in_scene(a.begin, in_plane(x)));
  }
  static double at(const AnyDistance& distance, const V& x) {
    const auto place = in_space<double, D>(x);
    double d;
    distance.at({&place, 1}, &d);
    if (std::isnan(d)) throw run_error(refused_distance(place, d));
    return d;
  }
  static double step_of(const TouchingBody<D>& a, const TouchingBody<D>& b) {
    return 1e-5 * std::min(a.size, b.size);
  }
  /// Central differences, not normalised.
  static V slope(const AnyDistance& distance, const V& x, double h) {
    const auto place = in_space<double, D>(x);
    const V g = in_plane(distance.differences<D>(place, h)) / (2 * h);
    if (g.hasNaN()) throw run_error(refused_distance(place, std::numeric_limits<double>::quiet_NaN()));
    return g;
  }
  static bool is_beyond(const AnyDistance& distance, const V& from, const V& to, double distant) {
    for (int i = 0; i < D; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (std::max(from[i], to[i]) < distance.lower()[k] - distant ||
          std::min(from[i], to[i]) > distance.upper()[k] + distant)
        return true;
    }
    return false;
  }

  /// Calls `touch(share)` for the share of the way from one position to another that comes nearest, or for
  /// both ends of the part that is as near but for `flat`, m; not for its own ends, which are corners. The
  /// distance along the way is taken to be convex.
  template <class Touch>
  static void touch_along(const AnyDistance& distance, const V& from, const V& to, double distant,
                          double flat, Touch&& touch) {
    const auto along = [&](double share) { return at(distance, from + share * (to - from)); };
    const double length = (to - from).norm();
    if (along(0.5) > distant + length / 2) return;
    constexpr double golden = 0.6180339887498949;
    double low = 0, high = 1, left = 1 - golden, right = golden, at_left = along(left),
           at_right = along(right);
    for (int k = 0; k < 45; ++k) {
      if (at_left <= at_right) {
        high = right;
        right = left, at_right = at_left;
        left = high - golden * (high - low);
        at_left = along(left);
      } else {
        low = left;
        left = right, at_left = at_right;
        right = low + golden * (high - low);
        at_right = along(right);
      }
    }
    const double nearest = (low + high) / 2, least = along(nearest), most = least + flat;
    if (least > distant) return;
    const auto end_towards = [&](double end) {
      if (along(end) <= most) return end;
      double in = nearest, out = end;
      for (int k = 0; k < 45; ++k) (along((in + out) / 2) <= most ? in : out) = (in + out) / 2;
      return in;
    };
    const double begin = end_towards(0), end = end_towards(1), middle = (begin + end) / 2;
    if ((end - begin) * length <= 1e3 * flat) {
      if (least < std::min(along(0), along(1)) - 1e-3 * flat) touch(middle);
    } else {
      // Not beyond the edge of a face on which the segment lies, nor near its other faces.
      if (begin > 0) touch(begin + 100 * flat / length);
      if (end < 1) touch(end - 100 * flat / length);
    }
  }

  /// Completes a touch and adds it, unless it is too far away, has no normal, or is there already.
  static void add(const Bodies& bodies, RigidTouch<D> t, double margin, Touches& touches) {
    const auto &a = bodies[t.first], &b = bodies[t.second];
    const V centre = in_scene(a.begin, t.own), x = b.begin.to_body(centre);
    t.gap = at(*b.distance, x) - t.radius;
    if (!(t.gap <= margin)) return;
    const double h = step_of(a, b);
    V n = slope(*b.distance, x, h);
    if (std::abs(n.norm() - 1) > 1e-3) {
      // At a corner or an edge of the second body: as a little farther inside of the first one.
      V inwards = middle(a) - centre;
      if (!(inwards.norm() > 0)) return;
      inwards *= 1e-3 * std::min(a.size, b.size) / inwards.norm();
      n = slope(*b.distance, b.begin.to_body(centre + inwards), h);
    }
    if (!(n.norm() > 0.5)) return;
    t.normal = b.begin.to_scene(n.normalized());
    t.place = centre - t.radius * t.normal;
    // Of two balls each finds the other: the same point on the surface of the second body.
    const V across = t.place - t.gap * t.normal;
    const double close = 1e-5 * std::min(a.size, b.size);
    const auto is_same = [&](const RigidTouch<D>& other) {
      if (other.first == t.first && other.second == t.second) return (other.place - t.place).norm() <= close;
      return other.first == t.second && other.second == t.first &&
             (other.place - across).norm() <= 300 * close && other.normal.dot(t.normal) < -1 + 1e-4;
    };
    if (std::any_of(touches.begin(), touches.end(), is_same)) return;
    touches.push_back(t);
  }
  /// Middle of the box around a body, in the scene at the start of the step.
  static V middle(const TouchingBody<D>& a) {
    V m;
    for (int i = 0; i < D; ++i) {
      const auto k = static_cast<std::size_t>(i);
      m[i] = (a.distance->lower()[k] + a.distance->upper()[k]) / 2;
    }
    return in_scene(a.begin, m);
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
