// Rebalance: tiles move to other ranks, between two runs or within one, so that each has its share of the points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/bytes.hpp>
#include <arenite/run/run_in_parts.hpp>
#include <arenite/run/saved_state.hpp>
#include <arenite/tiles/deal_tiles.hpp>
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

/// What `rebalance` has done: tiles that moved, and the points of the fullest rank over the mean, before and after.
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
    const auto after = deal_again(before, weight, ranks.size(), most);
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
  return detail::move_tiles(
      tiled, make, most, [](S& scene) { return state_slots(scene); },
      [](S& scene, StateCopy&& state) { restore_state(scene, std::move(state)); });
}

/// What `rebalancing` makes.
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

/// A run of tiles as an object, which stops between two steps: then the tiles may be asked. Made on all ranks, which call the same members;
/// how many steps one takes at a time is its own affair.
template <class S, class Make, class... Observers>
class RunOfTiles {
 public:
  /// `observers`: each tile has its own copies. They go with it to another rank: those with a `visit_state` keep what they had, as from a
  /// saved state; others begin anew where it comes to.
  RunOfTiles(Tiled<S>& tiled, const RunOptions& options, Rebalancing<Make> with, Observers... observers)
      : tiled_{tiled},
        options_{options},
        with_{std::move(with)},
        steps_{tiled.steps()},
        observers_(std::move(observers)...) {
    options.check(tiled.time());
    tiled.for_each_tile([this](const S& scene) { add(scene); });
  }
  RunOfTiles(const RunOfTiles&) = delete;
  RunOfTiles& operator=(const RunOfTiles&) = delete;

  bool has_ended() const { return runs_.begin()->second.has_ended(); }
  void begin() {
    tiled_.together([this](S& scene) { of(scene).begin(scene); });
  }
  /// At most so many steps; fewer at the end, where one reaches a time, s, and where tiles move after it.
  void advance(int steps, double until = std::numeric_limits<double>::infinity()) {
    const auto since = static_cast<int>(tiled_.steps() - steps_);
    const int most = std::min(steps, with_.options.every - since);
    tiled_.together([&](S& scene) { of(scene).advance(scene, most, until); });
    if (has_ended() || tiled_.steps() - steps_ < static_cast<std::size_t>(with_.options.every)) return;
    steps_ = tiled_.steps();
    move();
  }
  void finish() {
    tiled_.together([this](S& scene) { of(scene).finish(scene); });
  }

 private:
  using Run = RunInParts<S, Observers...>;

  Run& of(const S& scene) { return runs_.at(scene.portion().number); }
  Run& add(const S& scene) {
    const auto make = [&](const auto&... observer) -> Run& {
      return runs_.try_emplace(scene.portion().number, scene, options_, observer...).first->second;
    };
    return std::apply(make, observers_);
  }
  void move() {
    detail::move_tiles(
        tiled_, with_.make, with_.options.most, [this](S& scene) { return state_slots(scene, of(scene)); },
        [this](S& scene, StateCopy&& state) { restore_state(scene, std::move(state), add(scene)); });
    std::erase_if(runs_, [this](const auto& run) {
      return tiled_.shared().rank_of()[static_cast<std::size_t>(run.first)] != tiled_.ranks().rank();
    });
  }

  Tiled<S>& tiled_;
  RunOptions options_;
  Rebalancing<Make> with_;
  std::size_t steps_;  // when tiles moved
  std::tuple<Observers...> observers_;
  std::map<int, Run> runs_{};  // by tile
};

/// As `run` of tiles, which meanwhile move between ranks as their points do, with their observers (`RunOfTiles`). Bits are those without it.
template <class S, class Make, class... Observers>
void run(Tiled<S>& tiled, const RunOptions& options, Rebalancing<Make> with, Observers&&... observers) {
  detail::check_observers<Observers...>();
  RunOfTiles<S, Make, std::remove_cvref_t<Observers>...> run(tiled, options, std::move(with),
                                                             std::forward<Observers>(observers)...);
  run.begin();
  while (!run.has_ended()) run.advance(std::numeric_limits<int>::max());
  run.finish();
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
