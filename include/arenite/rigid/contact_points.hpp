// Points at which two rigid bodies touch or soon may: the corners and edges of one against the signed
// distance of the other.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <string>
#include <vector>

#include <arenite/rigid/pose.hpp>
#include <arenite/rigid/signed_distance.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A rigid body as others touch it. Its own frame is that of the scene at the start.
template <int D>
struct TouchingBody {
  std::string name{};
  const AnyDistance* distance = nullptr;
  const std::vector<ContactSegment>* segments = nullptr;
  double size = 0;  ///< least extent of the shape, m; infinite if not known
  Pose<D> begin{}, end{};
  Twist<double, D> twist{};                             ///< at the end of the step
  Mat<double, D + rotations<D>> mobility{};             ///< change of the twist by an impulse and its moment
  Twist<double, D> impulse = Twist<double, D>::Zero();  ///< of the other rigid bodies in the step

  Vec<double, D> centre() const { return begin.centre + begin.displacement; }
  bool moves() const { return !mobility.isZero(0); }
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

/// All points of the first body nearer than `margin`, m, to the second, at the start of the step.
template <int D>
void find_touches(const std::vector<TouchingBody<D>>& bodies, std::size_t first, std::size_t second,
                  double margin, std::vector<RigidTouch<D>>& touches);

/// Gap with the bodies where they are at the end of the step.
template <int D>
double end_gap(const std::vector<TouchingBody<D>>& bodies, const RigidTouch<D>& touch);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/contact_points_cold.hpp>
#endif
