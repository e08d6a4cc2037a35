// The shapes of the drop: the penetrometer (a cone-tipped cylinder) and the chamber of sand. Tip at the
// origin at t = 0, y up along the axis, r the distance from the axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/core/units.hpp>

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

/// Size of the penetrometer. Defaults: the published BlueDrop.
struct DeviceShape {
  double radius = 0.04375;      ///< m
  double length = 0.631;        ///< m, tip to top
  double apex = 60 * pi / 180;  ///< whole angle of the cone, rad
  double fillet = 0;            ///< radius of the rounded edge between cone and cylinder, m; 0: sharp
};

/// Half-section of the penetrometer: axis, cone, an optional fillet that touches both, cylinder, flat top.
class Device {
 public:
  /// Throws `error` if the parts do not fit together.
  explicit Device(const DeviceShape& shape) : s_{shape} {
    require(s_.radius > 0, "Device.radius", s_.radius, "must be positive");
    require(s_.apex > 0 && s_.apex < pi, "Device.apex", s_.apex, "must lie in (0, pi)");
    require(s_.length > cone_height(), "Device.length", s_.length,
            "must be greater than the height of the cone");
    require(s_.fillet >= 0 && fillet_start() > 0 && fillet_end() < s_.length, "Device.fillet", s_.fillet,
            "must be at least 0, and the rounded edge must fit between tip and top");
  }

  double radius() const { return s_.radius; }
  double length() const { return s_.length; }
  /// Angle between axis and cone, rad.
  double half_angle() const { return s_.apex / 2; }
  /// Height of the sharp cone, m: the height at which cone and cylinder would meet without a fillet.
  double cone_height() const { return s_.radius / std::tan(half_angle()); }
  /// Heights at which the rounded edge leaves the cone and joins the cylinder, m; both the cone's height if
  /// sharp.
  double fillet_start() const { return cone_height() - tangent() * std::cos(half_angle()); }
  double fillet_end() const { return cone_height() + tangent(); }

  /// Radius at the height y above the tip, m: 0 below the tip; the cylinder's above its top, too.
  double profile(double y) const {
    if (y <= 0) return 0;
    if (y < fillet_start()) return y * std::tan(half_angle());
    if (y >= fillet_end()) return s_.radius;
    const double below = fillet_end() - y;  // centre of the rounding: (radius - fillet, fillet_end)
    return s_.radius - s_.fillet + std::sqrt(s_.fillet * s_.fillet - below * below);
  }

  /// Heights of the corners that a mesh gives the rounded edge, m, ascending: facets of equal angle, none
  /// shorter than `shortest`, m. An edge too short for one facet keeps one corner, at the middle of the
  /// rounding; a sharp edge its own.
  std::vector<double> edge_heights(double shortest) const {
    if (!(s_.fillet > 0)) return {cone_height()};
    const auto at = [&](double share) {
      return fillet_end() - s_.fillet * std::sin(half_angle() * (1 - share));
    };
    const int facets = static_cast<int>(s_.fillet * half_angle() / shortest + 1e-9);
    if (facets < 1) return {at(0.5)};
    std::vector<double> y;
    for (int k = 0; k <= facets; ++k) y.push_back(at(static_cast<double>(k) / facets));
    return y;
  }

  /// Half-section as a line from the tip over the shoulder to the axis at the top, the rounded edge in 8
  /// facets.
  std::vector<Point2> outline() const {
    std::vector<Point2> line{{0, 0}};
    for (const double y : edge_heights(s_.fillet * half_angle() / 8)) line.emplace_back(profile(y), y);
    line.emplace_back(s_.radius, s_.length);
    line.emplace_back(0, s_.length);
    return line;
  }

  /// Volume of the whole penetrometer, m^3, of the outline turned about the axis.
  double volume() const {
    double v = 0;
    const auto line = outline();
    for (std::size_t k = 1; k < line.size(); ++k) {
      const double a = line[k - 1][0], b = line[k][0], h = line[k][1] - line[k - 1][1];
      v += pi / 3 * (a * a + a * b + b * b) * h;  // a frustum
    }
    return v;
  }

 private:
  double tangent() const { return s_.fillet * std::tan(half_angle() / 2); }

  DeviceShape s_;
};

/// Share of the device's motion that a node of the mesh makes. The mesh moves as a whole from `moving_depth`
/// below the tip upward; between there and the bottom of the chamber, which stands, it is compressed evenly.
/// y: height of the node at t = 0, m.
inline double motion_factor(double y, double moving_depth, const Chamber& chamber = {}) {
  return std::clamp((y + chamber.soil_depth) / (chamber.soil_depth - moving_depth), 0.0, 1.0);
}

}  // namespace arenite::ffp
