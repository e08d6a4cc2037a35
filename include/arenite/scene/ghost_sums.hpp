// Ghost sums: adds or copies nodal values that scenes on portions of one mesh share. A scene on the whole mesh skips them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <span>

#include <arenite/parallel/communicator.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// All numbers of an array of nodes.
template <class Sums>
auto numbers_of(std::vector<Sums>& sums) -> std::span<typename decltype(Sums::lane)::value_type> {
  static_assert(sizeof(Sums) == sizeof(sums[0].lane));
  return {sums.data()->lane.data(), sums.size() * sums[0].lane.size()};
}
template <class T, int D>
std::span<T> numbers_of(NodeVectors<T, D>& vectors) {
  return vectors.numbers();
}

/// Each copy of a node gets the sum over all.
template <class Scene, class Nodes>
void sum_nodes([[maybe_unused]] const Scene& scene, [[maybe_unused]] Nodes& nodes) {
  if constexpr (Scene::is_portion) {
    const auto numbers = numbers_of(nodes);
    if (nodes.size() > 0) scene.communicator().sum_nodes(numbers, numbers.size() / nodes.size());
  }
}

/// Sets all copies of a sum but the owner's to zero, so that more can be added to the copies and summed.
template <class Scene, class Nodes>
void zero_ghosts([[maybe_unused]] const Scene& scene, [[maybe_unused]] Nodes& nodes) {
  if constexpr (Scene::is_portion)
    for (Index i = 0; i < nodes.size(); ++i)
      if (!scene.portion().owns_node(i)) nodes[i] = {};
}

/// Each copy of a node gets the owner's vector; `of(field)`: which.
template <class Scene, class Of>
void share_nodes([[maybe_unused]] Scene& scene, [[maybe_unused]] Of&& of) {
  if constexpr (Scene::is_portion)
    for (auto& field : scene.fields) {
      auto& vectors = of(field);
      const auto numbers = numbers_of(vectors);
      scene.communicator().share_nodes(numbers, numbers.size() / vectors.size());
    }
}

/// Calls `f(to)`, which changes velocities of nodes through `to`: of owned nodes and of those around them.
template <class Scene, class Velocities, class F>
void change_velocities([[maybe_unused]] const Scene& scene, Velocities& velocity, F&& f) {
  if constexpr (!Scene::is_portion) {
    f(InPlace{velocity});
  } else {
    auto change = velocity;
    std::ranges::fill(numbers_of(change), 0);
    f(Apart<Velocities>{velocity, change});
    sum_nodes(scene, change);
    for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] += change[i];
  }
}

/// The tally of a part whose numbers are those of all scenes (`is_shared`) counts in one of them.
template <class P, class Scene>
ContactTally count_on_owner([[maybe_unused]] const Scene& scene, const ContactTally& tally) {
  if constexpr (Scene::is_portion && requires { P::is_shared; })
    return scene.communicator().first() ? tally : ContactTally{};
  return tally;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
