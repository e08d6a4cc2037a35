// Fill ratio: how full of matter the cells at some nodes are. Cells that run empty carry no load, which no
// other result shows.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include <arenite/mesh/full_volume.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Volume of a body's points over the volume of the cells around `nodes` that are not of region `except`, -.
/// Needs a simplex mesh. NaN if there is no such cell.
template <class Scene, class B>
double fill_ratio(const Scene& scene, const B& body, std::span<const Index> nodes, int except) {
  static_assert(is_simplex_mesh<typename Scene::Mesh>, "fill_ratio: works on a simplex mesh");
  std::vector<Index> cells;
  for (const Index i : nodes)
    for (const Index c : scene.mesh.cells_at(i))
      if (scene.mesh.region(c) != except) cells.push_back(c);
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  if (cells.empty()) return std::numeric_limits<double>::quiet_NaN();
  double matter = 0, whole = 0;
  for (const Index c : cells) {
    whole += static_cast<double>(full_volume<typename Scene::Kinematics>(scene.mesh, c));
    for (const Index p : body.cells[c]) matter += static_cast<double>(body.points.volume[p]);
  }
  return matter / whole;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
