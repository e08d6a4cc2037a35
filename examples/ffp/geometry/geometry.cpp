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

Device::Device(const DeviceShape& shape) : s_{shape}, section_{section_of(shape)} {}

namespace {

/// What a section tells.
template <class Section, class Question>
auto asked(const Section& section, Question&& question) {
  return std::visit(question, section);
}

}  // namespace

double Device::radius() const {
  return asked(section_, [](const auto& s) { return s.radius(); });
}
double Device::length() const {
  return asked(section_, [](const auto& s) { return s.length(); });
}
double Device::flat_radius() const {
  return asked(section_, [](const auto& s) { return s.flat_radius(); });
}
double Device::tip_above() const {
  return asked(section_, [](const auto& s) { return s.tip_above(); });
}
double Device::tip_end() const {
  return asked(section_, [](const auto& s) { return s.tip_end(); });
}
double Device::profile(double y) const {
  if (y < 0) return 0;
  if (y == 0) return flat_radius();
  return asked(section_, [&](const auto& s) { return s.profile(y); });
}
double Device::rise(double y) const {
  return asked(section_, [&](const auto& s) { return s.rise(y); });
}
std::vector<double> Device::marks(double shortest) const {
  return asked(section_, [&](const auto& s) { return s.marks(shortest); });
}

std::vector<Point2> Device::outline() const {
  auto line = asked(section_, [](const auto& s) { return s.tip_line(); });
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
  const Device body = instrument();
  const auto* any = std::get_if<ProfileSection>(&body.section_);
  const double r = any && depth >= 0 ? any->widest_below(depth) : body.profile(depth);
  return pi * r * r;
}

double Device::mantle_area(double depth) const {
  if (depth < 0) return 0;
  return asked(instrument().section_, [&](const auto& s) { return s.mantle_area(depth); });
}

}  // namespace arenite::ffp
