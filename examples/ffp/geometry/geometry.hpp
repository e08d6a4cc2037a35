// The shapes of the drop: the penetrometer (a cylinder with a tip) and the chamber of sand. Tip at the
// origin at t = 0, y up along the axis, r the distance from the axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "sections.hpp"

namespace arenite::ffp {

/// The chamber of the experiment. Heights are above the tip at the start: the sand lies
/// from -`soil_depth` to `embedded`, the model ends at `headroom`.
struct Chamber {
  double radius = 0.4;      ///< m
  double soil_depth = 0.4;  ///< m
  double headroom = 0.7;    ///< m, above the surface of the sand: the model is 1.1 m high
  double embedded = 0;      ///< depth of the device's tip in the ground at the start, m
  double lid = 0;           ///< height of the uppermost ground, a separate region, m; 0: none
};

/// The chamber in proportion to a penetrometer: as many diameters wide and deep as the experiment's, and its headroom above it.
Chamber chamber_for(double diameter, double length);

/// The contact surface of the penetrometer, whose section is one of those in sections.hpp.
class Device {
 public:
  /// Throws `error` if the parts do not fit together.
  explicit Device(const DeviceShape& shape);

  /// The largest radius, m.
  double radius() const;
  double length() const;
  /// Radius of the flat end, m; 0: none.
  double flat_radius() const;
  /// Height of the penetrometer's tip above that of this surface, m: 0 without offset. The offset where the
  /// tip is flat or round, offset / sin(half angle) where it is a sharp cone's. Penetration is that of the
  /// penetrometer's tip, so that it starts at minus this height when the surface touches the sand.
  double tip_above() const;
  /// Height at which the tip ends, m: that of the first cylinder above the first place of the largest radius.
  double tip_end() const;

  /// Radius at the height y above the tip, m: 0 below the tip, that of the flat end at the tip; above the top that of the top.
  double profile(double y) const;

  /// Share of a piece of the section that rises at the height y, dy / ds.
  double rise(double y) const;

  /// Heights at which a mesh must have corners, m, ascending: where pieces of the section join. A rounded edge has facets of equal
  /// angle, none shorter than `shortest`, m, or, too short for one facet, one corner at the middle of the rounding.
  std::vector<double> marks(double shortest) const;

  /// Half-section as a line from the tip over the shoulder to the axis at the top, the rounded edge in 8
  /// facets, a parabola in 64.
  std::vector<Point2> outline() const;

  /// Volume inside this surface, m^3, of the outline turned about the axis.
  double volume() const;

  /// The penetrometer itself: this one without offset.
  Device instrument() const { return Device{without_offset(s_)}; }

  /// Area of the largest section of the penetrometer (without offset) in the ground, m^2, with its tip at
  /// `depth` below the surface, m: 0 above the ground. The area of a part in the ground, projected along the axis.
  double projected_area(double depth) const;

  /// Area of the tip's own surface (without offset) in the ground, m^2, with the tip at `depth` below the
  /// ground's surface, m: flat end, cone or parabola, and rounded edge, up to the first place of the largest radius. It
  /// is pi r sqrt(r^2 + depth^2) of a sharp cone; the side of the cylinder does not count.
  double mantle_area(double depth) const;

 private:
  using Section = std::variant<ConeSection, ParabolaSection, ProfileSection>;
  static Section section_of(const DeviceShape& shape);
  static DeviceShape without_offset(DeviceShape shape) {
    shape.offset = 0;
    return shape;
  }

  DeviceShape s_;
  Section section_, own_;  ///< of the contact surface, and of the penetrometer itself
};

/// Share of the device's motion that a node of the mesh makes. The mesh moves as a whole from `moving_depth`
/// below the tip upward; between there and the bottom of the chamber, which stands, it is compressed evenly.
/// y: height of the node at t = 0, m.
inline double motion_factor(double y, double moving_depth, const Chamber& chamber = {}) {
  return std::clamp((y + chamber.soil_depth) / (chamber.soil_depth - moving_depth), 0.0, 1.0);
}

}  // namespace arenite::ffp
