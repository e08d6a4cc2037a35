// An outline of lines and arcs, as a drawing gives it, and the lines that represent it.
#pragma once

#include <utility>
#include <vector>

#include <arenite/core/tensor.hpp>

namespace arenite::ffp {

/// Point of a half-section: (r, y), m.
using Point2 = Vec<double, 2>;

/// A corner of an outline, and whether a piece of the drawing ends there: the others lie on an arc.
struct ProfileCorner {
  Point2 at;
  bool end = true;
};

/// A line from the point before, or an arc of this radius, m, that bulges outward if it is positive.
struct ProfilePiece {
  Point2 to;
  double arc = 0;
};

/// The half-section from the tip at (0, 0) to the top, upward. The top is flat, unless the last corner lies on the axis.
class ProfileLine {
 public:
  /// From (0, 0) on. An arc, of at most a half circle, becomes lines of equal length that turn by at most 2 deg each, with a corner
  /// where it is widest. Throws `error` if a point lies lower than the one before, left of the axis, or is the one before again, if
  /// the line touches the axis before its end, or an arc is too small for its ends.
  explicit ProfileLine(const std::vector<ProfilePiece>& pieces);

  const std::vector<ProfilePiece>& pieces() const { return pieces_; }
  const std::vector<ProfileCorner>& corners() const { return corners_; }
  /// Largest radius, and height above the tip, m.
  double widest() const;
  double length() const { return corners_.back().at[1]; }

  /// The outline at the distance `offset` outside of it, m (negative: inside), its faces extended or cut until they join, from its own
  /// tip at (0, 0), and the height of this outline's tip above that. Throws `error` if a piece vanishes.
  std::pair<ProfileLine, double> parallel(double offset) const;

 private:
  void add(const Point2& to, bool end);
  void add_arc(const Point2& to, double radius);

  std::vector<ProfilePiece> pieces_;
  std::vector<ProfileCorner> corners_;
};

}  // namespace arenite::ffp
