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

Device::Section Device::section_of(const DeviceShape& s) {
  if (s.profile) return ProfileSection{s};
  require(s.radius > 0, "Device.radius", s.radius, "must be positive");
  require(s.apex > 0 && s.apex < pi, "Device.apex", s.apex, "must lie in (0, pi)");
  require(s.flat >= 0 && s.flat <= s.radius, "Device.flat", s.flat,
          "must lie between 0 and the radius of the cylinder");
  require(s.parabola >= 0 && (s.parabola == 0 || (s.flat == 0 && s.fillet == 0)), "Device.parabola",
          s.parabola, "must be at least 0, and goes without a flat end and a fillet");
  require(s.radius + s.offset > 0, "Device.offset", s.offset, "must leave something of the cylinder");
  const auto with_cylinder = [&](const auto& section) -> Section {
    require(section.length() > section.cone_height(), "Device.length", s.length,
            "must be greater than the height of the cone");
    return section;
  };
  return s.parabola > 0 ? with_cylinder(ParabolaSection{s}) : with_cylinder(ConeSection{s});
}

Device::Device(const DeviceShape& shape)
    : s_{shape}, section_{section_of(shape)}, own_{section_of(without_offset(shape))} {}

double Device::radius() const {
  return std::visit([](const auto& s) { return s.radius(); }, section_);
}
double Device::length() const {
  return std::visit([](const auto& s) { return s.length(); }, section_);
}
double Device::flat_radius() const {
  return std::visit([](const auto& s) { return s.flat_radius(); }, section_);
}
double Device::tip_above() const {
  return std::visit([](const auto& s) { return s.tip_above(); }, section_);
}
double Device::tip_end() const {
  return std::visit([](const auto& s) { return s.tip_end(); }, section_);
}
double Device::profile(double y) const {
  if (y < 0) return 0;
  if (y == 0) return flat_radius();
  return std::visit([&](const auto& s) { return s.profile(y); }, section_);
}
double Device::rise(double y) const {
  return std::visit([&](const auto& s) { return s.rise(y); }, section_);
}
std::vector<double> Device::marks(double shortest) const {
  return std::visit([&](const auto& s) { return s.marks(shortest); }, section_);
}

std::vector<Point2> Device::outline() const {
  auto line = std::visit([](const auto& s) { return s.tip_line(); }, section_);
  const Point2 top{profile(length()), length()};
  if (line.back() != top) line.push_back(top);
  if (top[0] > 0) line.emplace_back(0, length());
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
  if (depth < 0) return 0;
  const double r = std::visit([&](const auto& s) { return s.widest_below(depth); }, own_);
  return pi * r * r;
}

double Device::mantle_area(double depth) const {
  if (depth < 0) return 0;
  return std::visit([&](const auto& s) { return s.mantle_area(depth); }, own_);
}

}  // namespace arenite::ffp
