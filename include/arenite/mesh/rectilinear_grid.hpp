// Rectilinear grid: cells between lines at any distances along each axis.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/mesh/cell_size.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Places of grid lines, m, ascending: equal edges of `cell` from `from` to `to`, then on either side edges
/// that grow by the factor `growth`, each, until `lower` and `upper`; the growing ones are scaled by the same
/// factor, at most by half of a cell in all, so that the last line lies there. `growth` = 1: as equal as
/// possible.
struct GrowingLines {
  double lower = std::numeric_limits<double>::quiet_NaN(), upper = lower;  ///< ends, m
  double from = lower, to = upper;                                         ///< of the equal edges, m
  double cell = std::numeric_limits<double>::quiet_NaN();                  ///< m
  double growth = 1.2;                                                     ///< edge over the one before, -

  /// Throws `error` for invalid numbers.
  operator std::vector<double>() const {
    require(std::isfinite(lower), "GrowingLines.lower", lower, "must be given");
    require(from >= lower && std::isfinite(from), "GrowingLines.from", from, "must not lie below lower");
    require(to > from && std::isfinite(to), "GrowingLines.to", to, "must lie above from");
    require(upper >= to && std::isfinite(upper), "GrowingLines.upper", upper, "must not lie below to");
    require(cell > 0 && std::isfinite(cell), "GrowingLines.cell", cell, "must be positive");
    require(growth >= 1 && growth <= 2, "GrowingLines.growth", growth, "must lie in [1, 2]");
    std::vector<double> lines;
    const std::vector<double> below = grown(from - lower), above = grown(upper - to);
    for (std::size_t k = below.size(); k-- > 0;)
      lines.push_back(k + 1 == below.size() ? lower : from - below[k]);
    const double count = std::max(1.0, std::round((to - from) / cell));
    for (double k = 0; k <= count; ++k) lines.push_back(from + (to - from) * k / count);
    for (std::size_t k = 0; k < above.size(); ++k)
      lines.push_back(k + 1 == above.size() ? upper : to + above[k]);
    return lines;
  }

 private:
  /// Distances of the lines from where the edges begin to grow.
  std::vector<double> grown(double length) const {
    std::vector<double> at;
    double sum = 0;
    for (double edge = cell * growth; sum < length - edge / 2; edge *= growth) at.push_back(sum += edge);
    if (at.empty() && length > 0) at.push_back(sum = length);
    for (double& x : at) x *= length / sum;
    return at;
  }
};

/// Cells are numbered with axis 0 running fastest, as those of a `CartesianGrid`. Linear functions and
/// splines work on it; the stable step is that of its smallest edges.
template <int D, real_scalar T = double>
class RectilinearGrid {
 public:
  static constexpr int dimension = D;
  using scalar = T;
  using Point = Vec<T, D>;
  static constexpr auto dim = static_cast<std::size_t>(D);

  /// Places of the lines along each axis, m: at least two, ascending; z only in three dimensions.
  struct Parameters {
    std::vector<double> x{}, y{}, z{};
  };

  /// `{{.x = {0, 0.1, 0.3}, .y = GrowingLines{..}}}`. Throws `error` unless lines ascend, and have distances
  /// that T allows.
  explicit RectilinearGrid(const Parameters& p) {
    require(D == 3 || p.z.empty(), "RectilinearGrid.z", p.z.size(),
            "lines of a grid in the plane: must be none");
    const std::array<const std::vector<double>*, 3> lines_of{&p.x, &p.y, &p.z};
    double total = 1;
    for (std::size_t k = 0; k < dim; ++k) {
      const auto& lines = *lines_of[k];
      const std::string name = joined_text({"RectilinearGrid.", "xyz"[k]});
      require(lines.size() >= 2, name, lines.size(), "must be at least two lines");
      for (std::size_t i = 0; i < lines.size(); ++i) {
        require(std::isfinite(lines[i]), {name, "[", i, "]"}, lines[i], "must be finite");
        if (i > 0) detail::check_edge<T>(joined_text({name, "[", i, "]: distance"}), lines[i] - lines[i - 1]);
        lines_[k].push_back(static_cast<T>(lines[i]));
      }
      total *= static_cast<double>(lines.size() - 1);
      require(total < 2147483648.0, name, lines.size(), "gives more than 2^31 cells");
      measure(static_cast<int>(k));
    }
  }

  Index cell_count() const {
    Index n = 1;
    for (int k = 0; k < D; ++k) n *= cells(k);
    return n;
  }
  /// Cells along axis k.
  Index cells(int k) const { return static_cast<Index>(of(k).size() - 1); }
  /// Line i along axis k, m.
  T line(int k, Index i) const { return of(k)[i]; }
  std::span<const T> lines(int k) const { return of(k); }
  const Point& lower() const { return lower_; }
  T upper(int k) const { return of(k).back(); }

  /// Lines as the knots of splines: `knots(k)(i, j)` is line i + j, or that of the face beyond it.
  class Knots {
   public:
    explicit Knots(std::span<const T> lines) : lines_{lines} {}
    T operator()(Index i, int shift) const {
      const auto at = static_cast<std::int64_t>(i) + shift,
                 last = static_cast<std::int64_t>(lines_.size()) - 1;
      return lines_[static_cast<std::size_t>(std::clamp<std::int64_t>(at, 0, last))];
    }

   private:
    std::span<const T> lines_;
  };
  Knots knots(int k) const { return Knots(lines(k)); }

