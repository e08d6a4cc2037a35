// Half-sections of penetrometers, each kind with the same members. All are those of the contact surface, the
// penetrometer's own or parallel to it at an offset, from its own tip at (0, 0) upward. Sharp edges stay sharp (faces are
// extended until they intersect), rounded ones take the offset up in their radius.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <arenite/core/units.hpp>

#include "parabola.hpp"
#include "profile.hpp"

namespace arenite::ffp {

/// Size of the penetrometer. Defaults: the published BlueDrop with a sharp cone.
struct DeviceShape {
  double radius = 0.04375;      ///< m
  double length = 0.631;        ///< m, tip to top
  double apex = 60 * pi / 180;  ///< whole angle of the cone, rad
  double flat = 0;      ///< radius of the flat end that cuts the cone, m; 0: sharp; the device's: no cone
  double parabola = 0;  ///< m: the tip is r^2 = parabola x height, in the place of a cone; 0: a cone
  double fillet = 0;    ///< radius of the rounded edge between cone and cylinder, m; 0: sharp
  /// Distance from the penetrometer's surface outward to the contact surface, m; negative: inward.
  double offset = 0;
  std::optional<ProfileLine>
      profile{};  ///< in the place of a tip on a cylinder; the sizes above then say nothing
};

/// A tip on a cylinder, whatever the tip: what cones and parabolas share.
class CylinderSection {
 public:
  double radius() const { return s_.radius + s_.offset; }
  double length() const { return s_.length + tip_above_ + s_.offset; }
  double tip_above() const { return tip_above_; }
  double flat_radius() const { return flat_; }
  /// Height at which cone (or parabola) and cylinder join, or would without a fillet, m; 0: no cone.
  double cone_height() const { return cone_height_; }

 protected:
  explicit CylinderSection(const DeviceShape& shape) : s_{shape} {}

  DeviceShape s_;
  double flat_ = 0, cone_height_ = 0, tip_above_ = 0;
};

/// A flat end, a cone, an optional fillet that touches cone and cylinder, a cylinder.
class ConeSection : public CylinderSection {
 public:
  explicit ConeSection(const DeviceShape& shape);

  /// Angle between axis and cone, rad.
  double half_angle() const { return s_.apex / 2; }
  /// Heights at which the rounded edge leaves the cone and joins the cylinder, m; both the cone's height if
  /// sharp.
  double fillet_start() const { return cone_height() - tangent() * std::cos(half_angle()); }
  double fillet_end() const { return cone_height() + tangent(); }

  double tip_end() const { return fillet_end(); }
  double profile(double y) const;
  double rise(double y) const;
  std::vector<double> marks(double shortest) const;
  std::vector<Point2> tip_line() const;
  double mantle_area(double depth) const;
  double widest_below(double y) const { return profile(y); }

 private:
  double tangent() const { return fillet_ * std::tan(half_angle() / 2); }

  double fillet_ = 0;
};

/// A parabola r^2 = k y that ends in a cylinder.
class ParabolaSection : public CylinderSection {
 public:
  explicit ParabolaSection(const DeviceShape& shape);

  double tip_end() const { return cone_height(); }
  double profile(double y) const;
  double rise(double y) const;
  std::vector<double> marks(double) const { return {cone_height()}; }
  std::vector<Point2> tip_line() const;
  double mantle_area(double depth) const;
  double widest_below(double y) const { return profile(y); }

 private:
  ParallelParabola parabola_;
  double edge_;  ///< place of the parabola at which the cylinder begins
};

/// Any outline of lines and arcs, whose radius may shrink again.
class ProfileSection {
 public:
  explicit ProfileSection(const DeviceShape& shape);

  double radius() const { return widest_; }
  double length() const { return corners_.back().at[1]; }
  double tip_above() const { return tip_above_; }
  double flat_radius() const;
  double tip_end() const;
  double profile(double y) const;
  double rise(double y) const;
  std::vector<double> marks(double shortest) const;
  std::vector<Point2> tip_line() const;
  double mantle_area(double depth) const;
  /// The largest radius up to a height, m.
  double widest_below(double y) const;

 private:
  std::size_t piece_at(double y) const;

  std::vector<ProfileCorner> corners_;
  double tip_above_ = 0, widest_ = 0;
};

}  // namespace arenite::ffp
