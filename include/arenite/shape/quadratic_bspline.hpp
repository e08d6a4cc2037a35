// Quadratic B-splines on a Cartesian grid, with open knots: the functions of the cells at the boundary are
// changed so that unity and linear fields are reproduced up to the faces, and only the nodes on a face have a
// value there.
#pragma once

#include <arenite/mesh/mesh.hpp>

namespace arenite {

/// Along an axis of n cells lie n + 2 functions on the knots 0, 0, 0, 1, 2, .., n, n, n (in cell edges); cell
/// c carries functions c, c + 1, c + 2. A node is placed at its Greville abscissa, the mean of its function's
/// two inner knots (0, 1/2, 3/2, .., n - 1/2, n), which is where a coefficient must sit for linear fields to
/// be reproduced (de Boor, A Practical Guide to Splines, ch. IX; for MPM: Steffen, Kirby, Berzins 2008,
/// doi:10.1002/nme.2360).
struct QuadraticBSpline {
  static constexpr bool constant_gradient = false;
  static constexpr const char* name = "QuadraticBSpline";

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
      const Index along = grid.cells(k) + 2;
      x[k] = grid.lower()[k] + grid.edge() * greville<typename M::scalar>(node % along, grid.cells(k));
      node /= along;
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
    static constexpr int size = D == 2 ? 9 : 27;
    using Weights = Eigen::Matrix<T, size, 1>;
    using Gradients = Eigen::Matrix<T, D, size>;

    Cell(const M& grid, Index cell) : grid_{&grid}, place_{grid.place(cell)}, per_metre_{1 / grid.edge()} {
      corner_ = grid.corner(cell);
      for (std::size_t k = 0; k < D; ++k) {
        first_[k] = place_[k] == 0 ? T(1) : T(2);
        last_[k] = place_[k] + 1 == grid.cells(static_cast<int>(k)) ? T(1) : T(2);
      }
      for (int i = 0; i < size; ++i) {
        Index node = 0;
        for (std::size_t k = D; k-- > 0;)
          node = node * (grid.cells(static_cast<int>(k)) + 2) + place_[k] + static_cast<Index>(digit(i, k));
        nodes[static_cast<std::size_t>(i)] = node;
      }
    }

    /// [3^D] values at x.
    Weights weights(const Vec<T, D>& x) const {
      std::array<std::array<T, 3>, D> value, slope;
      line(x, value, slope);
      Weights w;
      for (int i = 0; i < size; ++i) w[i] = product(value, i);
      return w;
    }

    /// [D x 3^D] gradients at x, 1/m.
    Gradients gradients(const Vec<T, D>& x) const {
      std::array<std::array<T, 3>, D> value, slope;
      line(x, value, slope);
      Gradients g;
      for (std::size_t k = 0; k < D; ++k) {
        auto factor = value;
        factor[k] = slope[k];
        for (int i = 0; i < size; ++i) g(static_cast<int>(k), i) = product(factor, i);
      }
      return g;
    }

    /// [D x 3^D] positions of the nodes, m.
    Gradients node_positions() const {
      Gradients x;
      for (int i = 0; i < size; ++i)
        for (std::size_t k = 0; k < D; ++k)
          x(static_cast<int>(k), i) = grid_->lower()[static_cast<int>(k)] +
                                      grid_->edge() * greville<T>(place_[k] + static_cast<Index>(digit(i, k)),
                                                                  grid_->cells(static_cast<int>(k)));
      return x;
    }

    std::array<Index, size> nodes;

   private:
    static constexpr int digit(int i, std::size_t k) { return (k == 0 ? i : k == 1 ? i / 3 : i / 9) % 3; }

    static T product(const std::array<std::array<T, 3>, D>& f, int i) {
      T p = f[0][static_cast<std::size_t>(digit(i, 0))] * f[1][static_cast<std::size_t>(digit(i, 1))];
      if constexpr (D == 3) p *= f[2][static_cast<std::size_t>(digit(i, 2))];
      return p;
    }

    // Values and slopes along each axis by the recurrence of Cox and de Boor, written out for a cell [0, 1]
    // whose neighbouring spans `first - 1` and `last - 1` are 0 (at the boundary) or 1.
    void line(const Vec<T, D>& x, std::array<std::array<T, 3>, D>& value,
              std::array<std::array<T, 3>, D>& slope) const {
      for (std::size_t k = 0; k < D; ++k) {
        const T s = (x[static_cast<int>(k)] - corner_[static_cast<int>(k)]) * per_metre_;
        const T a = first_[k], b = last_[k];
        value[k] = {(1 - s) * (1 - s) / a, (s + a - 1) * (1 - s) / a + (b - s) * s / b, s * s / b};
        slope[k] = {-2 * (1 - s) / a * per_metre_, T(0), 2 * s / b * per_metre_};
        slope[k][1] = -(slope[k][0] + slope[k][2]);
      }
    }

    const M* grid_;
    std::array<Index, D> place_;
    T per_metre_;
    Vec<T, D> corner_;
    std::array<T, D> first_, last_;
  };
};

}  // namespace arenite
