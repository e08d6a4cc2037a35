// The method's loops point by point and node by node, in scalars, without averages: the formulas that the
// kernels compute in packs. Read them here first; tests compare the kernels with them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <vector>

#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/strain.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace reference {

/// Sums at a node: mass, kg; momentum, kg m/s; internal force, N; gradient of mass, kg/m.
template <class T, int D>
struct NodeSums {
  T mass = 0;
  Vec<T, D> momentum = Vec<T, D>::Zero(), force = momentum, mass_gradient = momentum;
};

/// P2G: mass_i = sum m w_i, momentum_i = sum m w_i v_p(x_i), force_i = -sum V sigma grad w_i.
template <class K, class N, class M, class B, class T = typename M::scalar, int D = M::dimension>
std::vector<NodeSums<T, D>> p2g(const N& numerics, const M& mesh, const B& body) {
  std::vector<NodeSums<T, D>> sums(N::Shape::node_count(mesh));
  const auto& points = body.points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const typename N::Shape::template Cell<M> cell(mesh, points.cell[p]);
    const Vec<T, D> x = points.position[p];
    const auto w = cell.weights(x);
    const auto gradient = cell.gradients(x), node = cell.node_positions();
    const auto v = numerics.transfer.particle_field(
        PointPack<std::remove_reference_t<decltype(points)>, 1>{points, p, 1});
    const Sym<T, D> stress = points.stress[p];
    for (int i = 0; i < cell.size; ++i) {
      auto& to = sums[cell.nodes[static_cast<std::size_t>(i)]];
      to.mass += points.mass[p] * w[i];
      const auto handed =
          v.at([&](std::size_t a) { return node(static_cast<int>(a), i) - x[static_cast<int>(a)]; });
      to.momentum += points.mass[p] * w[i] * Eigen::Map<const Vec<T, D>>(handed.data());
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) to.force[a] -= points.volume[p] * stress(a, b) * gradient(b, i);
      if (K::hoop) to.force[0] -= points.volume[p] * stress[2] * w[i] / x[0];
      to.mass_gradient += points.mass[p] * gradient.col(i);
    }
  }
  return sums;
}

/// The correction of a transfer that asks for one: sum_{l=1}^{iterations} (I - S+ S)^l u, without constraints,
/// with (S+ S u)_i = sum_p m w_i sum_j w_j u_j / m_i.
template <class N, class M, class B, class Field, class T = typename M::scalar, int D = M::dimension>
std::vector<Vec<T, D>> correction(const N& numerics, const M& mesh, const B& body, const Field& nodes) {
  const Vec<T, D> zero = Vec<T, D>::Zero();
  std::vector<Vec<T, D>> sum(nodes.size(), zero), residual = sum;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (int k = 0; k < D; ++k) residual[i][k] = numerics.transfer.iterated(nodes, static_cast<Index>(i))[k];
  for (int l = 0; l < numerics.transfer.iterations(); ++l) {
    std::vector<Vec<T, D>> mapped(nodes.size(), zero);
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const typename N::Shape::template Cell<M> cell(mesh, body.points.cell[p]);
      const auto w = cell.weights(body.points.position[p]);
      Vec<T, D> at_point = zero;
      for (std::size_t j = 0; j < cell.size; ++j)
        at_point += w[static_cast<int>(j)] * residual[cell.nodes[j]];
      for (std::size_t i = 0; i < cell.size; ++i)
        mapped[cell.nodes[i]] += body.points.mass[p] * w[static_cast<int>(i)] * at_point;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      residual[i] = nodes.mass[i] > 0 ? Vec<T, D>(residual[i] - mapped[i] / nodes.mass[i]) : zero;
      sum[i] += residual[i];
    }
  }
  return sum;
}

/// Sums over the nodes of a cell for a transfer at x: of the vectors d_i, of its second vectors, and with the
/// moments x_i - x.
template <class T, int D>
struct TakenSums {
  std::array<T, D> value{}, second{};
  std::array<std::array<T, D>, D> moment_sums{};
  const auto& moments() const { return moment_sums; }
};

