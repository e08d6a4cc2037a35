// Scatter (P2G): the points of a body give their mass, momentum and internal force to a node field.
#pragma once

#include <arenite/mesh/blocks.hpp>
#include <arenite/particles/body.hpp>
#include <arenite/transfer/affine.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/point_rows.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// Adds the momentum that a pack of points at x hands to the nodes of its cell to `sums`, `Stride` a node,
/// from the points' shares `mw` of the nodes' masses (0 in lanes without a point) and their velocities v.
template <class Transfer, std::size_t Stride, class Cell, class P, std::size_t D, class Points, class Sums>
void add_momentum(const Cell& cell, const Points& points, Index first, int count,
                  const std::array<P, Cell::size>& mw, const std::array<P, D>& x, const std::array<P, D>& v,
                  Sums& sums) {
  if constexpr (Transfer::affine) {
    const auto c = points.motion.template load<P>(first, count);
    const auto ways = cell.ways(x);
    repeat<Cell::size>([&](std::size_t i) {
      repeat<D>([&](std::size_t d) {
        P handed = v[d];
        repeat<D>([&](std::size_t a) { handed += c[a * D + d] * ways[a][Cell::along(i, a)]; });
        sums[i * Stride + d] += mw[i] * handed;
      });
    });
  } else {
    repeat<Cell::size>(
        [&](std::size_t i) { repeat<D>([&](std::size_t d) { sums[i * Stride + d] += mw[i] * v[d]; }); });
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

/// Sums over the points of a cell that belong to its stress.
template <class T, int D>
struct StressSums {
  std::array<T, Sym<T, D>::size> stress;  ///< V times stress by component, N m
  T volume;                               ///< V, m3
  T bearing;                              ///< V of the points that are not open, m3
  T dilation;                             ///< V times dilation, m3; 0 if the points have none
};

template <int Width, class L, class T, int D, ExtraColumns Extra>
StressSums<T, D> stress_sums(const Body<L, T, D, Extra>& body, Index c) {
  using P = lanes_of<T, Width>;
  using B = Body<L, T, D, Extra>;
  constexpr std::size_t size = Sym<T, D>::size, open = size + 1, dilation = open + B::knows_opening;
  constexpr std::size_t count = dilation + B::has_dilation;
  const auto& points = body.points;
  std::array<P, count> sums;
  repeat<count>([&](std::size_t k) { sums[k] = P(0); });
  body.cells.template for_packs<Width>(c, [&](Index first, int n) {
    points.stress.template prefetch_ahead<Width>(first);
    prefetch_ahead<Width>(points.volume, first);
    const auto stress = points.stress.template load<P>(first, n);
    const P volume = load_lanes<P>(points.volume.data() + first, n);
    repeat<size>([&](std::size_t k) { sums[k] += volume * stress[k]; });
    sums[size] += volume;
    if constexpr (B::knows_opening)
      sums[open] += select(body.law.is_open(points.template load_history<P>(first, n)), volume, P(0));
    if constexpr (B::has_dilation) {
      prefetch_ahead<Width>(points.dilation, first);
      sums[dilation] += volume * load_lanes<P>(points.dilation.data() + first, n);
    }
  });
  const auto total = lane_sums(sums);
  StressSums<T, D> of_cell{{}, total[size], total[size], 0};
  repeat<size>([&](std::size_t k) { of_cell.stress[k] = total[k]; });
  if constexpr (B::knows_opening) of_cell.bearing -= total[open];
  if constexpr (B::has_dilation) of_cell.dilation = total[dilation];
  return of_cell;
}

/// What is summed over the points of a cell whose functions have constant gradients, beside the stress, as
/// one row of scalars or packs: for each node momentum [D] and mass; then each node's share of the hoop
/// stress and the parts of `CellSums`.
template <class K, class N, class Cell, bool CentresStress>
struct ScatterSums {
  static constexpr std::size_t nodes = Cell::size;
  // Four, as in the lower half of NodeSums: a load then takes what one store wrote.
  static constexpr std::size_t per_node = 4;
  static constexpr bool needs_hoop = K::hoop && (N::AntiLocking::averages_strain || CentresStress);
  static constexpr std::size_t edges = N::needs_edge_mass ? CellSums<double, Cell::D>::edges : 0;
  static constexpr std::size_t pull = nodes * per_node;  // of the hoop stress
  static constexpr std::size_t edge_mass = pull + (K::hoop ? nodes : 0);
  static constexpr std::size_t hoop = edge_mass + edges;
  static constexpr std::size_t size = hoop + (needs_hoop ? nodes : 0);
};

/// Scatters the points of a cell with constant gradients: one product of stress and gradient a node. Stresses
/// are summed in a loop of their own, so that the sums of each loop fit into the registers; their mean, where
/// it is asked for, is known before the points are looked at again.
template <class K, class N, class M, class B, class Field>
[[gnu::flatten]] void scatter_simplex([[maybe_unused]] const N& numerics, const M& mesh, B& body, Index c,
                                      Field& nodes) {
  using Cell = typename N::Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr std::size_t D = M::dimension, size = Cell::size;
  constexpr int width = N::template width<T>;
  using P = lanes_of<T, width>;
  constexpr bool centres_stress = N::template centres_stress<decltype(body.law)>;
  using Row = ScatterSums<K, N, Cell, centres_stress>;
  constexpr std::size_t stress_size = Sym<T, M::dimension>::size;
  auto& points = body.points;
  const Cell cell(mesh, c);
  auto of_stress = stress_sums<width>(body, c);
  auto& stress = of_stress.stress;
  const T volume = of_stress.volume;
  [[maybe_unused]] T whole = volume;  // what the stress is borne by
  if constexpr (N::AntiLocking::averages_stress) {
    const T of_cell = whole_volume<K>(mesh, c);
    if (volume >= static_cast<T>(numerics.anti_locking.fill) * of_cell) {
      whole = of_cell;
      std::array<P, stress_size> mean;
      const T bearing = of_stress.bearing > 0 ? of_stress.bearing : volume;
      repeat<stress_size>([&](std::size_t k) { mean[k] = P(stress[k] / bearing); });
      body.cells.template for_packs<width>(c, [&](Index first, int count) {
        auto given = mean;
        if constexpr (B::knows_opening) {
          const auto open = body.law.is_open(points.template load_history<P>(first, count));
          repeat<stress_size>([&](std::size_t k) { given[k] = select(open, P(0), mean[k]); });
        }
        points.stress.template store<P>(first, count, given);
      });
      repeat<stress_size>([&](std::size_t k) { stress[k] *= whole / volume; });
    }
  }
  if constexpr (centres_stress) body.cell_stress[c].c = stress;
  std::array<P, Row::size> sums;
  repeat<Row::size>([&](std::size_t k) { sums[k] = P(0); });
  body.cells.template for_packs<width>(c, [&](Index first, int count) {
    points.position.template prefetch_ahead<width>(first);
    points.velocity.template prefetch_ahead<width>(first);
    prefetch_ahead<width>(points.mass, first);
    const auto x = points.position.template load_repeated<P>(first, count);
    const auto v = points.velocity.template load<P>(first, count);
    const P m = load_lanes<P>(points.mass.data() + first, count);
    const auto w = cell.weights(x);
    std::array<P, size> mw;
    repeat<size>([&](std::size_t i) { mw[i] = m * w[i]; });
    add_momentum<typename N::Transfer, Row::per_node>(cell, points, first, count, mw, x, v, sums);
    repeat<size>([&](std::size_t i) { sums[i * Row::per_node + D] += mw[i]; });
    if constexpr (N::needs_edge_mass)
      for_each_edge<size>(
          [&](std::size_t e, std::size_t i, std::size_t j) { sums[Row::edge_mass + e] += mw[i] * w[j]; });
    if constexpr (K::hoop) {
      const P around = load_lanes<P>(points.volume.data() + first, count) * reciprocal(x[0]);
      const P pull = around * load_lanes<P>(points.stress.column(2).data() + first, count);
      repeat<size>([&](std::size_t i) { sums[Row::pull + i] += pull * w[i]; });
      if constexpr (Row::needs_hoop)
        repeat<size>([&](std::size_t i) { sums[Row::hoop + i] += around * w[i]; });
    }
  });
  auto total = lane_sums(sums);
  if constexpr (N::needs_cell_sums) {
    auto& left = body.cell_sums[c];
    left.volume = volume;
    if constexpr (N::AntiLocking::averages_stress) left.bearing = whole / volume;
    if constexpr (B::has_dilation) left.dilation = of_stress.dilation / volume;
    if constexpr (B::knows_opening) left.open = of_stress.bearing < volume;
    repeat<Row::edges>([&](std::size_t e) { left.edge_mass[e] = total[Row::edge_mass + e]; });
    if constexpr (Row::needs_hoop) repeat<size>([&](std::size_t i) { left.hoop[i] = total[Row::hoop + i]; });
  }
  if constexpr (N::AntiLocking::averages_stress && K::hoop)
    repeat<size>([&](std::size_t i) { total[Row::pull + i] *= whole / volume; });
  // Columns of the stress as packs: a node's force is their sum, each times a component of the gradient.
  using Quad = Pack<T, 4>;
  std::array<Quad, D> column;
  repeat<D>([&](std::size_t a) {
    column[a] = Quad(0);
    repeat<D>([&](std::size_t d) { column[a].set(static_cast<int>(d), -stress[Sym<T, D>::index(d, a)]); });
  });
  T mass = 0;
  repeat<size>([&](std::size_t i) { mass += total[i * Row::per_node + D]; });
  [[maybe_unused]] const T reach = mass * square(mesh.size(c));
  repeat<size>([&](std::size_t i) {
    auto& sums_of_node = nodes.collected[cell.nodes[i]];
    Quad force(0);
    repeat<D>([&](std::size_t a) {
      force += column[a] * Quad(cell.gradient(static_cast<int>(a), static_cast<int>(i)));
    });
    if constexpr (K::hoop) force.set(0, force[0] - total[Row::pull + i]);
    if constexpr (N::smooths_light_nodes)
      force.set(3, reach * cell.gradient.col(static_cast<int>(i)).squaredNorm());
    sums_of_node.add_lower(Quad::load(&total[i * Row::per_node]));
    sums_of_node.add_upper(force);
  });
  if constexpr (Field::has_gradient)
    for (std::size_t i = 0; i < size; ++i)
      nodes.mass_gradient[cell.nodes[i]] += mass * cell.gradient.col(static_cast<int>(i));
}

/// Momentum and mass that a pack of points of mass m and velocity v hands to its nodes.
template <class Transfer, class Rows, class Points, class P, std::size_t D>
typename Rows::Handed handed_momentum(const Points& points, Index first, int count, const P& m,
                                      const std::array<P, D>& v) {
  typename Rows::Handed handed;
  handed.own[Rows::Sums::mass_lane] = m;
  repeat<D>([&](std::size_t d) { handed.own[d] = m * v[d]; });
  if constexpr (Transfer::affine) {
    const auto gradient = points.motion.template load<P>(first, count);
    repeat<D * D>([&](std::size_t k) { handed.along[k / D][k % D] = m * gradient[k]; });
  }
  return handed;
}

/// Scatters the points of a cell whose functions are products along the axes.
template <class K, class N, class M, class B, class Field>
[[gnu::flatten]] void scatter_product(const M& mesh, const B& body, Index c, Field& nodes) {
  using Cell = typename N::Shape::template Cell<M>;
  using T = typename M::scalar;
  constexpr std::size_t D = M::dimension;
  using Rows = PointRows<T, D, N::template width<T>>;
  using P = typename Rows::P;
  using Sums = NodeSums<T, M::dimension>;
  const auto& points = body.points;
  const Cell cell(mesh, c);
  Rows rows;
  // For the gradient of mass.
  [[maybe_unused]] std::conditional_t<Field::has_gradient, Rows, Nothing> masses;
  const auto spread = [&] {
    rows.spread([&](std::size_t i, std::size_t lane, const auto& sum) {
      T* const sums = nodes.collected[cell.nodes[i]].lane.data() + lane;
      using L = std::remove_cvref_t<decltype(sum)>;
      store_lanes(sums, lane_count<L>, L(load_lanes<L>(sums, lane_count<L>) + sum));
    });
    if constexpr (Field::has_gradient)
      masses.spread([&](std::size_t i, std::size_t lane, const auto& sum) {
        std::array<T, 8> sums{};
        store_lanes(sums.data() + lane, lane_count<std::remove_cvref_t<decltype(sum)>>, sum);
        repeat<D>([&](std::size_t d) {
          nodes.mass_gradient[cell.nodes[i]][static_cast<int>(d)] += sums[Sums::force_lane + d];
        });
      });
  };
  body.cells.template for_packs<Rows::width>(c, [&](Index first, int count) {
    if (rows.full()) spread();
    const auto x = points.position.template load_repeated<P>(first, count);
    const auto v = points.velocity.template load<P>(first, count);
    const auto stress = points.stress.template load<P>(first, count);
    const P m = load_lanes<P>(points.mass.data() + first, count);
    const P volume = -load_lanes<P>(points.volume.data() + first, count);
    const LineSet<P, Cell> line(cell, x);
    auto handed = handed_momentum<typename N::Transfer, Rows>(points, first, count, m, v);
    repeat<D * D>([&](std::size_t k) {
      handed.along[k / D][Sums::force_lane + k % D] =
          volume * stress[Sym<P, M::dimension>::index(k % D, k / D)];
    });
    if constexpr (K::hoop) handed.own[Sums::force_lane] = volume * stress[2] * reciprocal(x[0]);
    rows.push(count, handed, line.value, line.arm, line.slope);
    if constexpr (Field::has_gradient) {
      typename Rows::Handed mass;
      repeat<D>([&](std::size_t a) { mass.along[a][Sums::force_lane + a] = m; });
      masses.push(count, mass, line.value, line.arm, line.slope);
    }
  });
  spread();
}

}  // namespace detail

/// For each node: sum of w m, w m v (with the affine part), and the internal force -sum V sigma grad N (with
/// the hoop stress in axisymmetry), as in Sulsky, Chen, Schreyer 1994 (doi:10.1016/0045-7825(94)90112-0). The
/// field must have been cleared. Of the body, the cell sums are renewed, where there are points, and where
/// the numerics average stresses, the points of filled cells take the mean.
template <class K, class N, class M, class B, class Field>
void scatter(const N& numerics, const M& mesh, const Blocks& blocks, B& body, Field& nodes) {
  if constexpr (N::needs_cell_sums) body.cell_sums.resize(mesh.cell_count());
  if constexpr (N::template centres_stress<decltype(body.law)>) body.cell_stress.resize(mesh.cell_count());
  blocks.for_each_colored([&](Index c) {
    if (body.cells.empty(c)) return;
    if constexpr (N::Shape::constant_gradient)
      detail::scatter_simplex<K>(numerics, mesh, body, c, nodes);
    else
      detail::scatter_product<K, N>(mesh, body, c, nodes);
  });
}

/// Node velocities from momentum and force: v = p / m, v^new = v + (f / m + g) dt. Nodes without mass stay at
/// rest. A node's mass counts as none below `mass_floor`, kg: so small that a division by it means nothing in
/// T.
template <class Field, class T, int D>
void advance(Field& nodes, const Vec<T, D>& gravity, T dt, T mass_floor) {
  parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& sums = nodes.collected[i];
      if (sums.mass() <= mass_floor) {
        nodes.mass[i] = 0;
        nodes.start[i].setZero();
        nodes.velocity[i].setZero();
        continue;
      }
      const T inverse = 1 / sums.mass();
      nodes.mass[i] = sums.mass();
      nodes.start[i] = inverse * sums.momentum();
      nodes.velocity[i] = nodes.start[i] + dt * (inverse * sums.force() + gravity);
    }
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
