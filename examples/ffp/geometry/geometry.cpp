#include "geometry.hpp"

#include <algorithm>
#include <cmath>

#include <arenite/core/error.hpp>

namespace arenite::ffp {

Chamber chamber_for(double diameter, double length) {
  const DeviceShape published;
  const double scale = diameter / (2 * published.radius);
  Chamber c;
  c.radius *= scale;
  c.soil_depth *= scale;
  c.headroom = c.headroom * scale + (length - published.length * scale);
  return c;
}

Device::Device(const DeviceShape& shape) : s_{shape} {
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

double Device::profile(double y) const {
  if (y < 0) return 0;
  if (y == 0) return flat_;
  if (y < fillet_start()) return tip_radius(y);
  if (y >= fillet_end()) return radius();
  const double below = fillet_end() - y;  // centre of the rounding: (radius - fillet, fillet_end)
  return radius() - fillet_ + std::sqrt(fillet_ * fillet_ - below * below);
}

std::vector<double> Device::edge_heights(double shortest) const {
  if (!(fillet_ > 0)) return {cone_height()};
  const auto at = [&](double share) { return fillet_end() - fillet_ * std::sin(half_angle() * (1 - share)); };
  const int facets = static_cast<int>(fillet_ * half_angle() / shortest + 1e-9);
  if (facets < 1) return {at(0.5)};
  std::vector<double> y;
  for (int k = 0; k <= facets; ++k) y.push_back(at(static_cast<double>(k) / facets));
  return y;
}

std::vector<Point2> Device::outline() const {
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

double Device::volume() const {
  double v = 0;
  const auto line = outline();
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double a = line[k - 1][0], b = line[k][0], h = line[k][1] - line[k - 1][1];
    v += pi / 3 * (a * a + a * b + b * b) * h;  // a frustum
  }
  return v;
}

double Device::projected_area(double depth) const {
  const double r = instrument().profile(depth);
  return pi * r * r;
}

double Device::mantle_area(double depth) const {
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
    area += 2 * pi * s_.fillet *
            ((s_.radius - s_.fillet) * (half_angle() - turned) + s_.fillet * std::sin(half_angle()) - below);
  }
  return area;
}

void Device::set_cone() {
  const double a = half_angle(), apex = s_.flat / std::tan(a) + s_.offset / std::sin(a);
  const double cut = s_.flat + s_.offset * (1 - std::sin(a)) / std::cos(a);  // by the flat end's plane
  const bool blunt = s_.flat == s_.radius;
  flat_ = blunt ? radius() : s_.flat > 0 ? std::clamp(cut, 0.0, radius()) : 0;
  tip_above_ = flat_ > 0 ? s_.offset : apex;
  fillet_ = s_.fillet > 0 ? std::max(0.0, s_.fillet + s_.offset) : 0;
  cone_height_ = (radius() - flat_) / std::tan(a);
}

void Device::set_parabola() {
  parabola_.emplace(s_.parabola, s_.offset);
  tip_above_ = -parabola_->height(parabola_->start());
  edge_ = parabola_->at_radius(radius());
  cone_height_ = parabola_->height(edge_) + tip_above_;
}

}  // namespace arenite::ffp
