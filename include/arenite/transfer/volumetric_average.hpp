// Volumetric average: the volumetric strain of each cell averaged with its neighbours' through the nodes.
#pragma once

#include <vector>

#include <arenite/core/lanes.hpp>
#include <arenite/mesh/blocks.hpp>

namespace arenite {

/// Volumetric strain of each cell after averaging over the nodes, for policies with `averages_strain`.
template <class T>
struct VolumetricAverage {
  std::vector<T> cell_strain;  ///< [cells] trace of the strain increment, mean over the cell's points
  std::vector<T> cell_weight;  ///< [cells] volume of the cell's points, m3
  std::vector<T> node_strain;  ///< [nodes] scratch
  std::vector<T> node_weight;  ///< [nodes] scratch

  template <class K, class N, class M, class B, class Field>
  void compute(const M& mesh, const Blocks& blocks, const B& body, const Field& nodes, T dt) {
    using Cell = typename N::Shape::template Cell<M>;
    constexpr std::size_t D = M::dimension, size = Cell::size;
    constexpr int width = N::template width<T>;
    using P = lanes_of<T, width>;
    const auto& points = body.points;
    const auto& u = nodes.strain_velocity();
    cell_strain.resize(mesh.cell_count());
    cell_weight.resize(mesh.cell_count());
    node_strain.assign(nodes.size(), T(0));
    node_weight.assign(nodes.size(), T(0));
    blocks.for_each_colored([&](Index c) {
      cell_weight[c] = 0;
      if (body.cells.empty(c)) return;
      const Cell cell(mesh, c);
      T divergence = 0;
      std::array<T, size> radial;
      for (std::size_t k = 0; k < size; ++k) {
        const auto& v = u[cell.nodes[k]];
        divergence += v.dot(cell.gradient.col(static_cast<int>(k)));
        radial[k] = v[0];
      }
      std::array<P, 2> sums{};  // of the volume, and of the volume times the hoop strain's rate
      body.cells.template for_packs<width>(c, [&](Index first, int count) {
        const P volume = load_lanes<P>(points.volume.data() + first, count);
        sums[0] += volume;
        if constexpr (K::hoop) {
          const auto x = points.position.template load_repeated<P>(first, count);
          sums[1] += volume * hoop_rate<D>(cell.weights(x), radial, x);
        }
      });
      const auto total = lane_sums(sums);
      cell_weight[c] = total[0];
      cell_strain[c] = dt * (divergence + total[1] / total[0]);
      for (const Index i : cell.nodes) {
        node_strain[i] += total[0] * cell_strain[c];
        node_weight[i] += total[0];
      }
    });
    blocks.for_each([&](Index c) {
      if (cell_weight[c] == 0) return;
      T sum = 0;
      for (const Index i : mesh.nodes(c)) sum += node_strain[i] / node_weight[i];
      cell_strain[c] = sum / static_cast<T>(mesh.nodes(c).size());
    });
  }

  /// Rate of the hoop strain v_r / r of points at x.
  template <std::size_t D, class P, std::size_t Size>
  static P hoop_rate(const std::array<P, Size>& w, const std::array<T, Size>& radial,
                     const std::array<P, D>& x) {
    P v(0);
    for (std::size_t k = 0; k < Size; ++k) v += w[k] * P(radial[k]);
    return v * reciprocal(x[0]);
  }
};

}  // namespace arenite
