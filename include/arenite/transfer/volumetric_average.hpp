// Volumetric average: the volumetric strain of each cell averaged with its neighbours' through the nodes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <span>
#include <vector>

#include <arenite/core/tensor.hpp>
#include <arenite/mesh/blocks.hpp>
#include <arenite/simd/kernel.hpp>
#include <arenite/simd/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A strain with another trace.
template <class P, int D>
Sym<P, D> with_trace(const Sym<P, D>& strain, const P& wanted) {
  return add_isotropic(strain, P((wanted - trace(strain)) * P(1.0 / 3)));
}

/// Volumetric strain of each cell of linear simplices after averaging over the nodes: the `StrainAverage` of
/// `NodalAveraging`. Reads the points' sums that `p2g` left, not the points.
///
/// Only the elastic part is averaged. With theta the strain of a cell, A the average and K the bulk modulus,
/// the mean stress K A theta is conjugate to theta, for V A is symmetric and positive semidefinite: the
/// scheme produces no energy. A dilation d is local. In K (A theta - d) it is not in the range of A; the
/// pressure of a cell then drives an expansion that does not lower it, and the flow rule then adds more
/// dilation. The dilation of the previous step is therefore kept out: the strain is A(theta - d) + d. Matter
/// that has separated is not averaged: a cell with an open point keeps its own strain and gives none to
/// its neighbours.
template <class T>
struct VolumetricAverage {
  std::vector<T> cell_strain;  ///< [cells] trace of the strain increment, mean over the cell's points
  std::vector<std::array<T, 2>> node_sums;  ///< [nodes] strain times volume (then strain), and volume

  /// Sums over the cells of a body, to the nodes.
  template <class K, class N, class M, class B, class Field>
  void sum(const M& mesh, const Blocks& blocks, const B& body, const Field& nodes, T dt) {
    const auto& u = nodes.strain_velocity();
    cell_strain.resize(mesh.cell_count());
    node_sums.assign(nodes.size(), {});
    blocks.for_each_colored([&](Index c) {
      if (!body.cells.empty(c)) add_cell<K, N>(mesh, body, u, dt, c);
    });
  }
  /// The strain of each cell from the sums.
  template <class M, class B>
  void finish(const M& mesh, const Blocks& blocks, const B& body) {
    parallel_chunks(node_sums.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (node_sums[i][1] != 0) node_sums[i][0] /= node_sums[i][1];
    });
    blocks.for_each([&](Index c) {
      if (body.cells.empty(c)) return;
      if (!body.cell_sums[c].open) {
        T sum = 0;
        for (const Index i : mesh.nodes(c)) sum += node_sums[i][0];
        cell_strain[c] = sum / static_cast<T>(mesh.nodes(c).size());
      }
      if constexpr (B::has_dilation) cell_strain[c] += body.cell_sums[c].dilation;
    });
  }

  /// The strain of a point in cell c: its own deviator with the trace of the cell.
  template <class P, int D>
  Sym<P, D> average(const Sym<P, D>& strain, Index c) const {
    return with_trace(strain, P(cell_strain[c]));
  }

  static constexpr int numbers_per_node = 2;
  /// All sums of the nodes.
  std::span<T> numbers() { return {node_sums.data()->data(), 2 * node_sums.size()}; }

 private:
  /// Strain and volume of one cell, added to its nodes.
  template <class K, class N, class M, class B, class Velocities>
  ARENITE_KERNEL void add_cell(const M& mesh, const B& body, const Velocities& u, T dt, Index c) {
    using Cell = typename N::Shape::template Cell<M>;
    constexpr std::size_t size = Cell::size;
    const Cell cell(mesh, c);
    const auto& sums = body.cell_sums[c];
    T divergence = 0;
    T ring = 0;  // volume times the rate of the hoop strain v_r / r, summed over the points, m3/s
    repeat<size>([&](std::size_t k) {
      const auto& v = u[cell.nodes[k]];
      repeat<static_cast<std::size_t>(M::dimension)>([&](std::size_t d) {
        divergence += v[static_cast<int>(d)] * cell.gradient(static_cast<int>(d), static_cast<int>(k));
      });
      if constexpr (K::hoop) ring += v[0] * sums.hoop[k];
    });
    cell_strain[c] = dt * (divergence + ring / sums.volume);
    if constexpr (B::has_dilation) cell_strain[c] -= sums.dilation;
    if (sums.open) return;
    Pack<T, 2> handed(sums.volume);
    handed.set(0, sums.volume * cell_strain[c]);
    for (const Index i : cell.nodes) {
      T* const to = node_sums[i].data();
      (Pack<T, 2>::load(to) + handed).store(to);
    }
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