  /// Place of a cell along each axis.
  std::array<Index, dim> place(Index cell) const {
    std::array<Index, dim> at;
    for (std::size_t k = 0; k < dim; ++k) {
      const Index count = cells(static_cast<int>(k));
      at[k] = cell % count;
      cell /= count;
    }
    return at;
  }
  /// Lower corner of a cell, m, and its edges, m.
  Point corner(Index cell) const {
    const auto at = place(cell);
    Point x;
    for (int k = 0; k < D; ++k) x[k] = line(k, at[static_cast<std::size_t>(k)]);
    return x;
  }
  Point extent(Index cell) const {
    const auto at = place(cell);
    Point edge;
    for (int k = 0; k < D; ++k) {
      const Index i = at[static_cast<std::size_t>(k)];
      edge[k] = line(k, i + 1) - line(k, i);
    }
    return edge;
  }
  /// Size of a cell, that the stable step is made from, m: its smallest edge, or that of a neighbour, on
  /// which splines depend.
  T size(Index cell) const {
    const auto at = place(cell);
    T least = std::numeric_limits<T>::infinity();
    for (std::size_t k = 0; k < dim; ++k) least = std::min(least, least_[k][at[k]]);
    return least;
  }
  /// Smallest size of the cells, at any node, m.
  T node_size(Index) const { return smallest_; }
  /// Area or volume of a cell, m^D.
  T volume(Index cell) const { return extent(cell).prod(); }

  /// Test for one cell, made once for many positions: that of `walk`.
  struct Holder {
    std::array<T, dim> from, below;  // m
    /// Whether positions lie in the cell; `P`: T, or a pack of positions.
    template <class P>
    auto holds(const std::array<P, dim>& x) const {
      decltype(x[0] < x[0]) inside(true);
      for (std::size_t k = 0; k < dim; ++k) inside = inside && x[k] >= P(from[k]) && x[k] < P(below[k]);
      return inside;
    }
  };
  Holder holder(Index cell) const {
    Holder h;
    const auto at = place(cell);
    for (std::size_t k = 0; k < dim; ++k) {
      h.from[k] = lines_[k][at[k]];
      h.below[k] = at[k] + 2 == lines_[k].size() ? end_[k] : lines_[k][at[k] + 1];
    }
    return h;
  }

  /// The cell that contains x, or `none` outside of the box (or for NaN). The upper faces belong to the last
  /// cells. Along each axis the hint and its neighbours are tried first, then all by bisection.
  Index walk(const Point& x, Index hint = none) const {
    std::array<Index, dim> at{};
    if (hint != none) at = place(hint);
    Index cell = 0;
    for (int k = D - 1; k >= 0; --k) {
      const auto axis = static_cast<std::size_t>(k);
      const auto& lines = lines_[axis];
      if (!(x[k] >= lines.front() && x[k] < end_[axis])) return none;
      const auto holds = [&](Index i) {
        return i + 1 < lines.size() && x[k] >= lines[i] && x[k] < lines[i + 1];
      };
      Index i = at[axis];
      if (!holds(i)) {
        if (holds(i + 1))
          ++i;
        else if (i > 0 && holds(i - 1))
          --i;
        else
          i = std::min(
              static_cast<Index>(std::upper_bound(lines.begin(), lines.end(), x[k]) - lines.begin()) - 1,
              cells(k) - 1);
      }
      cell = cell * cells(k) + i;
    }
    return cell;
  }
  Index search(const Point& x) const { return walk(x); }

  /// Moves line i along axis k to `to(i)`, m. Returns the first line that is not above the one before, then
  /// nothing has moved, or `none`.
  template <class To>
  Index move(int k, To&& to) {
    auto& lines = lines_[static_cast<std::size_t>(k)];
    moved_.resize(lines.size());
    for (Index i = 0; i < lines.size(); ++i) {
      moved_[i] = to(i);
      if (i > 0 && !(moved_[i] > moved_[i - 1])) return i;
    }
    std::ranges::copy(moved_, lines.begin());
    measure(k);
    ++moves_;
    return none;
  }
  /// How often lines have moved.
  std::size_t moves() const { return moves_; }

 private:
  const std::vector<T>& of(int k) const { return lines_[static_cast<std::size_t>(k)]; }

  /// Renews what follows from the lines along an axis.
  void measure(int k) {
    const auto axis = static_cast<std::size_t>(k);
    const auto& lines = lines_[axis];
    lower_[k] = lines.front();
    // A position on the upper face is known to the round-off of its coordinate.
    const T round_off =
        4 * std::numeric_limits<T>::epsilon() * std::max(std::abs(lines.front()), std::abs(lines.back()));
    end_[axis] = std::nextafter(lines.back() + round_off, std::numeric_limits<T>::infinity());
    least_[axis].resize(lines.size() - 1);
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      T least = lines[i + 1] - lines[i];
      if (i > 0) least = std::min(least, lines[i] - lines[i - 1]);
      if (i + 2 < lines.size()) least = std::min(least, lines[i + 2] - lines[i + 1]);
      least_[axis][i] = least;
    }
    smallest_ = std::numeric_limits<T>::infinity();
    for (const auto& edges : least_)
      for (const T edge : edges) smallest_ = std::min(smallest_, edge);
  }

  std::array<std::vector<T>, dim> lines_;  // m
  std::array<std::vector<T>, dim>
      least_;                 // [cells along each axis] smallest edge of it and its neighbours, m
  std::array<T, dim> end_{};  // below which a position lies in the last cells, m
  Point lower_ = zeros<Point>();
  T smallest_ = 0;
  std::vector<T> moved_;
  std::size_t moves_ = 0;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
