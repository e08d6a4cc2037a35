// Scatter (P2G): the points of a body give their mass, momentum and internal force to a node field.
#pragma once

#include <arenite/mesh/blocks.hpp>
#include <arenite/particles/body.hpp>
#include <arenite/transfer/affine.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>

namespace arenite {
namespace detail {

/// Local sums of a cell's nodes have four rows whatever the dimension: a register holds a column, and the
/// mass rides in the last.
template <class T, int Size>
using Quads = Eigen::Matrix<T, 4, Size>;

/// In-plane part of a symmetric tensor as [4 x D], the rows beyond D zero.
template <class T, int D>
Eigen::Matrix<T, 4, D> padded(const Sym<T, D>& s) {
  Eigen::Matrix<T, 4, D> m;
  if constexpr (D == 2)
    m << s[0], s[3], s[3], s[1], 0, 0, 0, 0;
  else
    m << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2], 0, 0, 0;
  return m;
}

/// Momentum and mass of a point: (m v, m), shape [4].
template <class T, int D>
Eigen::Matrix<T, 4, 1> momentum_and_mass(const Vec<T, D>& v, T m) {
  if constexpr (D == 2)
    return {m * v[0], m * v[1], T(0), m};
  else
    return {m * v[0], m * v[1], m * v[2], m};
}

/// Adds what a point hands to the nodes of its cell, its affine part too, to `sums` [4 x size].
template <class Transfer, class T, int D, class Points, class Weights, class Positions, class Sums>
void add_momentum(const Points& points, std::size_t p, const Weights& w,
                  [[maybe_unused]] const Positions& x_nodes, Sums& sums) {
  const T m = points.mass[p];
  if constexpr (Transfer::affine) {
    const Vec<T, D>& x = points.position[p];
    const Mat<T, D> c = m * handed_gradient<Transfer, T, D>(points.motion[p], w, x_nodes, x);
    auto own = momentum_and_mass<T, D>(points.velocity[p], m);
    own.template head<D>() -= c * x;
    sums.noalias() += own * w.transpose();
    sums.template topRows<D>().noalias() += c * (x_nodes * w.asDiagonal());
  } else {
    sums.noalias() += momentum_and_mass<T, D>(points.velocity[p], m) * w.transpose();
  }
}

/// Volume that a whole cell stands for, m3: exact for the linear thickness of axisymmetry.
template <class K, class M>
typename M::scalar whole_volume(const M& mesh, Index cell) {
  using T = typename M::scalar;
  if constexpr (!K::hoop) {
    return mesh.volume(cell);
  } else {
    typename M::Point centre = M::Point::Zero();
    for (const Index i : mesh.nodes(cell)) centre += mesh.position(i);
    centre /= static_cast<T>(mesh.nodes(cell).size());
    return mesh.volume(cell) * K::thickness(centre);
  }
}

}  // namespace detail

/// For each node: sum of w m, w m v (with the affine part), and the internal force -sum V sigma grad N (with
/// the hoop stress in axisymmetry), as in Sulsky, Chen, Schreyer 1994 (doi:10.1016/0045-7825(94)90112-0). The
/// field must have been cleared.
template <class K, class N, class M, class B, class Field>
void scatter(const N& numerics, const M& mesh, const Blocks& blocks, const B& body, Field& nodes) {
  using Shape = typename N::Shape;
  using Transfer = typename N::Transfer;
  using Cell = typename Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr int D = M::dimension, size = Cell::size;
  const auto& points = body.points;
  blocks.for_each_colored([&](Index c) {
    const auto in_cell = body.cells[c];
    if (in_cell.empty()) return;
    const Cell cell(mesh, c);
    detail::Quads<T, size> momentum = detail::Quads<T, size>::Zero(), force = momentum;
    [[maybe_unused]] Eigen::Matrix<T, D, size> mass_gradient = Eigen::Matrix<T, D, size>::Zero(), x_nodes;
    if constexpr (Transfer::affine) x_nodes = cell.node_positions();
    [[maybe_unused]] Sym<T, D> stress_volume{};
    [[maybe_unused]] T volume = 0, cell_mass = 0;
    [[maybe_unused]] Eigen::Matrix<T, size, 1> hoop = Eigen::Matrix<T, size, 1>::Zero();

    for (const Index p : in_cell) {
      const Vec<T, D>& x = points.position[p];
      const T v = points.volume[p];
      const auto w = cell.weights(x);
      detail::add_momentum<Transfer, T, D>(points, p, w, x_nodes, momentum);
      if constexpr (K::hoop) hoop += (v * points.stress[p][2] / x[0]) * w;
      if constexpr (Shape::constant_gradient) {
        stress_volume += v * points.stress[p];
        volume += v;
        cell_mass += points.mass[p];
      } else {
        const auto g = cell.gradients(x);
        force.noalias() -= detail::padded<T, D>(v * points.stress[p]) * g;
        if constexpr (Field::has_gradient) mass_gradient += points.mass[p] * g;
      }
    }
    if constexpr (Shape::constant_gradient) {
      if constexpr (N::AntiLocking::averages_stress) {
        const T whole = detail::whole_volume<K>(mesh, c);
        if (volume >= static_cast<T>(numerics.anti_locking.fill) * whole) {
          stress_volume *= whole / volume;
          hoop *= whole / volume;
        }
      }
      force.noalias() = -detail::padded<T, D>(stress_volume) * cell.gradient;
      if constexpr (Field::has_gradient) mass_gradient = cell_mass * cell.gradient;
    }
    if constexpr (K::hoop) force.row(0) -= hoop.transpose();
    for (int k = 0; k < size; ++k) {
      const Index i = cell.nodes[static_cast<std::size_t>(k)];
      nodes.mass[i] += momentum(3, k);
      nodes.start[i] += momentum.col(k).template head<D>();
      nodes.force[i] += force.col(k).template head<D>();
      if constexpr (Field::has_gradient) nodes.mass_gradient[i] += mass_gradient.col(k);
    }
  });
  static_cast<void>(numerics);
}

/// Node velocities from momentum and force: v = p / m, v^new = v + (f / m + g) dt. Nodes without mass stay at
/// rest. A node's mass counts as none below `mass_floor`, kg: so small that a division by it means nothing in
/// T.
template <class Field, class T, int D>
void advance(Field& nodes, const Vec<T, D>& gravity, T dt, T mass_floor) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (nodes.mass[i] <= mass_floor) {
        nodes.mass[i] = 0;
        nodes.start[i].setZero();
        nodes.velocity[i].setZero();
        continue;
      }
      const T inverse = 1 / nodes.mass[i];
      nodes.start[i] *= inverse;
      nodes.velocity[i] = nodes.start[i] + dt * (inverse * nodes.force[i] + gravity);
    }
  });
}

}  // namespace arenite
