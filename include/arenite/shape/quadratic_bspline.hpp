// Quadratic B-splines on a Cartesian grid, with open knots: the functions of the cells at the boundary are
// changed so that unity and linear fields are reproduced up to the faces, and only the nodes on a face have a
// value there.
#pragma once

#include <arenite/mesh/mesh.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Along an axis of n cells lie n + 2 functions on the knots 0, 0, 0, 1, 2, .., n, n, n (in cell edges); cell
/// c carries functions c, c + 1, c + 2. A node is placed at its Greville abscissa, the mean of its function's
/// two inner knots (0, 1/2, 3/2, .., n - 1/2, n), which is where a coefficient must sit for linear fields to
/// be reproduced (de Boor, A Practical Guide to Splines, ch. IX; for MPM: Steffen, Kirby, Berzins 2008,
/// doi:10.1002/nme.2360).
struct QuadraticBSpline {
  static constexpr bool constant_gradient = false;
  static constexpr const char* name = "QuadraticBSpline";
  /// Largest sum of (slope^2 / value) over the three functions along an axis, in cell edges, away from the
  /// grid's faces: 4 + (1 - 2 s)^2 / (1/2 + s - s^2) at the place s of a cell.
  static constexpr double steepness = 6;

  template <class M>
  static constexpr bool fits = !is_simplex_mesh<M>;

  template <class M>
  static Index node_count(const M& grid) {
    Index n = 1;
    for (int k = 0; k < M::dimension; ++k) n *= grid.cells(k) + 2;
    return n;
  }

  template <class M>
  static typename M::Point node_position(const M& grid, Index node) {
    typename M::Point x;
    for (int k = 0; k < M::dimension; ++k) {
      const Index nodes_on_axis = grid.cells(k) + 2;
      x[k] =
          grid.lower()[k] + grid.edge() * greville<typename M::scalar>(node % nodes_on_axis, grid.cells(k));
      node /= nodes_on_axis;
    }
    return x;
  }

  /// Greville abscissa of function i among those of n cells, in cell edges.
  template <class T>
  static T greville(Index i, Index n) {
    const auto knot = [n](Index j) { return static_cast<T>(j <= 2 ? 0 : std::min(j - 2, n)); };
    return (knot(i + 1) + knot(i + 2)) / 2;
  }

  /// The functions of one cell: made once a cell, evaluated for each of its points.
  template <class M>
  class Cell {
   public:
    using T = typename M::scalar;
    static constexpr int D = M::dimension;
    static constexpr std::size_t nodes_per_axis = 3;  ///< nodes along each axis
    static constexpr int size = D == 2 ? 9 : 27;
    using Weights = Vec<T, size>;
    using Gradients = Eigen::Matrix<T, D, size, Eigen::DontAlign>;

    Cell(const M& grid, Index cell)
        : lower_{grid.lower()}, corner_{lower_}, edge_{grid.edge()}, per_metre_{grid.inverse_edge()} {
      const auto place = grid.place(cell);
      std::array<Index, D> stride;
      Index first = 0;
      for (std::size_t k = 0; k < D; ++k) {
        const Index count = grid.cells(static_cast<int>(k));
        stride[k] = k == 0 ? 1 : stride[k - 1] * (grid.cells(static_cast<int>(k - 1)) + 2);
        first += place[k] * stride[k];
        corner_[static_cast<int>(k)] += edge_ * static_cast<T>(place[k]);
        const bool inner = place[k] > 0 && place[k] + 1 < count;
        if (inner) {
          before_[k] = after_[k] = T(1);
          first_[k] = last_[k] = T(0.5);
          const T at = static_cast<T>(place[k]) + T(0.5);  // greville(place + 1, count)
          along_[k] = {edge_ * (at - 1), edge_ * at, edge_ * (at + 1)};
        } else {
          before_[k] = place[k] == 0 ? T(0) : T(1);
          after_[k] = place[k] + 1 == count ? T(0) : T(1);
          first_[k] = 1 / (1 + before_[k]);
          last_[k] = 1 / (1 + after_[k]);
          for (Index i = 0; i < 3; ++i) along_[k][i] = edge_ * greville<T>(place[k] + i, count);
        }
      }
      repeat<size>([&](std::size_t i) {
        nodes[i] = first;
        repeat<D>([&](std::size_t k) { nodes[i] += static_cast<Index>(digit(i, k)) * stride[k]; });
      });
    }

    /// [3^D] values at x.
    Weights weights(const Vec<T, D>& x) const {
      const auto value = weights(as_array(x));
      return Eigen::Map<const Weights>(value.data());
    }

    /// [D x 3^D] gradients at x, 1/m.
    Gradients gradients(const Vec<T, D>& x) const {
      const auto slope = gradients(as_array(x));
      Gradients g;
      for (std::size_t k = 0; k < D; ++k)
        g.row(static_cast<int>(k)) = Eigen::Map<const Weights>(slope[k].data());
      return g;
    }

    /// [3^D] values at positions x [D] of a pack of points (or of one).
    template <class P>
    std::array<P, size> weights(const std::array<P, D>& x) const {
      return products(line_values(x));
    }

