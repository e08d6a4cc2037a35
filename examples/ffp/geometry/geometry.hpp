// The shapes of the drop: the penetrometer (a cylinder with a tip) and the chamber of sand. Tip at the
// origin at t = 0, y up along the axis, r the distance from the axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <arenite/core/tensor.hpp>
#include <arenite/core/units.hpp>

#include "parabola.hpp"

namespace arenite::ffp {

/// Point of a half-section: (r, y), m.
using Point2 = Vec<double, 2>;

/// The chamber of the experiment. The sand lies from -`soil_depth` to 0, the model ends `headroom` above the
/// sand.
struct Chamber {
  double radius = 0.4;      ///< m
  double soil_depth = 0.4;  ///< m
  double headroom = 0.7;    ///< m, above the surface of the sand: the model is 1.1 m high
};

/// The chamber in proportion to a penetrometer: as many diameters wide and deep as the experiment's, and its headroom above it.
Chamber chamber_for(double diameter, double length);

/// Size of the penetrometer. Defaults: the published BlueDrop with a sharp cone.
struct DeviceShape {
  double radius = 0.04375;      ///< m
  double length = 0.631;        ///< m, tip to top
  double apex = 60 * pi / 180;  ///< whole angle of the cone, rad
  double flat = 0;      ///< radius of the flat end that cuts the cone, m; 0: sharp; the device's: no cone
  double parabola = 0;  ///< m: the tip is r^2 = parabola x height, in the place of a cone; 0: a cone
  double fillet = 0;    ///< radius of the rounded edge between cone and cylinder, m; 0: sharp
  /// Distance from the penetrometer's surface outward to the one that the sand meets, m; negative: inward.
  double offset = 0;
};

/// Half-section of the surface that the sand meets, from its own tip at (0, 0): a flat end, a cone or a
/// parabola, an optional fillet that touches cone and cylinder, a cylinder, a flat top. It is the
/// penetrometer's, or parallel to it at the shape's offset: edges that are sharp stay sharp (faces are
/// extended until they meet), rounded ones take the offset up in their radius.
class Device {
 public:
  /// Throws `error` if the parts do not fit together.
  explicit Device(const DeviceShape& shape);

  double radius() const { return s_.radius + s_.offset; }
  double length() const { return s_.length + tip_above() + s_.offset; }
  /// Angle between axis and cone, rad.
  double half_angle() const { return s_.apex / 2; }
  /// Radius of the flat end, m; 0: none.
  double flat_radius() const { return flat_; }
  /// Height at which cone (or parabola) and cylinder meet, or would without a fillet, m; 0: no cone.
  double cone_height() const { return cone_height_; }
  /// Height of the penetrometer's tip above that of this surface, m: 0 without offset. The offset where the
  /// tip is flat or round, offset / sin(half angle) where it is a sharp cone's. Penetration is that of the
  /// penetrometer's tip, so that it starts at minus this height when the surface touches the sand.
  double tip_above() const { return tip_above_; }
  /// Heights at which the rounded edge leaves the cone and joins the cylinder, m; both the cone's height if
  /// sharp.
  double fillet_start() const { return cone_height() - tangent() * std::cos(half_angle()); }
  double fillet_end() const { return cone_height() + tangent(); }

  /// Radius at the height y above the tip, m: 0 below the tip, that of the flat end at the tip; the
  /// cylinder's above its top, too.
  double profile(double y) const;

  /// Share of a piece of the tip's line that rises at the height y in [0, cone height], dy / ds.
  double rise(double y) const {
    return parabola_ ? parabola_->rise(parabola_->at_height(y - tip_above())) : std::cos(half_angle());
  }

  /// Heights of the corners that a mesh gives the rounded edge, m, ascending: facets of equal angle, none
  /// shorter than `shortest`, m. An edge too short for one facet keeps one corner, at the middle of the
  /// rounding; a sharp edge its own.
  std::vector<double> edge_heights(double shortest) const;

  /// Half-section as a line from the tip over the shoulder to the axis at the top, the rounded edge in 8
  /// facets, a parabola in 64.
  std::vector<Point2> outline() const;

  /// Volume inside this surface, m^3, of the outline turned about the axis.
  double volume() const;

  /// The penetrometer itself: this one without offset.
  Device instrument() const {
    DeviceShape shape = s_;
    shape.offset = 0;
    return Device{shape};
  }

  /// Area of the section of the penetrometer (without offset) at the surface of the ground, m^2, with its tip
  /// at `depth` below it, m: 0 above the ground, the cylinder's once the tip is covered. The area of a part
  /// in the ground, projected along the axis.
  double projected_area(double depth) const;

  /// Area of the tip's own surface (without offset) in the ground, m^2, with the tip at `depth` below the
  /// ground's surface, m: flat end, cone or parabola, and rounded edge, up to where the cylinder begins. It
  /// is pi r sqrt(r^2 + depth^2) of a sharp cone; the side of the cylinder does not count.
  double mantle_area(double depth) const;

 private:
  double tangent() const { return fillet_ * std::tan(half_angle() / 2); }
  double tip_radius(double y) const {
    if (parabola_) return parabola_->radius(parabola_->at_height(y - tip_above()));
    return flat_ + y * std::tan(half_angle());
  }

  void set_cone();
  void set_parabola();

  DeviceShape s_;
  std::optional<ParallelParabola> parabola_;  ///< of the surface that the sand meets
  double edge_ = 0;                           ///< place of the parabola at which the cylinder begins
  double flat_ = 0, fillet_ = 0, cone_height_ = 0, tip_above_ = 0;  ///< of the surface that the sand meets
};

/// Share of the device's motion that a node of the mesh makes. The mesh moves as a whole from `moving_depth`
/// below the tip upward; between there and the bottom of the chamber, which stands, it is compressed evenly.
/// y: height of the node at t = 0, m.
inline double motion_factor(double y, double moving_depth, const Chamber& chamber = {}) {
  return std::clamp((y + chamber.soil_depth) / (chamber.soil_depth - moving_depth), 0.0, 1.0);
}

}  // namespace arenite::ffp
