// Run of tiles: steps all tiles to an end time, between two steps of which they may move, be asked and be saved.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>

#include <arenite/run/run_in_parts.hpp>
#include <arenite/tiles/rebalance.hpp>
#include <arenite/tiles/saved_tiles.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A run of tiles as an object, which stops between two steps: then the tiles may be asked, and the run may be saved. Made on all ranks, which
/// call the same members; how many steps one takes at a time is its own affair.
template <class S, class Make, class... Observers>
class RunOfTiles {
 public:
  /// `observers`: each tile has its own copies. They go with it to another rank: those with a `visit_state` keep their state, as from a
  /// saved one; others start again on the new rank.
  RunOfTiles(Tiled<S>& tiled, const RunOptions& options, Rebalancing<Make> with, Observers... observers)
      : tiled_{tiled},
        options_{options},
        with_{std::move(with)},
        steps_{tiled.steps()},
        observers_(std::move(observers)...) {
    tiled.ranks().agree(detail::question_of(options)
                            .with("RebalanceOptions.every", with_.options.every)
                            .with("RebalanceOptions.most", with_.options.most));
    options.check(tiled.time());
    tiled.for_each_tile([this](const S& scene) { add(scene); });
  }
  RunOfTiles(const RunOfTiles&) = delete;
  RunOfTiles& operator=(const RunOfTiles&) = delete;

  /// At the end, or stopped by an observer.
  bool has_ended() const { return runs_.begin()->second.has_ended(); }
  /// Shows the start to the observers; or `restore`.
  void begin() {
    tiled_.together([this](S& scene) { of(scene).begin(scene); });
  }
  /// Makes at most `steps` steps; fewer at the end, at the time `until`, s, and where tiles move.
  void advance(int steps, double until = std::numeric_limits<double>::infinity()) {
    const auto since = static_cast<int>(tiled_.steps() - steps_);
    const int most = std::min(steps, with_.options.every - since);
    tiled_.together([&](S& scene) { of(scene).advance(scene, most, until); });
    if (has_ended() || tiled_.steps() - steps_ < static_cast<std::size_t>(with_.options.every)) return;
    steps_ = tiled_.steps();
    move();
  }
  /// Saves the tiles, and what their observers carry, to a folder.
  void save(const SavedState& folder) {
    detail::agree_on_folder(tiled_.ranks(), "saving its tiles", folder);
    const SavedTiles saver(folder);
    tiled_.together([&](S& scene) { saver.save(scene, of(scene)); });
  }
  /// Resumes from what was saved there, of the same tiles and observers on any number of ranks. Throws what `restore_state` does.
  void restore(const SavedState& folder) {
    detail::restore_tiles(tiled_, folder, [this](S& scene) -> Run& { return of(scene); });
    steps_ = tiled_.steps();
  }
  /// The observer of this type, as the first tile here has it.
  template <class Observer>
  const Observer& observer() const {
    return runs_.begin()->second.template observer<Observer>();
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
