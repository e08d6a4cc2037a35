// Requirements of every shape function, checked in all cells of a mesh: the largest violation of each.
#pragma once

#include <arenite/shape/shape.hpp>

#include "../mesh/sample_meshes.hpp"
#include "functions_at.hpp"

namespace arenite::test {

/// Largest violations over all cells; lengths in units of the mesh's extent, gradients times the cell's size.
struct Violations {
  double unity = 0;            ///< sum of weights - 1
  double linear = 0;           ///< sum of w x_i - x
  double gradient_sum = 0;     ///< sum of gradients
  double gradient_linear = 0;  ///< sum of x_i grad^T - identity
  double difference = 0;       ///< gradients against differences of the weights
  double negative = 0;         ///< least weight, if negative
  double position = 0;         ///< node_positions against node_position

  double worst() const {
    return std::max({unity, linear, gradient_sum, gradient_linear, negative, position});
  }
};

/// Positions where things may go wrong: random, at the corners, on edges and faces of the cell.
template <class M>
std::vector<typename M::Point> places_in(const M& mesh, Index c, std::mt19937& random) {
  using T = typename M::scalar;
  constexpr int D = M::dimension;
  std::vector<typename M::Point> places{random_point(mesh, c, random), random_point(mesh, c, random)};
  if constexpr (is_simplex_mesh<M>) {
    const auto& nodes = mesh.nodes(c);
    for (std::size_t k = 0; k <= D; ++k) {
      places.push_back(mesh.position(nodes[k]));
      places.push_back((mesh.position(nodes[k]) + mesh.position(nodes[(k + 1) % (D + 1)])) / T(2));
    }
  } else {
    // 0, 1/2, 1 along each axis: corners, edges, faces, centre.
    for (int i = 0; i < (D == 2 ? 9 : 27); ++i) {
      typename M::Point x = mesh.corner(c);
      for (int k = 0, rest = i; k < D; ++k, rest /= 3) x[k] += mesh.edge() * static_cast<T>(rest % 3) / T(2);
      places.push_back(x);
    }
  }
  return places;
}

template <class Shape, class M>
Violations violations(const M& mesh) {
  using T = typename M::scalar;
  constexpr int D = M::dimension;
  std::mt19937 random(7);
  Violations worst;
  const auto note = [](double& at, double value) { at = std::max(at, value); };
  double extent = 0;
  for (Index i = 0; i < Shape::node_count(mesh); ++i)
    extent = std::max(extent, of_any_size(Shape::node_position(mesh, i)).cwiseAbs().maxCoeff());
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const typename Shape::template Cell<M> cell(mesh, c);
    const double h = mesh.size(c);
    for (const auto& x : places_in(mesh, c, random)) {
      const FunctionsAt at(cell, x);
      note(worst.position, at.template off_nodes<Shape>(mesh, cell) / extent);
      note(worst.unity, at.off_unity());
      note(worst.linear, at.off_linear() / extent);
      note(worst.gradient_sum, at.gradient_sum() * h);
      note(worst.gradient_linear, at.off_identity() * h / extent);
      note(worst.negative, -at.least());
      const T step = static_cast<T>(h) * T(sizeof(T) == 8 ? 1e-3 : 1e-2);
      for (int k = 0; k < D; ++k) {
        // Of order 4: exact but for round-off for the functions of a cell, which are cubic at most.
        const auto values = [&](T n) {
          auto moved = x;
          moved[k] += n * step;
          return of_any_size(cell.weights(moved));
        };
        const auto across = [&](T n) -> Eigen::VectorXd { return values(n) - values(-n); };
        const Eigen::VectorXd slope = (8 * across(1) - across(2)) / (12 * static_cast<double>(step));
        note(worst.difference, (slope - at.gradient.row(k).transpose()).norm() * h);
      }
    }
  }
  return worst;
}

}  // namespace arenite::test
