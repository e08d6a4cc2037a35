// Scatter (P2G): the points of a body give their mass, momentum and internal force to a node field.
#pragma once

#include <arenite/mesh/blocks.hpp>
#include <arenite/particles/body.hpp>
#include <arenite/transfer/affine.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>

namespace arenite {
namespace detail {

/// Adds what a pack of points at x, of mass m (0 in lanes without a point) and velocity v, hands to the nodes
/// of its cell, the affine part too, to `sums`: `Stride` a node, the components of the momentum first.
template <class Transfer, std::size_t Stride, class Cell, class P, std::size_t D, class Points, class Sums>
void add_momentum(const Cell& cell, const Points& points, Index first, int count, const P& m,
                  const std::array<P, Cell::size>& w, const std::array<P, D>& x, const std::array<P, D>& v,
                  Sums& sums) {
  std::array<P, D> own;
  repeat<D>([&](std::size_t d) { own[d] = m * v[d]; });
  if constexpr (Transfer::affine) {
    auto c = handed_gradient<Transfer>(cell, points.motion.template load<P>(first, count), x);
    for (P& value : c) value = value * m;
    const auto ways = cell.ways(x);
    repeat<Cell::size>([&](std::size_t i) {
      repeat<D>([&](std::size_t d) {
        P handed = own[d];
        repeat<D>([&](std::size_t a) { handed += c[a * D + d] * ways[a][Cell::along(i, a)]; });
        sums[i * Stride + d] += w[i] * handed;
      });
    });
  } else {
    repeat<Cell::size>(
        [&](std::size_t i) { repeat<D>([&](std::size_t d) { sums[i * Stride + d] += w[i] * own[d]; }); });
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

/// Sums over the points of a cell whose functions have constant gradients, as one row of scalars or packs:
/// for each node momentum [D] and mass; then the stress times volume, the hoop stress' share of each node and
/// the volume.
template <class K, class Cell>
struct ScatterSums {
  static constexpr std::size_t D = Cell::D, nodes = Cell::size, stress_size = Sym<double, Cell::D>::size;
  static constexpr std::size_t per_node = D + 1;
  static constexpr std::size_t stress = nodes * per_node;
  static constexpr std::size_t hoop = stress + stress_size;
  static constexpr std::size_t volume = hoop + (K::hoop ? nodes : 0);
  static constexpr std::size_t size = volume + 1;
};

/// Scatters the points of a cell with constant gradients: one product of stress and gradient a node.
template <class K, class N, class M, class B, class Field>
[[gnu::flatten]] void scatter_simplex([[maybe_unused]] const N& numerics, const M& mesh, const B& body,
                                      Index c, Field& nodes) {
  using Cell = typename N::Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr std::size_t D = M::dimension, size = Cell::size;
  constexpr int width = N::template width<T>;
  using P = lanes_of<T, width>;
  using Row = ScatterSums<K, Cell>;
  const auto& points = body.points;
  const Cell cell(mesh, c);
  std::array<P, Row::size> sums;
  repeat<Row::size>([&](std::size_t k) { sums[k] = P(0); });
  body.cells.template for_packs<width>(c, [&](Index first, int count) {
    const auto x = points.position.template load_repeated<P>(first, count);
    const auto v = points.velocity.template load<P>(first, count);
    const auto stress = points.stress.template load<P>(first, count);
    const P m = load_lanes<P>(points.mass.data() + first, count);
    const P volume = load_lanes<P>(points.volume.data() + first, count);
    const auto w = cell.weights(x);
    add_momentum<typename N::Transfer, Row::per_node>(cell, points, first, count, m, w, x, v, sums);
    repeat<size>([&](std::size_t i) { sums[i * Row::per_node + D] += w[i] * m; });
    repeat<Row::stress_size>([&](std::size_t k) { sums[Row::stress + k] += volume * stress[k]; });
    sums[Row::volume] += volume;
    if constexpr (K::hoop) {
      const P pull = volume * stress[2] * reciprocal(x[0]);
      repeat<size>([&](std::size_t i) { sums[Row::hoop + i] += pull * w[i]; });
    }
  });
  auto total = lane_sums(sums);
  if constexpr (N::AntiLocking::averages_stress) {
    const T whole = whole_volume<K>(mesh, c);
    if (total[Row::volume] >= static_cast<T>(numerics.anti_locking.fill) * whole)
      for (std::size_t k = Row::stress; k < Row::volume; ++k) total[k] *= whole / total[Row::volume];
  }
  // Columns of the stress as packs: a node's force is their sum, each times a component of the gradient.
  using V = NodePack<T, static_cast<int>(D)>;
  std::array<V, D> column;
  for (std::size_t a = 0; a < D; ++a) {
    column[a] = V(0);
    for (std::size_t d = 0; d < D; ++d)
      column[a].set(static_cast<int>(d), total[Row::stress + Sym<T, D>::index(d, a)]);
  }
  T mass = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const Index node = cell.nodes[i];
    const auto g = cell.gradient.col(static_cast<int>(i));
    V force(0);
    for (std::size_t a = 0; a < D; ++a) force -= column[a] * V(g[static_cast<int>(a)]);
    if constexpr (K::hoop) force.set(0, force[0] - total[Row::hoop + i]);
    nodes.force.add(node, force);
    nodes.start.add(node, V::load(&total[i * Row::per_node]));
    nodes.mass[node] += total[i * Row::per_node + D];
    mass += total[i * Row::per_node + D];
  }
  if constexpr (Field::has_gradient)
    for (std::size_t i = 0; i < size; ++i)
      nodes.mass_gradient[cell.nodes[i]] += mass * cell.gradient.col(static_cast<int>(i));
}

/// Scatters a pack of points of a cell whose functions are products along the axes: what the nodes of one
/// line along x share is computed once.
template <class K, class N, class Cell, class Points, class Field>
[[gnu::flatten]] void scatter_product(const Cell& cell, const Points& points, Index first, int count,
                                      Field& nodes) {
  using Transfer = typename N::Transfer;
  using T = typename Cell::T;
  constexpr std::size_t D = Cell::D, layers = D == 2 ? 1 : 3;
  using P = lanes_of<T, N::template width<T>>;
  const auto x = points.position.template load_repeated<P>(first, count);
  const auto v = points.velocity.template load<P>(first, count);
  auto pull = points.stress.template load<P>(first, count);
  const P m = load_lanes<P>(points.mass.data() + first, count);
  const P volume = load_lanes<P>(points.volume.data() + first, count);
  for (P& s : pull) s = s * volume;
  const auto value = cell.line_values(x), slope = cell.line_slopes(x);
  [[maybe_unused]] const auto way = cell.ways(x);
  [[maybe_unused]] std::array<P, D * D> c;
  std::array<P, D> own;
  repeat<D>([&](std::size_t d) { own[d] = m * v[d]; });
  if constexpr (Transfer::affine) {
    c = handed_gradient<Transfer>(cell, points.motion.template load<P>(first, count), x);
    for (P& a : c) a = a * m;
  }
  // For each node momentum [D], mass, force [D], and the gradient of mass if it is wanted.
  constexpr std::size_t force = D + 1, gradient = force + D,
                        per_node = gradient + (Field::has_gradient ? D : 0);
  for (std::size_t k = 0; k < layers; ++k) {
    std::array<P, 9 * per_node> sums;
    auto in_layer = own;
    if constexpr (Transfer::affine && D == 3)
      repeat<D>([&](std::size_t d) { in_layer[d] += c[2 * D + d] * way[2][k]; });
    repeat<3>([&](std::size_t j) {
      P w = value[1][j], w_y = slope[1][j];
      [[maybe_unused]] P w_z;
      if constexpr (D == 3) {
        w_z = w * slope[2][k];
        w = w * value[2][k];
        w_y = w_y * value[2][k];
      }
      const P line_mass = w * m;
      std::array<P, D> at_x, along_x, pull_x, pull_rest;
      repeat<D>([&](std::size_t d) {
        P handed = in_layer[d];
        if constexpr (Transfer::affine) {
          handed += c[D + d] * way[1][j];
          along_x[d] = w * c[d];
        }
        at_x[d] = w * handed;
        pull_x[d] = w * pull[Sym<P, D>::index(d, 0)];
        pull_rest[d] = w_y * pull[Sym<P, D>::index(d, 1)];
        if constexpr (D == 3) pull_rest[d] += w_z * pull[Sym<P, D>::index(d, 2)];
        if constexpr (K::hoop)
          if (d == 0) pull_rest[d] += w * pull[2] * reciprocal(x[0]);
      });
      repeat<3>([&](std::size_t i) {
        P* const sum = &sums[(3 * j + i) * per_node];
        const P f = value[0][i], f_x = slope[0][i];
        sum[D] = f * line_mass;
        repeat<D>([&](std::size_t d) {
          P handed = at_x[d];
          if constexpr (Transfer::affine) handed += along_x[d] * way[0][i];
          sum[d] = f * handed;
          sum[force + d] = -(f_x * pull_x[d] + f * pull_rest[d]);
        });
        if constexpr (Field::has_gradient) {
          sum[gradient] = f_x * w * m;
          sum[gradient + 1] = f * w_y * m;
          if constexpr (D == 3) sum[gradient + 2] = f * w_z * m;
        }
      });
    });
    const auto total = lane_sums(sums);
    using V = NodePack<T, static_cast<int>(D)>;
    for (std::size_t i = 0; i < 9; ++i) {
      const Index node = cell.nodes[9 * k + i];
      const T* const sum = &total[i * per_node];
      nodes.start.add(node, V::load(sum));
      nodes.mass[node] += sum[D];
      nodes.force.add(node, V::load(sum + force));
      if constexpr (Field::has_gradient) nodes.mass_gradient.add(node, V::load(sum + gradient));
    }
  }
}

}  // namespace detail

/// For each node: sum of w m, w m v (with the affine part), and the internal force -sum V sigma grad N (with
/// the hoop stress in axisymmetry), as in Sulsky, Chen, Schreyer 1994 (doi:10.1016/0045-7825(94)90112-0). The
/// field must have been cleared.
template <class K, class N, class M, class B, class Field>
void scatter(const N& numerics, const M& mesh, const Blocks& blocks, const B& body, Field& nodes) {
  blocks.for_each_colored([&](Index c) {
    if (body.cells.empty(c)) return;
    if constexpr (N::Shape::constant_gradient) {
      detail::scatter_simplex<K>(numerics, mesh, body, c, nodes);
    } else {
      const typename N::Shape::template Cell<M> cell(mesh, c);
      body.cells.template for_packs<N::template width<typename M::scalar>>(c, [&](Index first, int count) {
        detail::scatter_product<K, N>(cell, body.points, first, count, nodes);
      });
    }
  });
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
