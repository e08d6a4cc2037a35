// Cartesian grid: equal square or cubic cells in a box. The shape function determines which nodes
// it has.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <limits>

#include <arenite/core/cold.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/mesh/cell_size.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Cells are numbered with axis 0 running fastest.
template <int D, real_scalar T = double>
class CartesianGrid {
 public:
  static constexpr int dimension = D;
  using scalar = T;
  using Point = Vec<T, D>;

  struct Parameters {
    std::array<double, D> lower = [] {
      std::array<double, D> a;
      a.fill(std::numeric_limits<double>::quiet_NaN());
      return a;
    }();                                                     ///< lower corner, m
    std::array<double, D> upper = lower;                     ///< upper corner, m
    double cell = std::numeric_limits<double>::quiet_NaN();  ///< edge of a cell, m; must divide each extent
  };

  /// Throws `error` if the box is empty, if the cell does not divide it or has a size that T does not allow,
  /// or if there are more than 2^31 cells.
  explicit CartesianGrid(const Parameters& p);

  Index cell_count() const {
    Index n = 1;
    for (const Index c : count_) n *= c;
    return n;
  }
  /// Cells along axis k.
  Index cells(int k) const { return count_[static_cast<std::size_t>(k)]; }
  /// Edge of a cell, m.
  T edge() const { return edge_; }
  /// 1 / edge, 1/m.
  T inverse_edge() const { return inverse_edge_; }
  /// Size of a cell, that the stable step is made from: its edge, m.
  T size(Index) const { return edge_; }
  /// Smallest size of the cells at a node, of any shape function, m.
  T node_size(Index) const { return edge_; }
  /// Area or volume of a cell, m^D.
  T volume(Index) const { return D == 2 ? edge_ * edge_ : edge_ * edge_ * edge_; }
  const Point& lower() const { return lower_; }
  T upper(int k) const { return lower_[k] + edge_ * static_cast<T>(cells(k)); }

  /// Place of a cell along each axis.
  std::array<Index, D> place(Index cell) const {
    std::array<Index, D> at;
    for (std::size_t k = 0; k < D; ++k) {
      at[k] = cell % count_[k];
      cell /= count_[k];
    }
    return at;
  }

  /// Edges of a cell, m.
  Point extent(Index) const { return filled<Point>(edge_); }
  /// Lower corner of a cell, m.
  Point corner(Index cell) const {
    const auto at = place(cell);
    Point x = lower_;
    for (std::size_t k = 0; k < D; ++k) x[static_cast<int>(k)] += edge_ * static_cast<T>(at[k]);
    return x;
  }

  /// Test for one cell, made once for many positions: that of `walk`.
  struct Holder {
    Point lower;
    T inverse_edge;
    std::array<T, D> from, below;  // in cell edges
    /// Whether positions lie in the cell; `P`: T, or a pack of positions.
    template <class P>
    auto holds(const std::array<P, D>& x) const {
      decltype(x[0] < x[0]) inside(true);
      for (std::size_t k = 0; k < D; ++k) {
        const P s = (x[k] - P(lower[static_cast<int>(k)])) * P(inverse_edge);
        inside = inside && s >= P(from[k]) && s < P(below[k]);
      }
      return inside;
    }
  };
  Holder holder(Index cell) const {
    Holder h{lower_, inverse_edge_, {}, {}};
    const auto at = place(cell);
    for (std::size_t k = 0; k < D; ++k) {
      h.from[k] = static_cast<T>(at[k]);
      h.below[k] = at[k] + 1 == count_[k] ? std::nextafter(end_[k], std::numeric_limits<T>::infinity())
                                          : static_cast<T>(at[k] + 1);
    }
    return h;
  }

  /// The cell that contains x, or `none` outside of the box (or for NaN). The upper faces belong to the last
  /// cells.
  Index walk(const Point& x, Index = none) const {
    Index cell = 0;
    for (int k = D - 1; k >= 0; --k) {
      const T s = (x[k] - lower_[k]) * inverse_edge_;
      if (!(s >= 0 && s <= end_[static_cast<std::size_t>(k)])) return none;
      cell = cell * cells(k) + std::min(static_cast<Index>(s), cells(k) - 1);
    }
    return cell;
  }
  Index search(const Point& x) const { return walk(x); }

 private:
  std::array<Index, D> count_{};
  std::array<T, D> end_{};  // cells along each axis, and the round-off of a position on the upper face
  Point lower_ = zeros<Point>();
  T edge_;
  T inverse_edge_ = 0;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <int D, real_scalar T>
ARENITE_COLD CartesianGrid<D, T>::CartesianGrid(const Parameters& p) : edge_{static_cast<T>(p.cell)} {
  require(p.cell > 0 && std::isfinite(p.cell), "CartesianGrid.cell", p.cell, "must be positive");
  detail::check_edge<T>("CartesianGrid.cell", p.cell);
  double total = 1;
  for (std::size_t k = 0; k < D; ++k) {
    const double extent = p.upper[k] - p.lower[k];
    require(extent > 0 && std::isfinite(extent), {"CartesianGrid.upper[", k, "]"}, p.upper[k],
            {"must be finite and exceed lower = ", p.lower[k]});
    const double cells = std::round(extent / p.cell);
    require(cells >= 1 && std::abs(cells * p.cell - extent) <= 1e-6 * p.cell, "CartesianGrid.cell", p.cell,
            {"must divide the extent ", extent, " along axis ", k});
    lower_[static_cast<int>(k)] = static_cast<T>(p.lower[k]);
    total *= cells;
    require(total < 2147483648.0, "CartesianGrid.cell", p.cell, "gives more than 2^31 cells");
    count_[k] = static_cast<Index>(cells);
    // A position on the upper face is known to the round-off of its coordinate.
    const double size = cells + std::abs(p.lower[k]) / p.cell;
    end_[k] = static_cast<T>(cells + 4 * static_cast<double>(std::numeric_limits<T>::epsilon()) * size);
  }
  inverse_edge_ = 1 / edge_;
}

#define ARENITE_INSTANCES(T, D) template CartesianGrid<D, T>::CartesianGrid(const Parameters&);
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
