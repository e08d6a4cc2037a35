// Every: an observer that samples a scene at regular times instead of at every step.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>

#include <arenite/core/error.hpp>
#include <arenite/core/state_value.hpp>
#include <arenite/run/run_flow.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Observer that calls `f(scene)` at the first step at or after each multiple of a period, s; the start
/// counts as one. A step that passes several multiples is one call. The rest is passed on: `f` may end the
/// run (`RunFlow`), and its `finish(scene)`, if it has one, is called at the end. `F` is a reference if the
/// observer is the caller's.
template <class F>
class Every {
 public:
  static constexpr bool refers = std::is_reference_v<F>;  ///< to the caller's observer, which copies share

  /// Throws `error` unless period > 0.
  Every(double period, F f) : period_{period}, f_{std::forward<F>(f)} {
    require(period > 0, "every: period", period, "must be positive");
  }

  template <class Scene>
  auto operator()(const Scene& scene) {
    constexpr bool fits = std::invocable<F&, const Scene&>;
    static_assert(fits, "every: an observer is called with the scene: [](const auto& scene) { .. }");
    if constexpr (fits) {
      if constexpr (std::same_as<std::invoke_result_t<F&, const Scene&>, RunFlow>)
        return is_due(scene.time) ? f_(scene) : RunFlow::go_on;
      else if (is_due(scene.time))
        f_(scene);
    }
  }
  template <class Scene>
  void finish(const Scene& scene) requires requires(F& f) {
    f.finish(scene);
  }
  { f_.finish(scene); }

  /// The wrapped observer.
  F& called() { return f_; }

  /// Time of the next call, s.
  double due() const { return due_; }
  /// As if it had been called at this time, s: for a run that continues from there.
  void resume_at(double time) { is_due(time); }

  /// Also the state of the wrapped observer, if it has one.
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
  /// Whether a call is due; if so, finds the time of the next one.
  bool is_due(double time) {
    if (time < due_) return false;
    // A step may end a rounding error before the time it aims at.
    const double early = period_ * (1 - 1e-12);
    due_ = (std::floor(time / early) + 1) * early;
    if (!(due_ > time)) due_ += early;  // the quotient was rounded down
    // Multiples closer than the clock's resolution: each step reaches one.
    if (!(due_ > time) || !std::isfinite(time / early))
      due_ = std::nextafter(time, std::numeric_limits<double>::infinity());
    return true;
  }

  double period_, due_ = -std::numeric_limits<double>::infinity();
  F f_;
};

/// `every(0.1, f)`: see `Every`. As in `run`, an observer that is a variable is not copied: it must live as
/// long as what this returns; a temporary is moved in.
template <class F>
Every<F> every(double period, F&& f) {
  return {period, std::forward<F>(f)};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
