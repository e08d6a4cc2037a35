// Probes: velocity and stress of a body at a place, interpolated between its points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <arenite/core/vector_argument.hpp>
#include <arenite/mesh/window_grid.hpp>
#include <arenite/scene/cell_of_all.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Result of a probe.
template <int D>
struct Probed {
  Vec<double, D> velocity = zeros<Vec<double, D>>();  ///< m/s
  Sym<double, D> stress{};                            ///< Pa
};

namespace detail {

/// The cell of a place, or `none`. Const, unlike `search`, and tries each cell if a walk finds none.
template <class M>
Index cell_of_place(const M& mesh, const typename M::Point& x) {
  const Index found = mesh.walk(x, 0);
  if constexpr (is_simplex_mesh<M>) {
    if (found == none)
      for (Index c = 0; c < mesh.cell_count(); ++c)
        if (mesh.walk(x, c) == c) return c;
  }
  return found;
}

/// The cells that share a node with a cell, itself among them, ascending.
template <class Shape, class M>
std::vector<Index> cells_about(const M& mesh, Index cell) {
  std::vector<Index> cells;
  if constexpr (is_simplex_mesh<M>) {
    for (const Index i : mesh.nodes(cell)) {
      const auto at = mesh.cells_at(i);
      cells.insert(cells.end(), at.begin(), at.end());
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  } else {
    constexpr std::size_t D = M::dimension;
    std::array<Index, 3> from{}, to{1, 1, 1}, count{1, 1, 1};
    const auto place = mesh.place(cell);
    for (std::size_t k = 0; k < D; ++k) {
      count[k] = mesh.cells(static_cast<int>(k));
      const Index at = place[k] - first_cell(mesh, static_cast<int>(k));
      from[k] = at < Shape::halo ? 0 : at - Shape::halo;
      to[k] = std::min(at + Shape::halo + 1, count[k]);
    }
    for (Index z = from[2]; z < to[2]; ++z)
      for (Index y = from[1]; y < to[1]; ++y)
        for (Index x = from[0]; x < to[0]; ++x) cells.push_back((z * count[1] + y) * count[0] + x);
  }
  return cells;
}

/// P2G sums of the points of a body at the nodes of a cell, [nodes x (2 + D + stresses)]: mass, kg, volume,
/// m^D, momentum, and volume times stress.
template <class Scene, class Body, class Cell>
std::vector<double> sums_at_nodes(const Scene& scene, const Body& body, const Cell& here, Index cell,
                                  std::size_t size) {
  using T = typename Scene::T;
  constexpr auto D = static_cast<std::size_t>(Scene::D);
  std::vector<double> sums(here.nodes.size() * size);
  for (const Index c : cells_about<typename Scene::Shape>(scene.mesh, cell))
    for (const Index p : body.cells[c]) {
      // Points have moved since they were listed.
      const Index now = scene.mesh.walk(body.points.position[p], c);
      if (now == none) continue;
      const Cell there(scene.mesh, now);
      const auto weights = there.weights(body.points.position[p]);
      const Vec<T, Scene::D> velocity = body.points.velocity[p];
      const Sym<T, Scene::D> stress = body.points.stress[p];
      for (std::size_t k = 0; k < here.nodes.size(); ++k)
        for (std::size_t j = 0; j < there.nodes.size(); ++j) {
          if (there.nodes[j] != here.nodes[k]) continue;
          const auto w = static_cast<double>(weights[static_cast<int>(j)]);
          const double m = w * static_cast<double>(body.points.mass[p]);
          const double v = w * static_cast<double>(body.points.volume[p]);
          double* const of_node = &sums[k * size];
          of_node[0] += m;
          of_node[1] += v;
          for (std::size_t a = 0; a < D; ++a)
            of_node[2 + a] += m * static_cast<double>(velocity[static_cast<int>(a)]);
          for (std::size_t s = 2 + D; s < size; ++s) of_node[s] += v * static_cast<double>(stress[s - 2 - D]);
        }
    }
  return sums;
}

}  // namespace detail

/// Velocity and stress of a body at a place: mapped from its points to the nodes there, weighted by mass and
/// by volume, and interpolated from the nodes. Constant fields are reproduced. Nothing if the place lies
/// outside of the mesh, or if none of its nodes has matter. `probe<"sand">(scene, {0.1, 0.2, 0})`; of a body of
/// a list `probe(scene, scene.body(k), {0.1, 0.2, 0})`. The scenes over all portions of a mesh are asked at
/// once, and find the same.
template <class Scene, class B>
std::optional<Probed<Scene::D>> probe(const Scene& scene, const B& body, const std::array<double, 3>& place) {
  using T = typename Scene::T;
  using Cell = typename Scene::Shape::template Cell<typename Scene::Mesh>;
  constexpr int D = Scene::D;
  constexpr std::size_t stresses = Sym<double, D>::size, size = 2 + D + stresses;
  const auto x = vector_argument<T, D>("probe: place", place);
  Index cell = detail::cell_of_place(scene.mesh, x);
  if (!find_owner_cell(scene, cell)) return std::nullopt;
  const Cell here(scene.mesh, cell == none ? 0 : cell);
  std::vector<double> nodes(here.nodes.size() * size);
  if (cell != none) nodes = detail::sums_at_nodes(scene, body, here, cell, size);
  bool interpolates = true;
  if constexpr (Scene::is_portion) {
    scene.communicator().sum(std::span<double>(nodes));
    interpolates = cell != none && scene.portion().owns_cell(cell);
  }
  Probed<D> found;
  double share = 0;  // of the nodes that have matter
  const auto weights = here.weights(x);
  for (std::size_t k = 0; k < here.nodes.size() && interpolates; ++k) {
    const double* const of_node = &nodes[k * size];
    const double mass = of_node[0], volume = of_node[1];
    const auto w = static_cast<double>(weights[static_cast<int>(k)]);
    if (!(mass > 0 && volume > 0 && w > 0)) continue;
    share += w;
    for (std::size_t a = 0; a < D; ++a) found.velocity[static_cast<int>(a)] += w / mass * of_node[2 + a];
    for (std::size_t s = 0; s < stresses; ++s) found.stress[s] += w / volume * of_node[2 + D + s];
  }
  sum_over(scene.communicator(), share, found.velocity, found.stress.c);
  if (!(share > 0)) return std::nullopt;
  found.velocity /= share;
  for (double& s : found.stress.c) s /= share;
  return found;
}

template <Name which = "", class Scene>
std::optional<Probed<Scene::D>> probe(const Scene& scene, const std::array<double, 3>& place) {
  return probe(scene, scene.template body<which>(), place);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