/// Sets the velocity (and its gradient) of point p by its transfer. Returns the velocity field that the point
/// passes to P2G from then on.
template <class N, class Cell, class Points, class Field, class T = typename Cell::T, int D = Cell::D>
auto gather(const N& numerics, const Cell& cell, Points& points, std::size_t p, const Field& nodes) {
  const CellVectors<T, D, Cell::size> v(cell, nodes.velocity);
  const auto transfer = numerics.transfer.gather(cell, nodes);
  const auto& d = value_or(transfer.velocity, v);
  const Vec<T, D> x = points.position[p];
  const auto w = cell.weights(x);
  const auto node = cell.node_positions();
  TakenSums<T, D> sums;
  for (std::size_t i = 0; i < Cell::size; ++i)
    for (std::size_t k = 0; k < D; ++k) {
      const auto n = static_cast<int>(i);
      sums.value[k] += w[n] * d[i][k];
      if constexpr (requires { transfer.second; }) sums.second[k] += w[n] * transfer.second[i][k];
      for (int a = 0; a < D; ++a)
        sums.moment_sums[static_cast<std::size_t>(a)][k] += w[n] * d[i][k] * (node(a, n) - x[a]);
    }
  const PointPack<Points, 1> point{points, p, 1};
  return transfer(cell, point, point.position(), sums);
}

/// MUSL: node velocities mapped back from the points, sum m w_i v_p(x_i) / m_i with their new velocities.
template <class N, class M, class B, class Field, class T = typename M::scalar, int D = M::dimension>
std::vector<Vec<T, D>> map_back(const N& numerics, const M& mesh, const B& body, const Field& nodes) {
  std::vector<Vec<T, D>> mapped(nodes.size(), Vec<T, D>::Zero());
  auto points = body.points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const typename N::Shape::template Cell<M> cell(mesh, points.cell[p]);
    const Vec<T, D> x = points.position[p];
    const auto w = cell.weights(x);
    const auto node = cell.node_positions();
    const auto v = gather(numerics, cell, points, p, nodes);
    for (int i = 0; i < cell.size; ++i) {
      const auto handed =
          v.at([&](std::size_t a) { return node(static_cast<int>(a), i) - x[static_cast<int>(a)]; });
      mapped[cell.nodes[static_cast<std::size_t>(i)]] +=
          points.mass[p] * w[i] * Eigen::Map<const Vec<T, D>>(handed.data());
    }
  }
  for (std::size_t i = 0; i < mapped.size(); ++i)
    mapped[i] = nodes.mass[i] > 0 ? Vec<T, D>(mapped[i] / nodes.mass[i]) : Vec<T, D>(Vec<T, D>::Zero());
  return mapped;
}

/// G2P: velocities by the transfer, and the strains of the step: those of dt sum u_i (grad w_i)^T with
/// the velocities u_i for the strains. Positions x_p += dt sum w_i v_i, where the numerics move them so dt sum w_i u_i.
template <class K, class N, class M, class B, class Field, class T = typename M::scalar, int D = M::dimension>
std::vector<StrainStep<T, D>> g2p(const N& numerics, const M& mesh, B& body, const Field& nodes, T dt) {
  std::vector<StrainStep<T, D>> strains;
  auto& points = body.points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const typename N::Shape::template Cell<M> cell(mesh, points.cell[p]);
    const Vec<T, D> x = points.position[p];
    const auto w = cell.weights(x);
    const auto gradient = cell.gradients(x);
    gather(numerics, cell, points, p, nodes);
    std::array<std::array<T, D>, D> derivative{};  // by column, 1/s
    std::array<T, D> straining{}, place{};         // m/s, m
    Vec<T, D> displacement = Vec<T, D>::Zero();
    for (int i = 0; i < cell.size; ++i) {
      const Index node = cell.nodes[static_cast<std::size_t>(i)];
      const Vec<T, D> u = nodes.strain_velocity()[node];
      displacement += dt * w[i] * (N::moves_mapped ? u : nodes.velocity[node]);
      for (std::size_t a = 0; a < D; ++a) {
        const auto row = static_cast<int>(a);
        straining[a] += w[i] * u[row];
        place[a] = x[row];
        for (std::size_t b = 0; b < D; ++b) derivative[b][a] += u[row] * gradient(static_cast<int>(b), i);
      }
    }
    strains.push_back(strain_step_of<K, N::squares>(derivative, straining, place, dt));
    points.position.set(p, x + displacement);
  }
  return strains;
}

}  // namespace reference
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
