// RunInParts: a run as an object, which stops between two steps and continues later, in another program too.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include <arenite/core/state_value.hpp>
#include <arenite/run/run.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A run of a scene as data: its observers, and its watch unless one of them is one. Saved like an observer,
/// beside the state of the scene.
template <class S, class... Observers>
class RunInParts {
 public:
  RunInParts(const S& scene, const RunOptions& options, const Observers&... observers)
      : options_{options},
        span_{options.end - scene.time},
        observers_(observers..., DefaultWatch(scene, options.watch && !(detail::is_watch<Observers> || ...),
                                              (detail::settles<Observers> || ...))) {}

  bool has_ended() const { return has_ended_; }

  /// Shows the start to the observers.
  void begin(const S& scene) { look(scene); }
  /// Makes `steps` steps; fewer if the run ends or a step reaches the time `until`, s.
  void advance(S& scene, int steps, double until = std::numeric_limits<double>::infinity()) {
    for (int k = 0; k < steps && !has_ended_ && scene.time < until; ++k) {
      step_towards(scene, options_, span_);
      look(scene);
    }
  }
  void finish(const S& scene) {
    std::apply([&](auto&... observer) { (detail::tell_end(scene, observer), ...); }, observers_);
  }

  /// The observer of this type.
  template <class Observer>
  const Observer& observer() const {
    return std::get<Observer>(observers_);
  }

  template <class F>
  void visit_state(F&& f) {
    f("span", span_);
    int k = 0;
    const auto visit = [&](auto& observer) {
      const StateUnder of_observer(f, std::to_string(k++));
      if constexpr (requires { observer.visit_state(of_observer); }) observer.visit_state(of_observer);
    };
    std::apply([&](auto&... observer) { (visit(observer), ...); }, observers_);
  }
  void follow_state(const S& scene) {
    [[maybe_unused]] const auto follow = [&](auto& observer) {
      if constexpr (requires { observer.follow_state(scene); }) observer.follow_state(scene);
    };
    std::apply([&](auto&... observer) { (follow(observer), ...); }, observers_);
  }

 private:
  void look(const S& scene) {
    const bool stops =
        std::apply([&](auto&... observer) { return detail::show_all(scene, observer...); }, observers_);
    has_ended_ = stops || scene.time >= options_.end;
  }

  RunOptions options_;
  double span_;
  bool has_ended_ = false;
  std::tuple<Observers..., DefaultWatch> observers_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
