// Cone-tipped cylinder: the signed distance of a penetrometer.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/particles/region.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Cylinder about the y axis with a conical tip that points down, its apex at `tip` on the axis. In two
/// dimensions the radius is |x|: a cone in axisymmetry, a wedge in plane strain.
class ConeCylinder {
 public:
  struct Parameters {
    double radius = std::numeric_limits<double>::quiet_NaN();  ///< of the cylinder, m
    double apex = std::numeric_limits<double>::quiet_NaN();    ///< apex angle of the cone, the full one, rad
    double length = std::numeric_limits<double>::quiet_NaN();  ///< from the apex to the flat end, m
    double tip = 0;                                            ///< height of the apex, m
  };

  explicit ConeCylinder(const Parameters& p) : tip_{p.tip} {
    require(p.radius > 0 && std::isfinite(p.radius), "ConeCylinder.radius", p.radius, "must be positive");
    require(p.apex > 0 && p.apex < pi, "ConeCylinder.apex", p.apex, "must lie in (0, pi) rad");
    const double cone = p.radius / std::tan(p.apex / 2);
    require(p.length >= cone && std::isfinite(p.length), "ConeCylinder.length", p.length,
            joined_text("must reach the cone's height ", cone));
    require(std::isfinite(p.tip), "ConeCylinder.tip", p.tip, "must be finite");
    outline_ = {{{0, 0}, {p.radius, cone}, {p.radius, p.length}, {0, p.length}}};
  }

  /// Signed distance, m, exact outside and inside.
  template <int D>
  double operator()(const Vec<double, D>& x) const {
    const double r = D == 2 ? std::abs(x[0]) : std::hypot(x[0], x[D - 1]);
    const double z = x[1] - tip_;
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
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

  /// Box around the body, m.
  template <int D>
  Box<std::size_t{D}> bounds() const {
    const auto [radius, top] = outline_[2];
    Box<std::size_t{D}> box;
    box.lower.fill(-radius);
    box.upper.fill(radius);
    box.lower[1] = tip_;
    box.upper[1] = tip_ + top;
    return box;
  }

 private:
  double tip_;
  std::array<std::array<double, 2>, 4>
      outline_;  // (r, z) from the apex outwards and up, then to the axis; convex
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
