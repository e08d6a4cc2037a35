// Pose of a rigid body: where its centre is and how it is turned.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/Geometry>
#include <cmath>

#include <arenite/core/tensor.hpp>
#include <arenite/rigid/body/twist.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// How a body is turned against its start. In the plane an angle, rad, that counts whole turns; in space a
/// unit quaternion (w, x, y, z).
template <int D>
class Orientation {
  using Parts = Vec<double, D == 2 ? 1 : 4>;

 public:
  using Quaternion = Eigen::Quaternion<typename Parts::Scalar, Eigen::DontAlign>;

  /// Turns by a rotation vector in space, rad; in the plane by an angle.
  void turn(const Spin<double, D>& by) {
    if constexpr (D == 2) {
      parts_ += by;
    } else {
      const double angle = by.norm();
      if (angle > 0)
        set(Quaternion(Eigen::AngleAxis<typename Parts::Scalar>(angle, by / angle)) * quaternion());
    }
  }
  /// Turns by the Cayley transform of a vector in the body's own frame: by the angle 2 atan(|a| / 2).
  void turn_by_cayley(const Vec<double, 3>& a) requires(D == 3) {
    set(quaternion() * Quaternion(1, a[0] / 2, a[1] / 2, a[2] / 2));
  }
  double angle() const requires(D == 2) { return parts_[0]; }
  Quaternion quaternion() const requires(D == 3) { return {parts_[0], parts_[1], parts_[2], parts_[3]}; }
  /// Axis times angle of the turn since the start, rad; in space at most pi long.
  Spin<double, D> rotation_vector() const {
    if constexpr (D == 2) {
      return parts_;
    } else {
      const Spin<double, D> axis = (parts_[0] < 0 ? -1 : 1) * parts_.template tail<3>();
      const double sine = axis.norm();
      if (sine == 0) return Spin<double, D>::Zero();
      return (2 * std::atan2(sine, std::abs(parts_[0])) / sine) * axis;
    }
  }
  /// From the body's frame to that of the scene.
  Mat<double, D> matrix() const {
    if constexpr (D == 2) {
      const double c = std::cos(parts_[0]), s = std::sin(parts_[0]);
      Mat<double, D> m;
      m << c, -s, s, c;
      return m;
    } else {
      return quaternion().toRotationMatrix();
    }
  }
  template <class F>
  void visit_state(F&& f) {
    f("orientation", parts_);
  }

 private:
  void set(const Quaternion& q) { parts_ = Parts(q.w(), q.x(), q.y(), q.z()).normalized(); }

  static Parts start() {
    Parts parts = Parts::Zero();
    if (D == 3) parts[0] = 1;
    return parts;
  }

  Parts parts_ = start();
};

/// Where a body is now, for its surface: the body's own frame is that of the scene at the start.
template <int D>
struct Pose {
  Vec<double, D> centre;        ///< at the start, m
  Vec<double, D> displacement;  ///< of the centre since the start, m
  Mat<double, D> rotation;      ///< from the body's frame to that of the scene

  /// Position in the body's frame of one in the scene, m.
  Vec<double, D> to_body(const Vec<double, D>& x) const {
    return centre + rotation.transpose() * (x - displacement - centre);
  }
  /// Direction in the scene of one in the body's frame.
  Vec<double, D> to_scene(const Vec<double, D>& direction) const { return rotation * direction; }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
