#include "profile.hpp"

#include <algorithm>
#include <cmath>

#include <arenite/core/error.hpp>
#include <arenite/core/units.hpp>

namespace arenite::ffp {

namespace {

/// Where a direction is turned to the right, outward of an outline that is followed upward.
Point2 right_of(const Point2& along) { return {along[1], -along[0]}; }

}  // namespace

void ProfileLine::add(const Point2& to, bool end) {
  const Point2& from = corners_.back().at;
  const std::string at = joined_text({"(", to[0], ", ", to[1], ")"});
  require(to.allFinite() && to[0] >= 0, "profile", at, "must have a radius of at least 0");
  require(
      to[1] >= from[1], "profile", at,
      {"must not lie below the point before, (", from[0], ", ", from[1], "): it goes from the tip upward"});
  require(to != from, "profile", at, "is the point before again");
  require(corners_.size() == 1 || from[0] > 0, "profile", at, "comes after the line has met the axis again");
  corners_.push_back({to, end});
}

ProfileLine::ProfileLine(const std::vector<ProfilePiece>& pieces) : pieces_{pieces}, corners_{{{0, 0}}} {
  for (const auto& [to, arc] : pieces_) arc == 0 ? add(to, true) : add_arc(to, arc);
  require(widest() > 0 && length() > 0, "profile", pieces_.size(), "must enclose a body");
}

void ProfileLine::add_arc(const Point2& to, double radius) {
  const Point2 from = corners_.back().at, chord = to - from;
  const double half = chord.norm() / 2, size = std::abs(radius);
  require(half > 0 && half <= size * (1 + 1e-9), "arc of the profile", radius,
          {"must be at least half the distance of its ends, ", half, " m"});
  const double apart = std::sqrt(std::max(0.0, size * size - half * half));
  const double side = radius > 0 ? 1 : -1;  // the centre lies inside of an arc that bulges outward
  const Point2 centre = (from + to) / 2 - side * apart * right_of(chord) / (2 * half);
  const auto angle_of = [&](const Point2& x) { return std::atan2(x[1] - centre[1], x[0] - centre[0]); };
  const double turn = 2 * std::asin(std::min(1.0, half / size)), start = angle_of(from);
  const int pieces = std::max(1, static_cast<int>(std::ceil(turn / (2 * pi / 180) - 1e-9)));
  std::vector<double> angles;
  for (int k = 1; k < pieces; ++k) angles.push_back(start + side * turn * k / pieces);
  const double end = start + turn;
  if (radius > 0 && start < -1e-9 && end > 1e-9) angles.push_back(0);  // its widest point
  std::sort(angles.begin(), angles.end());
  if (side < 0) std::reverse(angles.begin(), angles.end());
  for (std::size_t k = 0; k < angles.size(); ++k)
    if (k == 0 || std::abs(angles[k] - angles[k - 1]) > 1e-9)
      add(centre + size * Point2(std::cos(angles[k]), std::sin(angles[k])), false);
  add(to, true);
}

double ProfileLine::widest() const {
  double r = 0;
  for (const ProfileCorner& c : corners_) r = std::max(r, c.at[0]);
  return r;
}

std::vector<ProfileCorner> ProfileLine::parallel(double offset) const {
  std::vector<ProfileCorner> out = corners_;
  if (offset == 0) return out;
  const auto n = corners_.size();
  const auto normal = [&](std::size_t k) {  // of the piece after corner k
    return k + 1 < n               ? right_of((corners_[k + 1].at - corners_[k].at).normalized())
           : corners_[k].at[0] > 0 ? Point2(0, 1)  // the flat top
                                   : Point2(right_of((corners_[k].at - corners_[k - 1].at).normalized())
                                                .cwiseProduct(Point2(-1, 1)));
  };
  for (std::size_t k = 0; k < n; ++k) {
    const Point2 after = normal(k), before = k > 0 ? normal(k - 1) : Point2(-after[0], after[1]);
    out[k].at += offset * (before + after) / (1 + before.dot(after));
  }
  out.front().at[0] = 0;
  for (std::size_t k = 1; k < n; ++k)
    require((out[k].at - out[k - 1].at).dot(corners_[k].at - corners_[k - 1].at) > 0 && out[k].at[0] >= 0,
            "Device.offset", offset, "must leave each piece of the profile");
  return out;
}

}  // namespace arenite::ffp
