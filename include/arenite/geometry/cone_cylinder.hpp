// Cone-tipped cylinder: the signed distance of a penetrometer.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/geometry/box.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Cylinder about the y axis with a conical tip that points down, its lowest point at `tip` on the axis. In
/// two dimensions the radius is |x|: a cone in axisymmetry, a wedge in plane strain. The tip may be cut off
/// flat, and the edge between cone and cylinder rounded. A region too.
class ConeCylinder {
 public:
  static constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
  struct Parameters {
    double radius = not_given;  ///< of the cylinder, m; required, positive
    double apex = not_given;    ///< full angle of the cone, rad; required, in (0, pi)
    double length = not_given;  ///< from the lowest point to the upper end, m; required, positive
    double tip = 0;             ///< height of the lowest point, m, any
    double tip_radius = 0;      ///< of the flat tip of a truncated cone, m, in [0, radius); 0: a point
    double fillet = 0;          ///< radius of the edge between cone and cylinder, m, >= 0; 0: sharp
  };

  explicit ConeCylinder(const Parameters& p) : tip_{p.tip}, fillet_{p.fillet} {
    require(p.radius > 0 && std::isfinite(p.radius), "ConeCylinder.radius", p.radius,
            "must be given, positive");
    require(p.apex > 0 && p.apex < pi, "ConeCylinder.apex", p.apex, "must be given, in (0, pi) rad");
    require(p.tip_radius >= 0 && p.tip_radius < p.radius, "ConeCylinder.tip_radius", p.tip_radius,
            "must not be negative, and less than radius");
    const double cone = (p.radius - p.tip_radius) / std::tan(p.apex / 2);
    require(p.length >= cone && std::isfinite(p.length), "ConeCylinder.length", p.length,
            {"must reach the cone's height ", cone});
    require(std::isfinite(p.tip), "ConeCylinder.tip", p.tip, "must be finite");
    // The arc touches flank and shaft; both lose the same length to it.
    flank_normal_ = {std::cos(p.apex / 2), -std::sin(p.apex / 2)};
    const double lost = p.fillet * std::tan(p.apex / 4);
    centre_ = {p.radius - p.fillet, cone + lost};
    require(p.fillet >= 0 && lost * flank_normal_[0] <= cone && centre_[1] <= p.length, "ConeCylinder.fillet",
            p.fillet, "must not be negative, and the rounded edge must fit between tip and flat end");
    outline_ = {
        {{0, 0}, {p.tip_radius, 0}, {p.radius, cone}, {p.radius, cone}, {p.radius, p.length}, {0, p.length}}};
    if (p.fillet > 0) {
      outline_[2] = {centre_[0] + p.fillet * flank_normal_[0], centre_[1] + p.fillet * flank_normal_[1]};
      outline_[3] = {p.radius, centre_[1]};
    }
  }

  /// Signed distance, m, exact outside and inside.
  template <int D>
  double operator()(const Vec<double, D>& x) const {
    const double r = D == 2 ? std::abs(x[0]) : std::hypot(x[0], x[D - 1]);
    const double z = x[1] - tip_;
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = true;
    if (is_beside_arc(r, z)) {
      const double from_centre = std::hypot(r - centre_[0], z - centre_[1]);
      nearest = std::abs(from_centre - fillet_);
      inside = from_centre < fillet_;
    }
    for (std::size_t k = 0; k + 1 < outline_.size(); ++k) {
      if (k == 2) continue;  // the arc
      const auto [ar, az] = outline_[k];
      const double dr = outline_[k + 1][0] - ar, dz = outline_[k + 1][1] - az;
      const double length2 = dr * dr + dz * dz;
      if (length2 == 0) continue;
      const double t = std::clamp(((r - ar) * dr + (z - az) * dz) / length2, 0.0, 1.0);
      nearest = std::min(nearest, std::hypot(r - ar - t * dr, z - az - t * dz));
      inside = inside && (r - ar) * dz - (z - az) * dr < 0;
    }
    return inside ? -nearest : nearest;
  }
  template <int D>
  bool contains(const Vec<double, D>& x) const {
    return (*this)(x) < 0;
  }

  /// Box around the body, m.
  template <int D>
  Box<std::size_t{D}> bounds() const {
    const auto [radius, top] = outline_[4];
    Box<std::size_t{D}> box;
    box.lower.fill(-radius);
    box.upper.fill(radius);
    box.lower[1] = tip_;
    box.upper[1] = tip_ + top;
    return box;
  }

 private:
  /// Whether the line from the arc's centre to a place intersects the arc.
  bool is_beside_arc(double r, double z) const {
    const double dr = r - centre_[0], dz = z - centre_[1];
    return fillet_ > 0 && dz <= 0 && dz * flank_normal_[0] - dr * flank_normal_[1] >= 0;
  }

  double tip_, fillet_;
  std::array<double, 2> centre_, flank_normal_;   // (r, z), of the arc and of the flank
  std::array<std::array<double, 2>, 6> outline_;  // (r, z) from the tip outwards and up, then to the axis
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
