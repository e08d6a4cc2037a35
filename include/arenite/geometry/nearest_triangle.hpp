// The nearest of many triangles, and those that a ray crosses, by a tree of boxes around them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <arenite/core/tensor.hpp>
#include <arenite/geometry/triangle_data.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The nearest place of a triangle, and the feature that it lies on: corner 0 to 2, edge 3 to 5 (from corner
/// 0, 1, 2 to the next), or the face, 6.
struct TrianglePlace {
  Vec<double, 3> at;
  std::size_t feature;
};

/// By the regions of corners, edges and face (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
inline TrianglePlace nearest_on_triangle(const Vec<double, 3>& a, const Vec<double, 3>& ab,
                                         const Vec<double, 3>& ac, const Vec<double, 3>& x) {
  const Vec<double, 3> ap = x - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {a, 0};
  const Vec<double, 3> bp = ap - ab;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {a + ab, 1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + d1 / (d1 - d3) * ab, 3};
  const Vec<double, 3> cp = ap - ac;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {a + ac, 2};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + d2 / (d2 - d6) * ac, 5};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return {a + ab + (d4 - d3) / (d4 - d3 + d5 - d6) * (ac - ab), 4};
  const double all = va + vb + vc;
  return {a + vb / all * ab + vc / all * ac, 6};
}

/// Whether the ray from x along the first axis crosses a triangle. Seen along the ray each place belongs to
/// one of two triangles at their common edge, as with polygons, so that a closed surface is crossed an odd
/// number of times from inside, but for round-off where x lies on it.
inline bool is_crossed(const std::array<Vec<double, 3>, 3>& corner, const Vec<double, 3>& x) {
  bool seen = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec<double, 3>*a = &corner[k], *b = &corner[(k + 1) % 3];
    if ((*a)[2] > (*b)[2]) std::swap(a, b);  // the same in both triangles
    if ((*a)[2] > x[2] || x[2] >= (*b)[2]) continue;
    const double across = ((*b)[1] - (*a)[1]) * (x[2] - (*a)[2]) - (x[1] - (*a)[1]) * ((*b)[2] - (*a)[2]);
    if (across > 0) seen = !seen;
  }
  if (!seen) return false;
  const auto [least, most] = std::minmax({corner[0][0], corner[1][0], corner[2][0]});
  if (x[0] < least || x[0] > most) return x[0] < least;
  const Vec<double, 3> normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  return normal.dot(x - corner[0]) * normal[0] < 0;
}

/// A tree of boxes: halves of the triangles along the longest axis, down to a few.
class TriangleTree {
 public:
  struct Nearest {
    Index triangle = none;
    TrianglePlace place{};
    double distance2 = std::numeric_limits<double>::infinity();  ///< m2
  };

  explicit TriangleTree(const TriangleData& data) {
    std::vector<Index> order(data.triangles.size());
    std::iota(order.begin(), order.end(), Index{0});
    facets_.reserve(order.size());
    boxes_.reserve(order.size());
    build(data, order.data(), order.data() + order.size());
  }

  /// The nearest triangle; of several at the same distance the one found first.
  Nearest nearest(const Vec<double, 3>& x) const {
    struct Open {
      Index box;
      double distance2;
    };
    std::array<Open, 64> open;  // at most one for each level of the tree
    std::size_t count = 0;
    Nearest best;
    open[count++] = {0, boxes_[0].distance2(x)};
    while (count > 0) {
      const Open top = open[--count];
      if (top.distance2 >= best.distance2) continue;
      const Node& box = boxes_[top.box];
      for (Index i = box.first; i < box.first + box.count; ++i) look(facets_[i], x, best);
      if (box.count > 0) continue;
      Open close{top.box + 1, boxes_[top.box + 1].distance2(x)},
          distant{box.second, boxes_[box.second].distance2(x)};
      if (distant.distance2 < close.distance2) std::swap(close, distant);
      if (distant.distance2 < best.distance2) open[count++] = distant;
      if (close.distance2 < best.distance2) open[count++] = close;
    }
    return best;
  }

