// What every shape function must do, checked in all cells of a mesh: the largest violation of each rule.
#pragma once

#include <arenite/shape/shape.hpp>

#include "../mesh/sample_meshes.hpp"

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
  const auto note = [](double& at, auto value) { at = std::max(at, static_cast<double>(value)); };
  T extent = 0;
  for (Index i = 0; i < Shape::node_count(mesh); ++i)
    extent = std::max(extent, Shape::node_position(mesh, i).template lpNorm<Eigen::Infinity>());
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const typename Shape::template Cell<M> cell(mesh, c);
    const T h = mesh.size(c);
    const auto x_nodes = cell.node_positions();
    for (int k = 0; k < x_nodes.cols(); ++k)
      note(worst.position,
           (x_nodes.col(k) - Shape::node_position(mesh, cell.nodes[static_cast<std::size_t>(k)])).norm() /
               extent);
    for (const auto& x : places_in(mesh, c, random)) {
      const auto w = cell.weights(x);
      const auto g = cell.gradients(x);
      note(worst.unity, std::abs(w.sum() - 1));
      note(worst.linear, (x_nodes * w - x).norm() / extent);
      note(worst.gradient_sum, g.rowwise().sum().norm() * h);
      note(worst.gradient_linear, (x_nodes * g.transpose() - Mat<T, D>::Identity()).norm() * h / extent);
      note(worst.negative, -w.minCoeff());
      const T step = h * T(sizeof(T) == 8 ? 1e-3 : 1e-2);
      for (int k = 0; k < D; ++k) {
        // Of order 4: exact but for round-off for the functions of a cell, which are cubic at most.
        const typename M::Point e = step * M::Point::Unit(k);
        const auto across = [&](T n) { return (cell.weights(x + n * e) - cell.weights(x - n * e)).eval(); };
        const auto slope = ((8 * across(1) - across(2)) / (12 * step)).eval();
        note(worst.difference, (slope.transpose() - g.row(k)).norm() * h);
      }
    }
  }
  return worst;
}

}  // namespace arenite::test
