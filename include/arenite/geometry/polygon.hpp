// Polygon: the inside of a closed line in the plane, as region and as signed distance.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/geometry/box.hpp>
#include <arenite/geometry/contact_segment.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The inside of a closed line of corners (x, y), m, in either sense; the last corner is joined to the first.
/// Where the line crosses itself: what an odd number of turns encloses. Polygons that share sides share no
/// position and leave none out.
class Polygon {
 public:
  using Corner = std::array<double, 2>;
  Corner lower, upper;  ///< bounds, m

  /// Throws `error` unless there are three corners or more, all finite, and they enclose an area.
  explicit Polygon(std::vector<Corner> corners) : corners_{std::move(corners)} {
    require(corners_.size() >= 3, "Polygon.corners", corners_.size(), "must be at least three");
    lower = upper = corners_.front();
    for (std::size_t i = 0; i < corners_.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        require(std::isfinite(corners_[i][k]), {"Polygon.corners[", i, "][", k, "]"}, corners_[i][k],
                "must be finite");
        lower[k] = std::min(lower[k], corners_[i][k]);
        upper[k] = std::max(upper[k], corners_[i][k]);
      }
    require(lower[0] < upper[0] && lower[1] < upper[1], "Polygon.corners", corners_.size(),
            "must enclose an area");
  }

  bool contains(const Vec<double, 2>& x) const {
    bool inside = false;
    for (std::size_t i = 0, before = corners_.size() - 1; i < corners_.size(); before = i++) {
      // From the lower end to the upper one, so that both polygons at a side compute the same.
      const Corner* a = &corners_[before];
      const Corner* b = &corners_[i];
      if ((*a)[1] > (*b)[1]) std::swap(a, b);
      if ((*a)[1] <= x[1] && x[1] < (*b)[1]) {
        const double across = ((*b)[0] - (*a)[0]) * (x[1] - (*a)[1]) - (x[0] - (*a)[0]) * ((*b)[1] - (*a)[1]);
        if (across > 0) inside = !inside;
      }
    }
    return inside;
  }
  template <int Other>
  bool contains(const Vec<double, Other>& x) const = delete;  // in space

  /// Signed distance, m, exact outside and inside of a polygon that does not cross itself. Looks at each
  /// side.
  double operator()(const Vec<double, 2>& x) const {
    double nearest2 = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, before = corners_.size() - 1; i < corners_.size(); before = i++) {
      const Corner &a = corners_[before], &b = corners_[i];
      const double bx = b[0] - a[0], by = b[1] - a[1], px = x[0] - a[0], py = x[1] - a[1];
      const double length2 = bx * bx + by * by;
      const double t = length2 > 0 ? std::clamp((px * bx + py * by) / length2, 0.0, 1.0) : 0;
      nearest2 = std::min(nearest2, square(px - t * bx) + square(py - t * by));
    }
    return contains(x) ? -std::sqrt(nearest2) : std::sqrt(nearest2);
  }
  template <int Other>
  double operator()(const Vec<double, Other>& x) const = delete;

  Box<2> bounds() const { return {lower, upper}; }
  const std::vector<Corner>& corners() const { return corners_; }
  std::vector<ContactSegment> contact_segments() const {
    std::vector<ContactSegment> all;
    for (const auto& [x, y] : corners_) all.push_back({{x, y, 0}, {x, y, 0}, 0});
    return all;
  }

 private:
  std::vector<Corner> corners_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
