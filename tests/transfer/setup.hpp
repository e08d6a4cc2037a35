// A body of random points in a mesh with its node field: what the transfers work on, without a scene.
#pragma once

#include <arenite/law/linear_elastic.hpp>
#include <arenite/transfer/g2p.hpp>
#include <arenite/transfer/map_back.hpp>
#include <arenite/transfer/node_correction.hpp>
#include <arenite/transfer/p2g.hpp>
#include <numeric>

#include "../mesh/sample_meshes.hpp"

namespace arenite::test {

inline const LinearElastic elastic{{.density = 1000, .young = 1e6, .poisson = 0.3}};

/// Random points in all cells but every seventh: `per_cell` of random mass, volume, velocity, stress and (if
/// `Extra` has it) affine motion. What it is does not depend on the numerics: compiled once for all of them.
template <class Shape_, class M_, ExtraColumns Extra, bool HasMapped>
struct RandomBody {
  using Shape = Shape_;
  using M = M_;
  using T = typename M::scalar;
  using Cell = typename Shape::template Cell<M>;
  static constexpr int D = M::dimension;
  using Field = NodeField<T, D, HasMapped, true, true>;

  M mesh;
  Blocks blocks;
  Body<LinearElastic, T, D, Extra> body{elastic, {}, {}};
  Field nodes;
  std::mt19937 random;

  RandomBody(M m, int per_cell, unsigned seed)
      : mesh{std::move(m)},
        blocks{mesh.cell_count(), Shape::node_count(mesh), 5,
               [this](Index c) { return Cell(mesh, c).nodes; }},
        nodes{Shape::node_count(mesh)},
        random{seed} {
    for (Index c = 0; c < mesh.cell_count(); ++c)
      for (int k = 0; c % 7 != 3 && k < per_cell; ++k) add(random_point(mesh, c, random), c);
    index();
  }

  T number(double low = -1, double high = 1) {
    return static_cast<T>(std::uniform_real_distribution<double>(low, high)(random));
  }

  void add(const Vec<T, D>& x, Index c) {
    Sym<T, D> stress;
    for (std::size_t k = 0; k < stress.size; ++k) stress[k] = number();
    Vec<T, D> v;
    for (int k = 0; k < D; ++k) v[k] = number();
    body.points.push_back(x, v, number(0.5, 2), number(0.5, 2), stress, c);
    if constexpr (Extra.affine) {
      Mat<T, D> motion;
      for (int k = 0; k < D * D; ++k) motion(k / D, k % D) = number();
      body.points.velocity_gradient.set(body.points.size() - 1, motion);
    }
  }

  /// Renews the list of cells after `add`.
  void index() {
    auto& cell = body.points.cell;
    std::vector<Index> order(cell.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return cell[a] < cell[b]; });
    body.points.reorder(order);
    body.cells.build(body.points.cell, mesh.cell_count());
  }

  /// Velocities of the nodes, without force or gravity unless given.
  void update_grid(T dt = 0, const Vec<T, D>& gravity = Vec<T, D>::Zero()) {
    arenite::update_grid(nodes, gravity, dt, T(0));
  }
  Vec<T, D> node(Index i) const { return Shape::node_position(mesh, i); }

  /// Gives all points the field v = a + A x, with the affine motion that belongs to it.
  void set_affine(const Vec<T, D>& a, const Mat<T, D>& A) {
    auto& points = body.points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      points.velocity.set(p, a + A * points.position[p]);
      if constexpr (Extra.affine) points.velocity_gradient.set(p, A);
    }
  }

  Vec<T, D> point_momentum() const {
    Vec<T, D> sum = Vec<T, D>::Zero();
    for (std::size_t p = 0; p < body.points.size(); ++p) sum += body.points.mass[p] * body.points.velocity[p];
    return sum;
  }
  Vec<T, D> node_momentum() const {
    Vec<T, D> sum = Vec<T, D>::Zero();
    for (std::size_t i = 0; i < nodes.size(); ++i) sum += nodes.mass[i] * nodes.velocity[i];
    return sum;
  }
};

/// Random points with the kernels of numerics N.
template <class K_, class N_, class M_>
struct Setup : RandomBody<typename N_::Shape, M_, N_::extra_columns, N_::maps_back> {
  using K = K_;
  using N = N_;
  using Base = RandomBody<typename N::Shape, M_, N::extra_columns, N::maps_back>;
  using typename Base::T;
  using Transfer = typename N::Transfer;
  using Base::blocks;
  using Base::body;
  using Base::mesh;
  using Base::nodes;

  N numerics{};

  explicit Setup(M_ m, int per_cell = 3, unsigned seed = 1) : Base(std::move(m), per_cell, seed) {}

  void p2g() {
    nodes.clear();
    arenite::p2g<K>(numerics, mesh, blocks, body, nodes);
  }
  void correct_nodes() {
    if constexpr (N::corrects_nodes) {
      start_correction(numerics, nodes);
      for (int k = 0; k < numerics.transfer.iterations(); ++k) {
        map_residual(numerics, mesh, blocks, body, nodes);
        finish_residual(numerics, nodes);
        add_residual(nodes);
      }
    }
  }
  void map_back() {
    if constexpr (N::maps_back) {
      arenite::map_back(numerics, mesh, blocks, body, nodes);
      finish_map_back(numerics, nodes);
    }
  }
  auto average(T dt) {
    typename N::template StrainAverage<T> average;
    if constexpr (N::averages_strain) {
      average.template sum<K, N>(mesh, blocks, body, nodes, dt);
      average.finish(mesh, blocks, body);
    }
    return average;
  }
  G2pSums g2p(T dt) { return arenite::g2p<K, true>(numerics, mesh, body, nodes, dt, average(dt)); }
  G2pSums update_stress(T dt) {
    return arenite::update_stress<K, true>(numerics, mesh, body, nodes, dt, average(dt));
  }
  /// New velocities of the points, and nothing else: a step without length neither moves nor strains.
  void gather() {
    correct_nodes();
    map_back();
    if constexpr (!N::maps_back_by_points) g2p(0);
  }
};

template <class T = double>
CartesianGrid<2, T> flat_grid() {
  return CartesianGrid<2, T>({.lower = {0, 0}, .upper = {1.25, 1.25}, .cell = 0.25});
}
template <class T = double>
CartesianGrid<3, T> solid_grid() {
  return CartesianGrid<3, T>({.lower = {0, 0, 0}, .upper = {0.75, 0.75, 1}, .cell = 0.25});
}

}  // namespace arenite::test
