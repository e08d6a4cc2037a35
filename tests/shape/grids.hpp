// Grids of few cells, and what every shape function on a grid must do there.
#pragma once

#include "catch.hpp"
#include "shapes.hpp"

namespace arenite::test {

template <int D, class T = double>
CartesianGrid<D, T> grid(std::array<int, D> n, double cell = 0.25, double lower = 0) {
  typename CartesianGrid<D, T>::Parameters p;
  for (std::size_t k = 0; k < D; ++k) {
    p.lower[k] = lower;
    p.upper[k] = lower + n[k] * cell;
  }
  p.cell = cell;
  return CartesianGrid<D, T>(p);
}

/// Unity, linear fields and gradients, on faces, edges and corners too, in grids of one cell and more.
/// `Differences`: gradients against differences of the values, which must be polynomials in each cell.
template <class Shape, class T, bool Differences = true>
void check_completeness() {
  const double scale = sizeof(T) == 8 ? 1 : 2e8;
  for (const auto& n : {std::array<int, 2>{1, 1}, {2, 2}, {1, 2}, {3, 1}, {4, 7}, {5, 4}})
    for (const double cell : {0.25, 0.1}) {
      const auto v = violations<Shape>(grid<2, T>(n, cell, -0.2));
      CHECK(v.worst() < 1e-14 * scale);
      CHECK((!Differences || v.difference < 2e-11 * scale));
    }
  for (const auto& n : {std::array<int, 3>{1, 1, 1}, {2, 2, 2}, {1, 2, 3}, {4, 3, 5}}) {
    const auto v = violations<Shape>(grid<3, T>(n, 0.1, -0.2));
    CHECK(v.worst() < 1e-14 * scale);
    CHECK((!Differences || v.difference < 2e-11 * scale));
  }
}

/// On a face only the nodes of the face have a value, at a corner only one.
template <class Shape>
void check_faces() {
  for (const auto& n : {std::array<int, 2>{1, 1}, {2, 2}, {3, 5}, {5, 3}}) {
    const auto g = grid<2>(n, 1);
    for (Index c = 0; c < g.cell_count(); ++c) {
      const typename Shape::template Cell<CartesianGrid<2>> cell(g, c);
      for (const double end : {0.0, static_cast<double>(n[0])}) {
        if (g.walk({end, g.corner(c)[1] + 0.4}) != c) continue;
        const auto w = cell.weights({end, g.corner(c)[1] + 0.4});
        for (int i = 0; i < w.size(); ++i)
          if (Shape::node_position(g, cell.nodes[static_cast<std::size_t>(i)])[0] != end) CHECK(w[i] == 0);
      }
    }
    const typename Shape::template Cell<CartesianGrid<2>> first(g, 0);
    CHECK(first.weights({0, 0}) == decltype(first)::Weights::Unit(0));
  }
}

/// Greatest jump of the values, or else of the slopes, from cell to cell.
template <class Shape>
double greatest_jump(bool of_slopes) {
  const auto g = grid<2>({6, 4}, 1);
  double jump = 0;
  for (const double x : {1.0, 2.0, 3.0, 4.0, 5.0})
    for (const double y : {0.3, 1.7, 3.9}) {
      const Index right = g.walk({x + 1e-9, y}), left = right - 1;
      Eigen::MatrixXd off = Eigen::MatrixXd::Zero(2, Shape::node_count(g));
      for (const auto& [c, sign] : {std::pair{left, 1.0}, {right, -1.0}}) {
        const typename Shape::template Cell<CartesianGrid<2>> cell(g, c);
        const auto w = cell.weights({x, y});
        const auto slope = cell.gradients({x, y});
        for (int i = 0; i < w.size(); ++i) {
          auto column = off.col(cell.nodes[static_cast<std::size_t>(i)]);
          if (of_slopes)
            column += sign * slope.col(i);
          else
            column[0] += sign * w[i];
        }
      }
      jump = std::max(jump, off.norm());
    }
  return jump;
}

/// Largest sum of slope^2 / value along an axis over a cell away from the faces, in cell edges.
template <class Shape>
double steepest() {
  const auto g = grid<2>({9, 9}, 1);
  const typename Shape::template Cell<CartesianGrid<2>> cell(g, 40);
  double most = 0;
  for (int k = 1; k < 2000; ++k) {
    const std::array<double, 2> x{4 + k / 2000.0, 4.5};
    const auto w = cell.line_values(x)[0], slope = cell.line_slopes(x)[0];
    double sum = 0;
    for (std::size_t i = 0; i < w.size(); ++i)
      if (w[i] > 0) sum += square(slope[i]) / w[i];
    most = std::max(most, sum);
  }
  return most;
}

}  // namespace arenite::test
