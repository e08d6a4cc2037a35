// Rebalance: tiles move to other ranks, between two runs or within one, so that each has its share of the points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/bytes.hpp>
#include <arenite/run/saved_state.hpp>
#include <arenite/tiles/assign_tiles.hpp>
#include <arenite/tiles/options.hpp>
#include <arenite/tiles/tiled.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// Named numbers as bytes: of each the length of its name, bytes of a number, count, kind, whether it is an array, name, numbers.
inline std::string packed(const std::vector<StateSlot>& slots) {
  std::string bytes;
  for (const auto& slot : slots) {
    for (const std::size_t number : {slot.name.size(), slot.bytes, slot.count}) append_bytes(bytes, number);
    append_bytes(bytes, slot.kind);
    append_bytes(bytes, slot.is_array);
    bytes += slot.name;
    bytes.append(static_cast<const char*>(slot.data), slot.size());
  }
  return bytes;
}
/// Copies of what was packed.
inline StateCopy unpacked(std::string& bytes) {
  std::vector<StateSlot> slots;
  for (std::string_view rest = bytes; !rest.empty();) {
    StateSlot slot;
    const auto name = read_bytes<std::size_t>(rest);
    slot.bytes = read_bytes<std::size_t>(rest);
    slot.count = read_bytes<std::size_t>(rest);
    slot.kind = read_bytes<char>(rest);
    slot.is_array = read_bytes<bool>(rest);
    slot.name = rest.substr(0, name);
    rest.remove_prefix(name);
    slot.data = bytes.data() + (rest.data() - bytes.data());
    rest.remove_prefix(slot.size());
    slots.push_back(std::move(slot));
  }
  return StateCopy(std::move(slots));
}

}  // namespace detail

/// The result of `rebalance`: tiles that moved, and the points of the fullest rank over the mean, before and after.
struct Rebalanced {
  int moved = 0;
  double before = 1, after = 1;
};

namespace detail {

/// Moves tiles between ranks. `slots(scene)`: the state of a tile that goes; `put(scene, state)`: into a tile that came.
template <class S, class Make, class Slots, class Put>
Rebalanced move_tiles(Tiled<S>& tiled, Make& make, double most, Slots&& slots, Put&& put) {
  require(most >= 1, "rebalance: most", most, "must be at least 1");
  Ranks& ranks = tiled.ranks();
  try {
    const auto counts = TileMaker<S>::count_points(tiled);
    const std::vector<double> weight(counts.begin(), counts.end());
    const auto before = tiled.shared().rank_of();
    const auto after = reassign_tiles(before, weight, ranks.size(), most);
    Rebalanced done{0, imbalance(before, weight, ranks.size()), imbalance(after, weight, ranks.size())};
    std::map<int, std::string> to;  // by rank
    for (std::size_t t = 0; t < before.size(); ++t) {
      if (before[t] == after[t]) continue;
      ++done.moved;
      if (before[t] == ranks.rank()) to[after[t]];
      if (after[t] == ranks.rank()) to[before[t]];
    }
    if (done.moved == 0) return done;
    tiled.for_each_tile([&](S& scene) {
      const auto t = static_cast<std::size_t>(scene.portion().number);
      if (after[t] == ranks.rank()) return;
      const std::string state = packed(slots(scene));
      append_bytes(to[after[t]], t);
      append_bytes(to[after[t]], state.size());
      to[after[t]] += state;
    });
    std::vector<int> with;
    std::vector<std::string> messages;
    for (auto& [rank, message] : to) {
      with.push_back(rank);
      messages.push_back(std::move(message));
    }
    const auto from = ranks.exchange(with, messages);
    std::map<int, std::string> state;  // by tile
    for (const auto& bytes : from)
      for (std::string_view rest = bytes; !rest.empty();) {
        const auto t = static_cast<int>(read_bytes<std::size_t>(rest));
        const auto size = read_bytes<std::size_t>(rest);
        state[t] = rest.substr(0, size);
        rest.remove_prefix(size);
      }
    TileMaker<S>::take(tiled, ranks, after, make);
    tiled.for_each_tile([&](S& scene) {
      if (const auto there = state.find(scene.portion().number); there != state.end())
        put(scene, unpacked(there->second));
    });
    return done;
  } catch (const std::exception& e) {
    ranks.fail(e.what());
    throw;
  }
}

}  // namespace detail

/// Moves tiles between ranks where one has more than `most` times the mean share of the points. Called on all ranks between two runs; the
/// tiles, and with them all bits, stay what they are. `make`: as for `distribute`; it makes a tile where it comes to, which then gets the
/// state that it had. Throws what that throws, on all ranks.
template <class S, class Make>
Rebalanced rebalance(Tiled<S>& tiled, Make&& make, double most = 1.05) {
  tiled.ranks().agree(Question{"a rebalance"}.with("most", most));
  return detail::move_tiles(
      tiled, make, most, [](S& scene) { return state_slots(scene); },
      [](S& scene, StateCopy&& state) { restore_state(scene, std::move(state)); });
}

/// The result of `rebalancing`.
template <class Make>
struct Rebalancing {
  Make make;
  RebalanceOptions options;
};

/// `run(scene, options, rebalancing(make), observers..)`: `make` as for `distribute`.
template <class Make>
Rebalancing<Make> rebalancing(Make make, RebalanceOptions options = {}) {
  require(options.every >= 1, "RebalanceOptions.every", options.every, "must be at least 1");
  require(options.most >= 1, "RebalanceOptions.most", options.most, "must be at least 1");
  return {std::move(make), options};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
