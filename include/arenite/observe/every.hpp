// Every: an observer that looks at a scene at regular times instead of at every step.
#pragma once

#include <utility>

#include <arenite/core/error.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Calls `f(scene)` at the first step at or after each multiple of `period`, s; the start counts as one.
/// Throws `error` unless period > 0.
template <class F>
auto every(double period, F f) {
  require(period > 0, "every: period", period, "must be positive");
  return [period, f = std::move(f), count = 0L](const auto& scene) mutable {
    // A step may end a rounding error before the time it aims at.
    if (scene.time < static_cast<double>(count) * period * (1 - 1e-12)) return;
    while (static_cast<double>(count) * period * (1 - 1e-12) <= scene.time) ++count;
    f(scene);
  };
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
