// The shapes of the drop: the penetrometer (a cylinder with a tip) and the chamber of sand. Tip at the
// origin at t = 0, y up along the axis, r the distance from the axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <arenite/core/error.hpp>
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
  explicit Device(const DeviceShape& shape) : s_{shape} {
    require(s_.radius > 0, "Device.radius", s_.radius, "must be positive");
    require(s_.apex > 0 && s_.apex < pi, "Device.apex", s_.apex, "must lie in (0, pi)");
    require(s_.flat >= 0 && s_.flat <= s_.radius, "Device.flat", s_.flat,
            "must lie between 0 and the radius of the cylinder");
    require(s_.parabola >= 0 && (s_.parabola == 0 || (s_.flat == 0 && s_.fillet == 0)), "Device.parabola",
            s_.parabola, "must be at least 0, and goes without a flat end and a fillet");
    require(radius() > 0, "Device.offset", s_.offset, "must leave something of the cylinder");
    s_.parabola > 0 ? set_parabola() : set_cone();
    require(length() > cone_height(), "Device.length", s_.length,
            "must be greater than the height of the cone");
    require(s_.fillet >= 0 &&
                (s_.fillet == 0 || (s_.flat < s_.radius && fillet_start() > 0 && fillet_end() < length())),
            "Device.fillet", s_.fillet,
            "must be at least 0, and the rounded edge must fit between tip and top");
  }

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
  double profile(double y) const {
    if (y < 0) return 0;
    if (y == 0) return flat_;
    if (y < fillet_start()) return tip_radius(y);
    if (y >= fillet_end()) return radius();
    const double below = fillet_end() - y;  // centre of the rounding: (radius - fillet, fillet_end)
    return radius() - fillet_ + std::sqrt(fillet_ * fillet_ - below * below);
  }

  /// Share of a piece of the tip's line that rises at the height y in [0, cone height], dy / ds.
  double rise(double y) const {
    return parabola_ ? parabola_->rise(parabola_->at_height(y - tip_above())) : std::cos(half_angle());
  }

  /// Heights of the corners that a mesh gives the rounded edge, m, ascending: facets of equal angle, none
  /// shorter than `shortest`, m. An edge too short for one facet keeps one corner, at the middle of the
  /// rounding; a sharp edge its own.
  std::vector<double> edge_heights(double shortest) const {
    if (!(fillet_ > 0)) return {cone_height()};
    const auto at = [&](double share) {
      return fillet_end() - fillet_ * std::sin(half_angle() * (1 - share));
    };
    const int facets = static_cast<int>(fillet_ * half_angle() / shortest + 1e-9);
    if (facets < 1) return {at(0.5)};
    std::vector<double> y;
    for (int k = 0; k <= facets; ++k) y.push_back(at(static_cast<double>(k) / facets));
    return y;
  }

  /// Half-section as a line from the tip over the shoulder to the axis at the top, the rounded edge in 8
  /// facets, a parabola in 64.
  std::vector<Point2> outline() const {
    constexpr int pieces = 64;
    std::vector<Point2> line{{0, 0}};
    if (flat_ > 0) line.emplace_back(flat_, 0);
    if (parabola_)
      for (int k = 1; k < pieces; ++k) {
        const double p = parabola_->start() + (edge_ - parabola_->start()) * k / pieces;
        line.emplace_back(parabola_->radius(p), parabola_->height(p) + tip_above());
      }
    if (flat_ < radius())
      for (const double y : edge_heights(fillet_ * half_angle() / 8)) line.emplace_back(profile(y), y);
    line.emplace_back(radius(), length());
    line.emplace_back(0, length());
    return line;
  }

  /// Volume inside this surface, m^3, of the outline turned about the axis.
  double volume() const {
    double v = 0;
    const auto line = outline();
    for (std::size_t k = 1; k < line.size(); ++k) {
      const double a = line[k - 1][0], b = line[k][0], h = line[k][1] - line[k - 1][1];
      v += pi / 3 * (a * a + a * b + b * b) * h;  // a frustum
    }
    return v;
  }

  /// The penetrometer itself: this one without offset.
  Device instrument() const {
    DeviceShape shape = s_;
    shape.offset = 0;
    return Device{shape};
  }

  /// Area of the section of the penetrometer (without offset) at the surface of the ground, m^2, with its tip
  /// at `depth` below it, m: 0 above the ground, the cylinder's once the tip is covered. The area of a part
  /// in the ground, projected along the axis.
  double projected_area(double depth) const {
    const double r = instrument().profile(depth);
    return pi * r * r;
  }

  /// Area of the tip's own surface (without offset) in the ground, m^2, with the tip at `depth` below the
  /// ground's surface, m: flat end, cone or parabola, and rounded edge, up to where the cylinder begins. It
  /// is pi r sqrt(r^2 + depth^2) of a sharp cone; the side of the cylinder does not count.
  double mantle_area(double depth) const {
    const Device body = instrument();
    const double r = body.profile(std::min(depth, body.fillet_start()));
    if (depth < 0) return 0;
    if (parabola_) {
      const double slope = 2 * r / s_.parabola;
      return pi * s_.parabola * s_.parabola / 6 * (std::pow(1 + slope * slope, 1.5) - 1);
    }
    double area = pi * s_.flat * s_.flat;
    area += pi * (r * r - s_.flat * s_.flat) / std::sin(half_angle());
    if (depth > body.fillet_start() && s_.fillet > 0) {  // a zone of the torus
      const double below = std::max(0.0, body.fillet_end() - depth), turned = std::asin(below / s_.fillet);
      area +=
          2 * pi * s_.fillet *
          ((s_.radius - s_.fillet) * (half_angle() - turned) + s_.fillet * std::sin(half_angle()) - below);
    }
    return area;
  }

 private:
  double tangent() const { return fillet_ * std::tan(half_angle() / 2); }
  double tip_radius(double y) const {
    if (parabola_) return parabola_->radius(parabola_->at_height(y - tip_above()));
    return flat_ + y * std::tan(half_angle());
  }

  void set_cone() {
    const double a = half_angle(), apex = s_.flat / std::tan(a) + s_.offset / std::sin(a);
    const double cut = s_.flat + s_.offset * (1 - std::sin(a)) / std::cos(a);  // by the flat end's plane
    const bool blunt = s_.flat == s_.radius;
    flat_ = blunt ? radius() : s_.flat > 0 ? std::clamp(cut, 0.0, radius()) : 0;
    tip_above_ = flat_ > 0 ? s_.offset : apex;
    fillet_ = s_.fillet > 0 ? std::max(0.0, s_.fillet + s_.offset) : 0;
    cone_height_ = (radius() - flat_) / std::tan(a);
  }
  void set_parabola() {
    parabola_.emplace(s_.parabola, s_.offset);
    tip_above_ = -parabola_->height(parabola_->start());
    edge_ = parabola_->at_radius(radius());
    cone_height_ = parabola_->height(edge_) + tip_above_;
  }

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
