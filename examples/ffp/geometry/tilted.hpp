// The penetrometer in space: a section turned about its axis, and where a tilted one begins.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <arenite/core/tensor.hpp>
#include <arenite/geometry/placed.hpp>
#include <arenite/geometry/polygon.hpp>

#include "geometry.hpp"

namespace arenite::ffp {

/// The section of the penetrometer on both sides of the axis, which is then no surface.
inline Polygon whole_section(const Device& body) {
  std::vector<Polygon::Corner> corners;
  const auto half = body.outline();
  for (const Point2& x : half) corners.push_back({x[0], x[1]});
  for (std::size_t k = half.size(); k-- > 0;)
    if (half[k][0] > 0) corners.push_back({-half[k][0], half[k][1]});
  return Polygon{corners};
}

/// Signed distance of a section turned about the y axis.
class TurnedSection {
 public:
  /// `section`: both sides of the axis, symmetric.
  explicit TurnedSection(Polygon section) : section_{std::move(section)} {}

  double operator()(const Vec<double, 3>& x) const {
    return section_(Vec<double, 2>(std::hypot(x[0], x[2]), x[1]));
  }
  Box<3> bounds() const {
    const auto& [r, top] = section_.upper;
    return {{-r, section_.lower[1], -r}, {r, top, r}};
  }

 private:
  Polygon section_;
};

/// The penetrometer as it touches the sand, the lowest point of its contact surface at y = 0. It is
/// tilted about z: its tip points to +x.
struct DeviceStart {
  double tilt = 0;                              ///< of the axis to the vertical, rad
  double lift = 0;                              ///< height of the end of that surface's own axis, m
  Vec<double, 3> tip = Vec<double, 3>::Zero();  ///< of the penetrometer, m

  DeviceStart(const Device& body, double tilt_) : tilt{tilt_} {
    for (const Point2& x : body.outline())
      lift = std::max(lift, x[0] * std::sin(tilt) - x[1] * std::cos(tilt));
    tip = Vec<double, 3>(0, lift, 0) + body.tip_above() * axis();
  }
  /// From the tip upward.
  Vec<double, 3> axis() const { return {-std::sin(tilt), std::cos(tilt), 0}; }
  Placement placement() const { return {.at = {0, lift, 0}, .turned = {0, 0, tilt}}; }
};

}  // namespace arenite::ffp
