// Read fill: bodies out of a host's values, whose functions of place are asked for once each.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <vector>

#include <arenite/scene/scene.hpp>
#include <arenite_host/readers.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// Positions of the nodes of a scene's mesh, m: of those that walls by a test of positions ask for.
template <class Scene>
std::vector<std::array<double, 3>> node_positions(const typename Scene::Mesh& mesh) {
  std::vector<std::array<double, 3>> nodes;
  for (Index i = 0; i < Scene::Shape::node_count(mesh); ++i)
    nodes.push_back(in_space<typename Scene::T, Scene::D>(Scene::Shape::node_position(mesh, i)));
  return nodes;
}

/// A fill of type F, whose points are in the cells that `owns(cell)`. User functions are evaluated in two passes: first the region, then
/// densities and stresses at the points found.
template <class Scene, class F, class Mesh, class Owns = OwnsAllCells>
F read_fill(const Mesh& mesh, const Value& value, ReadContext at, const Owns& owns = {}) {
  PlaceFunctions functions;
  at.places = &functions;
  F fill = read<F>(value, at);
  const auto rewind = [&] {
    for (auto* list : {&functions.where, &functions.what})
      for (auto& f : *list) f->rewind();
  };
  F probe = fill;
  probe.options.may_be_empty = true;
  if (probe.options.stress && probe.options.stress->geostatic()) probe.options.stress.reset();
  for (auto* stage : {&functions.where, &functions.what}) {
    if (stage->empty()) continue;
    make_body<typename Scene::Kinematics, Scene::extra_columns>(mesh, probe, owns);
    for (auto& f : *stage) f->compute();
    rewind();
  }
  return fill;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
