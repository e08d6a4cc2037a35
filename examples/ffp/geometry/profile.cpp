#include "profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <arenite/core/error.hpp>
#include <arenite/core/units.hpp>

namespace arenite::ffp {

namespace {

/// Where a direction is turned to the right, outward of an outline that is followed upward.
Point2 right_of(const Point2& along) { return {along[1], -along[0]}; }

/// The centre of an arc between two points; `radius` as in `ProfilePiece`.
Point2 centre_of(const Point2& from, const Point2& to, double radius) {
  const Point2 chord = to - from;
  const double half = chord.norm() / 2, apart = std::sqrt(std::max(0.0, radius * radius - half * half));
  return (from + to) / 2 - (radius > 0 ? apart : -apart) * right_of(chord) / (2 * half);
}

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
  const double side = radius > 0 ? 1 : -1;
  const Point2 centre = centre_of(from, to, radius);
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

namespace {

/// The line or the circle that a piece is of.
struct Curve {
  Point2 point, along;  ///< of a line, with its direction, or centre of a circle
  double radius = 0;    ///< 0: a line
};

/// The intersection of two curves nearest to a place; nothing if they do not intersect.
std::optional<Point2> meeting(const Curve& a, const Curve& b, const Point2& near) {
  if (a.radius > 0 && b.radius == 0) return meeting(b, a, near);
  Point2 middle, along;  // candidates lie on a line: middle +- share * along
  double share = 0;
  if (a.radius == 0 && b.radius == 0) {
    const double cross = a.along.dot(right_of(b.along));
    if (std::abs(cross) < 1e-12) return {};
    return a.point + a.along * ((b.point - a.point).dot(right_of(b.along)) / cross);
  }
  if (a.radius == 0) {
    along = a.along;
    middle = a.point + along * (b.point - a.point).dot(along);
    share = b.radius * b.radius - (middle - b.point).squaredNorm();
  } else {
    const Point2 between = b.point - a.point;
    const double d = between.norm();
    if (d < 1e-12) return {};
    const double first = (a.radius * a.radius - b.radius * b.radius + d * d) / (2 * d);
    middle = a.point + between * (first / d);
    along = right_of(between / d);
    share = a.radius * a.radius - first * first;
  }
  if (share < 0) return {};
  const Point2 low = middle - std::sqrt(share) * along, high = middle + std::sqrt(share) * along;
  return (low - near).norm() < (high - near).norm() ? low : high;
}

}  // namespace

std::pair<ProfileLine, double> ProfileLine::parallel(double offset) const {
  if (offset == 0) return {*this, 0};
  const auto vanished = [&] {
    return error(joined_text({"Device.offset = ", offset, ": must leave each piece of the profile"}));
  };
  const auto n = pieces_.size();
  std::vector<Point2> at{Point2(0, 0)};
  for (const auto& piece : pieces_) at.push_back(piece.to);
  std::vector<Curve> curves;
  std::vector<std::array<Point2, 2>> normals;  // of a piece at both of its ends, outward
  for (std::size_t k = 0; k < n; ++k) {
    const Point2 &from = at[k], &to = at[k + 1];
    if (const double arc = pieces_[k].arc; arc == 0) {
      const Point2 along = (to - from).normalized(), out = right_of(along);
      normals.push_back({out, out});
      curves.push_back({from + offset * out, along, 0});
    } else {
      const Point2 centre = centre_of(from, to, arc);
      const double side = arc > 0 ? 1 : -1, radius = std::abs(arc) + side * offset;
      if (!(radius > 0)) throw vanished();
      normals.push_back({side * (from - centre) / std::abs(arc), side * (to - centre) / std::abs(arc)});
      curves.push_back({centre, Point2(0, 0), radius});
    }
  }
  const Curve axis{Point2(0, 0), Point2(0, 1), 0}, top{at[n] + Point2(0, offset), Point2(1, 0), 0};
  const auto joint = [&](std::size_t k) -> std::optional<Point2> {
    if (k == 0) return meeting(axis, curves[0], at[0] - Point2(0, offset));
    const Point2 before = normals[k - 1][1];
    if (k == n) return meeting(at[n][0] > 0 ? top : axis, curves[n - 1], at[n] + Point2(0, offset));
    const Point2 after = normals[k][0];
    if ((before - after).norm() < 1e-6) return at[k] + offset * before;
    return meeting(curves[k - 1], curves[k], at[k] + offset * (before + after).normalized());
  };
  std::vector<Point2> corner;
  for (std::size_t k = 0; k <= n; ++k) {
    const auto found = joint(k);
    if (!found || (*found)[0] < -1e-12) throw vanished();
    corner.push_back(*found);
    if (k > 0 && !((corner[k] - corner[k - 1]).dot(at[k] - at[k - 1]) > 0)) throw vanished();
  }
  const double tip = corner[0][1];
  std::vector<ProfilePiece> pieces;
  for (std::size_t k = 0; k < n; ++k) {
    Point2 to = corner[k + 1] - Point2(0, tip);
    if (std::abs(to[0]) < 1e-12) to[0] = 0;
    if (k == 0 && at[1][1] == 0) to[1] = 0;  // a flat end stays flat
    pieces.push_back({to, pieces_[k].arc == 0  ? 0
                          : pieces_[k].arc > 0 ? curves[k].radius
                                               : -curves[k].radius});
  }
  return {ProfileLine{pieces}, -tip};
}

}  // namespace arenite::ffp