    /// [D][3^D] gradients at positions x [D] of a pack of points (or of one), 1/m.
    template <class P>
    std::array<std::array<P, size>, D> gradients(const std::array<P, D>& x) const {
      const auto value = line_values(x), slope = line_slopes(x);
      std::array<std::array<P, size>, D> g;
      for (std::size_t k = 0; k < D; ++k) {
        auto factor = value;
        factor[k] = slope[k];
        g[k] = products(factor);
      }
      return g;
    }

    /// Functions along each axis, whose products the functions of the cell are, at positions x of a pack:
    /// values [D][3], slopes [D][3] in 1/m.
    template <class P>
    std::array<std::array<P, 3>, D> line_values(const std::array<P, D>& x) const {
      std::array<std::array<P, 3>, D> value;
      repeat<D>([&](std::size_t k) { value[k] = values(k, local(k, x)); });
      return value;
    }
    template <class P>
    std::array<std::array<P, 3>, D> line_slopes(const std::array<P, D>& x) const {
      std::array<std::array<P, 3>, D> slope;
      repeat<D>([&](std::size_t k) { slope[k] = slopes(k, local(k, x)); });
      return slope;
    }

    /// 1 / sum w (x_i - x)^2 along each axis, 1/m2: the inverse inertia of APIC, which is diagonal on
    /// open knots. It vanishes only for a point on a face, where there is no motion about the point along
    /// that axis: 0 there.
    template <class P>
    std::array<P, D> inverse_inertia(const std::array<P, D>& x) const {
      std::array<P, D> inverse;
      for (std::size_t k = 0; k < D; ++k) {
        if (before_[k] + after_[k] == 2) {  // away from the faces it is a fourth of the squared edge
          inverse[k] = P(4 * per_metre_ * per_metre_);
          continue;
        }
        const P offset = x[k] - P(lower_[static_cast<int>(k)]);
        const auto w = values(k, local(k, x));
        P inertia(0);
        for (std::size_t i = 0; i < 3; ++i) inertia += w[i] * square(P(P(along_[k][i]) - offset));
        const auto some = inertia > P(std::numeric_limits<T>::epsilon() * edge_ * edge_);
        inverse[k] = select(some, P(P(1) / select(some, inertia, P(1))), P(0));
      }
      return inverse;
    }

    /// [D][3] offsets along each axis from positions x to the nodes, m: to node i that number `axis_index(i,
    /// axis)`.
    template <class P>
    std::array<std::array<P, 3>, D> offsets(const std::array<P, D>& x) const {
      std::array<std::array<P, 3>, D> offset;
      for (std::size_t k = 0; k < D; ++k)
        for (std::size_t i = 0; i < 3; ++i)
          offset[k][i] = P(along_[k][i]) - (x[k] - P(lower_[static_cast<int>(k)]));
      return offset;
    }
    static constexpr std::size_t axis_index(std::size_t i, std::size_t axis) { return digit(i, axis); }

    /// [D x 3^D] positions of the nodes, m.
    Gradients node_positions() const {
      Gradients x;
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t k = 0; k < D; ++k)
          x(static_cast<int>(k), static_cast<int>(i)) = lower_[static_cast<int>(k)] + along_[k][digit(i, k)];
      return x;
    }

    std::array<Index, size> nodes;

   private:
    static constexpr std::size_t digit(std::size_t i, std::size_t k) {
      return (k == 0 ? i : k == 1 ? i / 3 : i / 9) % 3;
    }

    static std::array<T, D> as_array(const Vec<T, D>& x) {
      std::array<T, D> a;
      for (std::size_t k = 0; k < D; ++k) a[k] = x[static_cast<int>(k)];
      return a;
    }

    // Place along axis k in the cell, 0 to 1.
    template <class P>
    P local(std::size_t k, const std::array<P, D>& x) const {
      return (x[k] - P(corner_[static_cast<int>(k)])) * P(per_metre_);
    }

    template <class P>
    static std::array<P, size> products(const std::array<std::array<P, 3>, D>& f) {
      std::array<P, size> p;
      for (std::size_t j = 0; j < size / 3; ++j) {
        P rest = f[1][j % 3];
        if constexpr (D == 3) rest = rest * f[2][j / 3];
        for (std::size_t i = 0; i < 3; ++i) p[3 * j + i] = f[0][i] * rest;
      }
      return p;
    }

    // Values and slopes along axis k by the recurrence of Cox and de Boor, written out for a cell [0, 1]
    // whose neighbouring spans `before_` and `after_` are 0 (at the boundary) or 1; `first_` and `last_` are
    // 1 / (1 + span).
    template <class P>
    std::array<P, 3> values(std::size_t k, const P& s) const {
      const P t = P(1) - s, low = t * P(first_[k]), high = s * P(last_[k]);
      // The middle one as a sum of what is not negative: 1 - the others would leave round-off at a face.
      return {t * low, (s + P(before_[k])) * low + (t + P(after_[k])) * high, s * high};
    }
    template <class P>
    std::array<P, 3> slopes(std::size_t k, const P& s) const {
      const P low = (s - P(1)) * P(2 * first_[k] * per_metre_), high = s * P(2 * last_[k] * per_metre_);
      return {low, -(low + high), high};
    }

    Vec<T, D> lower_, corner_;
    T edge_, per_metre_;
    std::array<T, D> before_, after_, first_, last_;
    std::array<std::array<T, 3>, D> along_;  // of the nodes from the grid's lower corner, m
  };
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
