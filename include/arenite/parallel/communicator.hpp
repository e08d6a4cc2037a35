// Communicator: how scenes on portions of one mesh (`MeshPortion`), on this machine or others, sum their nodal
// values. `Serial` is that of a scene on the whole mesh.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The communicator of a scene on the whole mesh: there is nothing to sum, and it compiles to nothing. Any other
/// is a handle that can be copied, and has these members, which all scenes call in the same order; what they return is the
/// same in all, bit for bit, if sums are taken in one order:
///
/// - `is_serial`: false;
/// - `sum_nodes(values, count)`: each copy of a node gets the sum over all of its copies; `values`, a span of
///   the scene's scalar, has `count` numbers a node;
/// - `share_nodes(values, count)`: each copy gets the numbers of the scene that owns the node;
/// - `sum(values)`: each number (double) is summed over the scenes;
/// - `gather(numbers)`: those of all scenes, one after the other, always in the same order;
/// - `least(value)`: the least of the scenes;
/// - `first()`: true in one of the scenes, which counts what all have;
/// - `size()`: number of portions;
/// - `Messages`: bytes for portions of the mesh, or from them, a map by their numbers; `exchange(messages)`: those for
///   others, which come back as those from others;
/// - `to_first(bytes)`: in the scene that is `first()` the bytes of all, as `Messages`; in the others none;
/// - `fail(what)`: this scene has thrown; a call of the others that waits for it must throw.
struct Serial {
  static constexpr bool is_serial = true;
  double least(double value) const { return value; }
};
inline constexpr Serial serial{};

/// All nodes are counted: for a scene on the whole mesh.
struct OwnsAll {
  constexpr bool operator()(Index) const { return true; }
};

/// Whether this scene writes and reports what is common to all scenes: one of them does.
template <class Scene>
bool is_reporter([[maybe_unused]] const Scene& scene) {
  if constexpr (requires { requires Scene::is_portion; })
    return scene.communicator().first();
  else
    return true;
}

/// Sums scalars and vectors over the scenes.
template <class Communicator, class... V>
void sum_over([[maybe_unused]] const Communicator& comm, [[maybe_unused]] V&... value) {
  if constexpr (!Communicator::is_serial) {
    std::vector<double> all;
    const auto each = [](auto& v, auto&& f) {
      if constexpr (requires { v.data(); })
        for (auto& x : std::span(v.data(), static_cast<std::size_t>(v.size()))) f(x);
      else
        f(v);
    };
    (each(value, [&](auto& x) { all.push_back(static_cast<double>(x)); }), ...);
    comm.sum(std::span<double>(all));
    std::size_t k = 0;
    (each(value, [&](auto& x) { x = static_cast<std::remove_reference_t<decltype(x)>>(all[k++]); }), ...);
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
