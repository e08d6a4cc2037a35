// Every: an observer that looks at a scene at regular times instead of at every step.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <utility>

#include <arenite/core/error.hpp>
#include <arenite/core/state_value.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Observer that calls `f(scene)` at the first step at or after each multiple of a period, s; the start
/// counts as one. A step that passes several multiples is one call.
template <class F>
class Every {
 public:
  /// Throws `error` unless period > 0.
  Every(double period, F f) : period_{period}, f_{std::move(f)} {
    require(period > 0, "every: period", period, "must be positive");
  }

  template <class Scene>
  void operator()(const Scene& scene) {
    if (scene.time < due_) return;
    // A step may end a rounding error before the time it aims at.
    const double early = period_ * (1 - 1e-12);
    due_ = (std::floor(scene.time / early) + 1) * early;
    if (!(due_ > scene.time)) due_ += early;  // the quotient was rounded down
    // Multiples closer than the clock's resolution: each step meets one.
    if (!(due_ > scene.time) || !std::isfinite(scene.time / early))
      due_ = std::nextafter(scene.time, std::numeric_limits<double>::infinity());
    constexpr bool fits = std::invocable<F&, const Scene&>;
    static_assert(fits, "every: an observer is called with the scene: [](const auto& scene) { .. }");
    if constexpr (fits) f_(scene);
  }

  /// What it calls.
  F& called() { return f_; }

  /// State of what it calls, too, if that has some.
  template <class G>
  void visit_state(G&& g) {
    g("due", due_);
    if constexpr (requires { f_.visit_state(g); }) f_.visit_state(StateUnder(g, "called"));
  }
  template <class Scene>
  void follow_state(const Scene& scene) {
    if constexpr (requires { f_.follow_state(scene); }) f_.follow_state(scene);
  }

 private:
  double period_, due_ = -std::numeric_limits<double>::infinity();
  F f_;
};

/// `every(0.1, f)`: see `Every`.
template <class F>
Every<F> every(double period, F f) {
  return {period, std::move(f)};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