  /// Whether the ray from x along the first axis crosses an odd number of the triangles, of which the tree
  /// was made.
  bool crosses_odd(const TriangleData& data, const Vec<double, 3>& x) const {
    std::array<Index, 64> open;
    std::size_t count = 0;
    bool odd = false;
    open[count++] = 0;
    while (count > 0) {
      const Index top = open[--count];
      const Node& box = boxes_[top];
      if (x[0] > box.upper[0] || x[1] < box.lower[1] || x[1] > box.upper[1] || x[2] < box.lower[2] ||
          x[2] > box.upper[2])
        continue;
      for (Index i = box.first; i < box.first + box.count; ++i) {
        const auto& [a, b, c] = data.triangles[facets_[i].triangle];
        odd = odd != is_crossed({data.vertices[a], data.vertices[b], data.vertices[c]}, x);
      }
      if (box.count > 0) continue;
      open[count++] = box.second;
      open[count++] = top + 1;
    }
    return odd;
  }

 private:
  struct Facet {
    Vec<double, 3> a, ab, ac;
    Index triangle;
  };
  struct Node {
    Vec<double, 3> lower, upper;
    Index first = 0, count = 0;  // facets of a leaf
    Index second = 0;            // the other half; the first one follows its parent

    double distance2(const Vec<double, 3>& x) const {
      return (lower - x).cwiseMax(x - upper).cwiseMax(0.0).squaredNorm();
    }
  };
  static constexpr std::ptrdiff_t leaf_size = 4;

  static void look(const Facet& f, const Vec<double, 3>& x, Nearest& best) {
    const TrianglePlace place = nearest_on_triangle(f.a, f.ab, f.ac, x);
    const double distance2 = (x - place.at).squaredNorm();
    if (distance2 < best.distance2) best = {f.triangle, place, distance2};
  }

  /// Appends the box of the triangles [begin, end) and those below it.
  void build(const TriangleData& data, Index* begin, Index* end) {
    const auto corner = [&](Index t, std::size_t k) { return data.vertices[data.triangles[t][k]]; };
    const auto at = boxes_.size();
    boxes_.push_back({corner(*begin, 0), corner(*begin, 0)});
    Vec<double, 3> low = Vec<double, 3>::Constant(std::numeric_limits<double>::infinity()), high = -low;
    const auto middle = [&](Index t) -> Vec<double, 3> { return corner(t, 0) + corner(t, 1) + corner(t, 2); };
    for (const Index* t = begin; t != end; ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        boxes_[at].lower = boxes_[at].lower.cwiseMin(corner(*t, k));
        boxes_[at].upper = boxes_[at].upper.cwiseMax(corner(*t, k));
      }
      low = low.cwiseMin(middle(*t));
      high = high.cwiseMax(middle(*t));
    }
    if (end - begin <= leaf_size) {
      boxes_[at].first = static_cast<Index>(facets_.size());
      boxes_[at].count = static_cast<Index>(end - begin);
      for (const Index* t = begin; t != end; ++t)
        facets_.push_back({corner(*t, 0), corner(*t, 1) - corner(*t, 0), corner(*t, 2) - corner(*t, 0), *t});
      return;
    }
    int axis;
    (high - low).maxCoeff(&axis);
    Index* const half = begin + (end - begin) / 2;
    std::nth_element(begin, half, end, [&](Index s, Index t) {
      const double a = middle(s)[axis], b = middle(t)[axis];
      return a < b || (a == b && s < t);
    });
    build(data, begin, half);
    boxes_[at].second = static_cast<Index>(boxes_.size());
    build(data, half, end);
  }

  std::vector<Facet> facets_;  // leaf by leaf
  std::vector<Node> boxes_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
