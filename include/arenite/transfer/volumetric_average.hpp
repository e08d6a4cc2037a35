// Volumetric average: the volumetric strain of each cell averaged with its neighbours' through the nodes.
#pragma once

#include <array>
#include <vector>

#include <arenite/core/lanes.hpp>
#include <arenite/mesh/blocks.hpp>

namespace arenite {

/// Volumetric strain of each cell after averaging over the nodes, for policies with `averages_strain`.
template <class T>
struct VolumetricAverage {
  std::vector<T> cell_strain;  ///< [cells] trace of the strain increment, mean over the cell's points
  std::vector<T> cell_weight;  ///< [cells] volume of the cell's points, m3
  std::vector<std::array<T, 2>> node_sums;  ///< [nodes] strain times weight (then strain), and weight

  template <class K, class N, class M, class B, class Field>
  void compute(const M& mesh, const Blocks& blocks, const B& body, const Field& nodes, T dt) {
    const auto& u = nodes.strain_velocity();
    cell_strain.resize(mesh.cell_count());
    cell_weight.resize(mesh.cell_count());
    node_sums.assign(nodes.size(), {});
    blocks.for_each_colored([&](Index c) {
      if (body.cells.empty(c))
        cell_weight[c] = 0;
      else
        add_cell<K, N>(mesh, body, u, dt, c);
    });
    parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (node_sums[i][1] != 0) node_sums[i][0] /= node_sums[i][1];
    });
    blocks.for_each([&](Index c) {
      if (cell_weight[c] == 0) return;
      T sum = 0;
      for (const Index i : mesh.nodes(c)) sum += node_sums[i][0];
      cell_strain[c] = sum / static_cast<T>(mesh.nodes(c).size());
    });
  }

 private:
  /// Strain and volume of one cell, added to its nodes.
  template <class K, class N, class M, class B, class Velocities>
  [[gnu::flatten]] void add_cell(const M& mesh, const B& body, const Velocities& u, T dt, Index c) {
    using Cell = typename N::Shape::template Cell<M>;
    constexpr std::size_t size = Cell::size;
    constexpr int width = N::template width<T>;
    using P = lanes_of<T, width>;
    const auto& points = body.points;
    const Cell cell(mesh, c);
    T divergence = 0;
    std::array<T, size> radial;
    repeat<size>([&](std::size_t k) {
      const auto& v = u[cell.nodes[k]];
      repeat<static_cast<std::size_t>(M::dimension)>([&](std::size_t d) {
        divergence += v[static_cast<int>(d)] * cell.gradient(static_cast<int>(d), static_cast<int>(k));
      });
      radial[k] = v[0];
    });
    std::array<P, 2> sums{
        P(0), P(0)};  // of the volume, and of the volume times the rate of the hoop strain v_r / r
    body.cells.template for_packs<width>(c, [&](Index first, int count) {
      const P volume = load_lanes<P>(points.volume.data() + first, count);
      sums[0] += volume;
      if constexpr (K::hoop) {
        const auto x = points.position.template load_repeated<P>(first, count);
        const auto w = cell.weights(x);
        P v(0);
        repeat<size>([&](std::size_t k) { v += w[k] * P(radial[k]); });
        sums[1] += volume * v * reciprocal(x[0]);
      }
    });
    const auto total = lane_sums(sums);
    cell_weight[c] = total[0];
    cell_strain[c] = dt * (divergence + total[1] / total[0]);
    const auto handed = [&] {
      Pack<T, 2> a(total[0]);
      a.set(0, total[0] * cell_strain[c]);
      return a;
    }();
    for (const Index i : cell.nodes) {
      T* const to = node_sums[i].data();
      (Pack<T, 2>::load(to) + handed).store(to);
    }
  }
};

}  // namespace arenite
