#include "sections.hpp"

#include <algorithm>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::ffp {

ConeSection::ConeSection(const DeviceShape& shape) : CylinderSection{shape} {
  const double a = half_angle(), apex = s_.flat / std::tan(a) + s_.offset / std::sin(a);
  const double cut = s_.flat + s_.offset * (1 - std::sin(a)) / std::cos(a);  // by the flat end's plane
  const bool blunt = s_.flat == s_.radius;
  flat_ = blunt ? radius() : s_.flat > 0 ? std::clamp(cut, 0.0, radius()) : 0;
  tip_above_ = flat_ > 0 ? s_.offset : apex;
  fillet_ = s_.fillet > 0 ? std::max(0.0, s_.fillet + s_.offset) : 0;
  cone_height_ = (radius() - flat_) / std::tan(a);
  require(s_.fillet >= 0 &&
              (s_.fillet == 0 || (s_.flat < s_.radius && fillet_start() > 0 && fillet_end() < length())),
          "Device.fillet", s_.fillet,
          "must be at least 0, and the rounded edge must fit between tip and top");
}

double ConeSection::profile(double y) const {
  if (y < fillet_start()) return flat_ + y * std::tan(half_angle());
  if (y >= fillet_end()) return radius();
  const double below = fillet_end() - y;  // centre of the rounding: (radius - fillet, fillet_end)
  return radius() - fillet_ + std::sqrt(fillet_ * fillet_ - below * below);
}

double ConeSection::rise(double y) const {
  if (y >= fillet_end()) return 1;
  if (y < fillet_start()) return std::cos(half_angle());
  return std::sqrt(std::max(0.0, 1 - square((fillet_end() - y) / fillet_)));
}

std::vector<double> ConeSection::marks(double shortest) const {
  if (!(fillet_ > 0)) return {cone_height()};
  const auto at = [&](double share) { return fillet_end() - fillet_ * std::sin(half_angle() * (1 - share)); };
  const int facets = static_cast<int>(fillet_ * half_angle() / shortest + 1e-9);
  if (facets < 1) return {at(0.5)};
  std::vector<double> y;
  for (int k = 0; k <= facets; ++k) y.push_back(at(static_cast<double>(k) / facets));
  return y;
}

std::vector<Point2> ConeSection::tip_line() const {
  std::vector<Point2> line{{0, 0}};
  if (flat_ > 0) line.emplace_back(flat_, 0);
  if (flat_ < radius())
    for (const double y : marks(fillet_ * half_angle() / 8)) line.emplace_back(profile(y), y);
  return line;
}

double ConeSection::mantle_area(double depth) const {
  const double r = profile(std::min(depth, fillet_start()));
  double area = pi * flat_ * flat_;
  area += pi * (r * r - flat_ * flat_) / std::sin(half_angle());
  if (depth > fillet_start() && fillet_ > 0) {  // a zone of the torus
    const double below = std::max(0.0, fillet_end() - depth), turned = std::asin(below / fillet_);
    area += 2 * pi * fillet_ *
            ((radius() - fillet_) * (half_angle() - turned) + fillet_ * std::sin(half_angle()) - below);
  }
  return area;
}

ParabolaSection::ParabolaSection(const DeviceShape& shape)
    : CylinderSection{shape}, parabola_{s_.parabola, s_.offset}, edge_{parabola_.at_radius(radius())} {
  tip_above_ = -parabola_.height(parabola_.start());
  cone_height_ = parabola_.height(edge_) + tip_above_;
}

double ParabolaSection::profile(double y) const {
  return y < cone_height() ? parabola_.radius(parabola_.at_height(y - tip_above())) : radius();
}

double ParabolaSection::rise(double y) const {
  return y < cone_height() ? parabola_.rise(parabola_.at_height(y - tip_above())) : 1;
}

std::vector<Point2> ParabolaSection::tip_line() const {
  constexpr int pieces = 64;
  std::vector<Point2> line{{0, 0}};
  for (int k = 1; k < pieces; ++k) {
    const double p = parabola_.start() + (edge_ - parabola_.start()) * k / pieces;
    line.emplace_back(parabola_.radius(p), parabola_.height(p) + tip_above());
  }
  line.emplace_back(radius(), cone_height());
  return line;
}

double ParabolaSection::mantle_area(double depth) const {
  const double slope = 2 * profile(depth) / s_.parabola;
  return pi * s_.parabola * s_.parabola / 6 * (std::pow(1 + slope * slope, 1.5) - 1);
}

ProfileSection::ProfileSection(const DeviceShape& shape) {
  const auto [line, above] = shape.profile->parallel(shape.offset);
  corners_ = line.corners();
  tip_above_ = above;
  widest_ = line.widest();
  require(corners_.size() > 2, "Device.profile", corners_.size(),
          "must have more points than the tip and one");
}

double ProfileSection::flat_radius() const {
  double r = 0;
  for (const ProfileCorner& c : corners_)
    if (c.at[1] == 0) r = std::max(r, c.at[0]);
  return r;
}

double ProfileSection::tip_end() const {
  bool widest = false;
  for (std::size_t k = 0; k + 1 < corners_.size(); ++k) {
    widest = widest || corners_[k].at[0] >= widest_ * (1 - 1e-9);
    if (widest && corners_[k].end && corners_[k + 1].at[0] == corners_[k].at[0]) return corners_[k].at[1];
  }
  return length();
}

/// The highest piece, by its upper corner, that reaches up to y.
std::size_t ProfileSection::piece_at(double y) const {
  std::size_t k = 1;
  while (k + 1 < corners_.size() && corners_[k].at[1] <= y) ++k;
  return k;
}

double ProfileSection::profile(double y) const {
  if (y >= length()) return corners_.back().at[0];
  const std::size_t k = piece_at(y);
  const Point2 &a = corners_[k - 1].at, &b = corners_[k].at;
  return a[0] + (b[0] - a[0]) * ((y - a[1]) / (b[1] - a[1]));
}

double ProfileSection::rise(double y) const {
  if (y >= length()) return 1;
  const std::size_t k = piece_at(y);
  const Point2 along = corners_[k].at - corners_[k - 1].at;
  return along[1] / along.norm();
}

std::vector<double> ProfileSection::marks(double shortest) const {
  const double end = tip_end();
  std::vector<double> y;
  for (const ProfileCorner& c : corners_) {
    if (!c.end || c.at[1] >= length()) continue;
    const bool near = !y.empty() && c.at[1] - y.back() < shortest / 2;
    if (near && c.at[1] != end) continue;
    if (near && y.back() > 0) y.pop_back();
    if (y.empty() || c.at[1] > y.back()) y.push_back(c.at[1]);
  }
  return y;
}

std::vector<Point2> ProfileSection::tip_line() const {
  std::vector<Point2> line;
  for (const ProfileCorner& c : corners_) line.push_back(c.at);
  return line;
}

double ProfileSection::mantle_area(double depth) const {
  double area = 0;
  for (std::size_t k = 1; k < corners_.size() && corners_[k - 1].at[0] < widest_; ++k) {
    const Point2 a = corners_[k - 1].at;
    if (a[1] > depth) break;
    const Point2 full = corners_[k].at - a;
    const double share = full[1] > 0 ? std::min(1.0, (depth - a[1]) / full[1]) : 1;
    area += pi * (2 * a[0] + share * full[0]) * share * full.norm();
  }
  return area;
}

double ProfileSection::widest_below(double y) const {
  double r = profile(y);
  for (const ProfileCorner& c : corners_)
    if (c.at[1] <= y) r = std::max(r, c.at[0]);
  return r;
}

}  // namespace arenite::ffp
