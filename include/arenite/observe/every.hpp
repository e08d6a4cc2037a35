// Every: an observer that looks at a scene at regular times instead of at every step.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <utility>

#include <arenite/core/error.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Calls `f(scene)` at the first step at or after each multiple of `period`, s; the start counts as one. A
/// step that passes several multiples is one call. Throws `error` unless period > 0.
template <class F>
auto every(double period, F f) {
  require(period > 0, "every: period", period, "must be positive");
  return
      [period, f = std::move(f), due = -std::numeric_limits<double>::infinity()](const auto& scene) mutable {
        if (scene.time < due) return;
        // A step may end a rounding error before the time it aims at.
        const double early = period * (1 - 1e-12);
        due = (std::floor(scene.time / early) + 1) * early;
        if (!(due > scene.time)) due += early;  // the quotient was rounded down
        // Multiples closer than the clock's resolution: each step meets one.
        if (!(due > scene.time) || !std::isfinite(scene.time / early))
          due = std::nextafter(scene.time, std::numeric_limits<double>::infinity());
        constexpr bool fits = std::invocable<F&, decltype(scene)>;
        static_assert(fits, "every: an observer is called with the scene: [](const auto& scene) { .. }");
        if constexpr (fits) f(scene);
      };
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
