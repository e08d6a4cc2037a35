// Probes: velocity and stress of a body at a place, interpolated between its points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <arenite/core/vector_argument.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// What a probe finds.
template <int D>
struct Probed {
  Vec<double, D> velocity = zeros<Vec<double, D>>();  ///< m/s
  Sym<double, D> stress{};                            ///< Pa
};

namespace detail {

/// The cell of a place, or `none`; const, unlike `search`, and looks at each cell where a walk finds none.
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
      from[k] = place[k] < Shape::halo ? 0 : place[k] - Shape::halo;
      to[k] = std::min(place[k] + Shape::halo + 1, count[k]);
    }
    for (Index z = from[2]; z < to[2]; ++z)
      for (Index y = from[1]; y < to[1]; ++y)
        for (Index x = from[0]; x < to[0]; ++x) cells.push_back((z * count[1] + y) * count[0] + x);
  }
  return cells;
}

}  // namespace detail

/// Velocity and stress of a body at a place: those that its points give to the nodes there, by mass and by
/// volume, interpolated from the nodes. Constant fields come out as they are. Nothing if the place lies
/// outside of the mesh, or if none of its nodes has matter. `probe<"sand">(scene, {0.1, 0.2, 0})`.
template <Name which = "", class Scene>
std::optional<Probed<Scene::D>> probe(const Scene& scene, const std::array<double, 3>& place) {
  static_assert(!Scene::is_portion,
                "probe: a scene over a portion of a mesh knows only its own part of the matter");
  using T = typename Scene::T;
  using Shape = typename Scene::Shape;
  using Cell = typename Shape::template Cell<typename Scene::Mesh>;
  constexpr int D = Scene::D;
  const auto& body = scene.template body<which>();
  const auto x = vector_argument<T, D>("probe: place", place);
  const Index cell = detail::cell_of_place(scene.mesh, x);
  if (cell == none) return std::nullopt;
  const Cell here(scene.mesh, cell);
  struct Node {
    double mass = 0, volume = 0;
    Probed<D> sum{};  // momentum, and volume times stress
  };
  std::array<Node, std::tuple_size_v<decltype(here.nodes)>> nodes;
  for (const Index c : detail::cells_about<Shape>(scene.mesh, cell))
    for (const Index p : body.cells[c]) {
      // Points have moved since they were listed.
      const Index now = scene.mesh.walk(body.points.position[p], c);
      if (now == none) continue;
      const Cell there(scene.mesh, now);
      const auto weights = there.weights(body.points.position[p]);
      const Sym<T, D> stress = body.points.stress[p];
      for (std::size_t k = 0; k < nodes.size(); ++k)
        for (std::size_t j = 0; j < nodes.size(); ++j) {
          if (there.nodes[j] != here.nodes[k]) continue;
          const auto w = static_cast<double>(weights[static_cast<int>(j)]);
          const double m = w * static_cast<double>(body.points.mass[p]);
          const double v = w * static_cast<double>(body.points.volume[p]);
          nodes[k].mass += m;
          nodes[k].volume += v;
          nodes[k].sum.velocity += m * body.points.velocity[p].template cast<double>();
          for (std::size_t s = 0; s < Sym<double, D>::size; ++s)
            nodes[k].sum.stress[s] += v * static_cast<double>(stress[s]);
        }
    }
  const auto weights = here.weights(x);
  Probed<D> found;
  double share = 0;  // of the nodes that have matter
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node& n = nodes[k];
    const auto w = static_cast<double>(weights[static_cast<int>(k)]);
    if (!(n.mass > 0 && n.volume > 0 && w > 0)) continue;
    share += w;
    found.velocity += w / n.mass * n.sum.velocity;
    for (std::size_t s = 0; s < Sym<double, D>::size; ++s) found.stress[s] += w / n.volume * n.sum.stress[s];
  }
  if (!(share > 0)) return std::nullopt;
  found.velocity /= share;
  for (double& s : found.stress.c) s /= share;
  return found;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
