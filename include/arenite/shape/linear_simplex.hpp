// Linear shape functions on a simplex mesh: the barycentric coordinates. Their gradients are constant in a
// cell.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>

#include <arenite/mesh/mesh.hpp>
#include <arenite/simd/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Shape function of triangles (3 nodes a cell) and tetrahedra (4).
struct LinearSimplex {
  static constexpr bool constant_gradient = true;
  static constexpr const char* name = "LinearSimplex";
  static constexpr double steepness = std::numeric_limits<double>::infinity();
  /// Measured: docs/decisions.md.
  static constexpr double courant_limit(bool maps_back) { return maps_back ? 1.0 : 0.35; }

  template <class M>
  static constexpr bool fits = is_simplex_mesh<M>;

  template <class M>
  static Index node_count(const M& mesh) {
    return mesh.node_count();
  }
  template <class M>
  static typename M::Point node_position(const M& mesh, Index node) {
    return mesh.position(node);
  }

  /// Calls `f(j)` for the nodes j != i of each cell at node i: once for each cell that they share.
  template <class M, class F>
  static void for_each_neighbour(const M& mesh, Index i, F&& f) {
    for (const Index c : mesh.cells_at(i))
      for (const Index j : mesh.nodes(c))
        if (j != i) f(j);
  }

  /// The shape functions of one cell: made once a cell, evaluated for each of its points.
  template <class M>
  class Cell {
   public:
    using T = typename M::scalar;
    static constexpr int D = M::dimension;
    static constexpr int size = D + 1;
    using Weights = Vec<T, size>;
    using Gradients = Eigen::Matrix<T, D, size, Eigen::DontAlign>;

    Cell(const M& mesh, Index cell)
        : nodes{mesh.nodes(cell)}, mesh_{mesh}, frame_{mesh.frame(cell)}, origin_{mesh.origin(cell)} {
      gradient.template rightCols<D>() = frame_.inverse.transpose();
      gradient.col(0) = -gradient.template rightCols<D>().rowwise().sum();
    }

    /// [D + 1] values at x.
    Weights weights(const Vec<T, D>& x) const {
      Weights w;
      w.template tail<D>().noalias() = frame_.inverse * (x - origin_);
      w[0] = 1 - w.template tail<D>().sum();
      return w;
    }
    /// [D x (D + 1)] gradients, 1/m: the same everywhere in the cell.
    const Gradients& gradients(const Vec<T, D>&) const { return gradient; }

    /// [D + 1] values at positions x [D] of a pack of points (or of one).
    template <class P>
    std::array<P, size> weights(const std::array<P, D>& x) const {
      std::array<P, D> offset;
      repeat<D>([&](std::size_t d) { offset[d] = x[d] - P(origin_[static_cast<int>(d)]); });
      std::array<P, size> w;
      w[0] = P(1);
      repeat<D>([&](std::size_t k) {
        P value = P(frame_.inverse(static_cast<int>(k), 0)) * offset[0];
        repeat<D - 1>([&](std::size_t d) {
          value += P(frame_.inverse(static_cast<int>(k), static_cast<int>(d + 1))) * offset[d + 1];
        });
        w[k + 1] = value;
        w[0] -= value;
      });
      return w;
    }

    /// [D][D + 1] offsets along each axis from positions x to the nodes, m.
    template <class P>
    std::array<std::array<P, size>, D> offsets(const std::array<P, D>& x) const {
      std::array<std::array<P, size>, D> offset;
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t k = 0; k < D; ++k)
          offset[k][i] = P(mesh_.position(nodes[i])[static_cast<int>(k)]) - x[k];
      return offset;
    }

    /// [D x (D + 1)] positions of the nodes, m.
    Gradients node_positions() const {
      Gradients x;
      for (int k = 0; k < size; ++k) x.col(k) = mesh_.position(nodes[static_cast<std::size_t>(k)]);
      return x;
    }

    std::array<Index, size> nodes;
    Gradients gradient;

   private:
    const M& mesh_;
    const typename M::Frame& frame_;
    const Vec<T, D>& origin_;
  };
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
