// Deform: strains from the node velocities, stresses from the law, and the points moved; one pass over the
// cells, or two where the volumetric strain is averaged over nodes first.
#pragma once

#include <arenite/transfer/law_batch.hpp>
#include <arenite/transfer/scatter.hpp>

namespace arenite {

/// Strain and spin of one step from the velocity gradient times dt, [D x D]; no strain out of plane.
template <class T, int D>
Increment<T, D> in_plane_increment(const Mat<T, D>& l) {
  Increment<T, D> inc;
  auto& e = inc.strain;
  e[0] = l(0, 0);
  e[1] = l(1, 1);
  e[3] = (l(0, 1) + l(1, 0)) / 2;
  inc.spin[0] = (l(0, 1) - l(1, 0)) / 2;
  if constexpr (D == 3) {
    e[2] = l(2, 2);
    e[4] = (l(1, 2) + l(2, 1)) / 2;
    e[5] = (l(2, 0) + l(0, 2)) / 2;
    inc.spin[1] = (l(1, 2) - l(2, 1)) / 2;
    inc.spin[2] = (l(2, 0) - l(0, 2)) / 2;
  }
  return inc;
}

/// Volumetric strain of each cell after averaging over the nodes, for `NodalAveraging`.
template <class T>
struct VolumetricAverage {
  std::vector<T> cell_strain;  ///< [cells] trace of the strain increment, mean over the cell's points
  std::vector<T> cell_weight;  ///< [cells] volume of the cell's points, m3
  std::vector<T> node_strain;  ///< [nodes] scratch
  std::vector<T> node_weight;  ///< [nodes] scratch

  template <class K, class N, class M, class B, class Field>
  void compute(const M& mesh, const Blocks& blocks, const B& body, const Field& nodes, T dt) {
    using Cell = typename N::Shape::template Cell<M>;
    constexpr int size = Cell::size;
    const auto& u = nodes.strain_velocity();
    cell_strain.assign(mesh.cell_count(), T(0));
    cell_weight.assign(mesh.cell_count(), T(0));
    node_strain.assign(nodes.size(), T(0));
    node_weight.assign(nodes.size(), T(0));
    blocks.for_each_colored([&](Index c) {
      const auto in_cell = body.cells[c];
      if (in_cell.empty()) return;
      const Cell cell(mesh, c);
      T divergence = 0, radial = 0, volume = 0;
      Eigen::Matrix<T, 1, size> v_r;
      for (int k = 0; k < size; ++k) {
        const auto& v = u[cell.nodes[static_cast<std::size_t>(k)]];
        divergence += v.dot(cell.gradient.col(k));
        v_r[k] = v[0];
      }
      for (const Index p : in_cell) {
        volume += body.points.volume[p];
        if constexpr (K::hoop)
          radial += body.points.volume[p] * v_r.dot(cell.weights(body.points.position[p]).transpose()) /
                    body.points.position[p][0];
      }
      cell_weight[c] = volume;
      cell_strain[c] = dt * (divergence + radial / volume);
      for (const Index i : cell.nodes) {
        node_strain[i] += volume * cell_strain[c];
        node_weight[i] += volume;
      }
    });
    blocks.for_each([&](Index c) {
      if (cell_weight[c] == 0) return;
      T sum = 0;
      for (const Index i : mesh.nodes(c)) sum += node_strain[i] / node_weight[i];
      cell_strain[c] = sum / static_cast<T>(mesh.nodes(c).size());
    });
  }
};

/// Updates stress, history and volume of each point by the law of its body, and moves it with the node
/// velocities.
template <class K, class N, class M, class B, class Field, class Average>
DeformSums deform(const N& numerics, const M& mesh, const Blocks& blocks, B& body, const Field& nodes,
                  typename M::scalar dt, Average& average) {
  using Cell = typename N::Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr int D = M::dimension, size = Cell::size;
  auto& points = body.points;
  const auto& strain_velocity = nodes.strain_velocity();
  if constexpr (N::AntiLocking::averages_strain)
    average.template compute<K, N>(mesh, blocks, body, nodes, dt);
  return blocks.reduce_blocks(
      DeformSums{},
      [&](Index begin, Index end) {
        const auto law = body.law;  // a copy: its moduli stay in registers
        DeformSums sums;
        LawBatch<T, D, N::register_bytes> batch;
        for (Index c = begin; c < end; ++c) {
          const auto in_cell = body.cells[c];
          if (in_cell.empty()) continue;
          const Cell cell(mesh, c);
          detail::Quads<T, size> v = detail::Quads<T, size>::Zero();
          Eigen::Matrix<T, D, size> u;
          for (int k = 0; k < size; ++k) {
            const Index i = cell.nodes[static_cast<std::size_t>(k)];
            v.col(k).template head<D>() = dt * nodes.velocity[i];
            u.col(k) = dt * strain_velocity[i];
          }
          [[maybe_unused]] Increment<T, D> of_cell;
          if constexpr (N::Shape::constant_gradient)
            of_cell = in_plane_increment<T, D>(u * cell.gradient.transpose());
          for (const Index p : in_cell) {
            Vec<T, D>& x = points.position[p];
            const auto w = cell.weights(x);
            Increment<T, D> inc;
            if constexpr (N::Shape::constant_gradient)
              inc = of_cell;
            else
              inc = in_plane_increment<T, D>(u * cell.gradients(x).transpose());
            if constexpr (K::hoop) inc.strain[2] = u.row(0).dot(w.transpose()) / x[0];
            if constexpr (N::AntiLocking::averages_strain)
              inc.strain =
                  add_isotropic(inc.strain, T((average.cell_strain[c] - trace(inc.strain)) * T(1.0 / 3)));
            const Eigen::Matrix<T, 4, 1> way = v * w;
            x += way.template head<D>();
            sums.check += static_cast<double>(x.sum() + points.velocity[p].sum());
            if (batch.full()) batch.flush(law, points, sums);
            batch.add(p, inc);
          }
          if constexpr (N::AntiLocking::averages_stress) {
            batch.flush(law, points, sums);
            average_stress<K>(numerics, mesh, c, in_cell, points);
          }
        }
        batch.flush(law, points, sums);
        return sums;
      },
      [](DeformSums a, const DeformSums& b) {
        return DeformSums{a.work + b.work, a.opened_volume + b.opened_volume, a.check + b.check};
      });
}

/// Gives the points of a filled cell their mean stress, weighted by volume.
template <class K, class N, class M, class P>
void average_stress(const N& numerics, const M& mesh, Index c, std::span<const Index> in_cell, P& points) {
  using T = typename M::scalar;
  Sym<T, M::dimension> mean{};
  T volume = 0;
  for (const Index p : in_cell) {
    mean += points.volume[p] * points.stress[p];
    volume += points.volume[p];
  }
  if (volume < static_cast<T>(numerics.anti_locking.fill) * detail::whole_volume<K>(mesh, c)) return;
  mean *= 1 / volume;
  for (const Index p : in_cell) points.stress[p] = mean;
}

}  // namespace arenite
