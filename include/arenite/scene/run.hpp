// Run: steps a scene to an end time and shows it to observers.
#pragma once

#include <cmath>
#include <concepts>
#include <utility>

#include <arenite/scene/stable_step.hpp>
#include <arenite/scene/step.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {
/// Shows the scene to an observer.
template <class Scene, class Observer>
void show(const Scene& scene, Observer& observer) {
  constexpr bool fits = std::invocable<Observer&, const Scene&>;
  static_assert(fits, "run: an observer is called with the scene: [](const auto& scene) { .. }");
  if constexpr (fits) observer(scene);
}
/// Tells an observer that wants to know it that a run has reached its end.
template <class Scene, class Observer>
void tell_end(const Scene& scene, Observer& observer) {
  if constexpr (requires { observer.finish(scene); }) observer.finish(scene);
}
}  // namespace detail

/// When a run ends, and its steps.
struct RunOptions {
  double end = std::numeric_limits<double>::quiet_NaN();      ///< s, on the scene's clock
  double courant = 0.5;                                       ///< share of the stable step, above 0 to 1, -
  double max_step = std::numeric_limits<double>::infinity();  ///< s
};

/// Steps `scene` until `options.end`, which the last step hits exactly. Each observer is called with the
/// scene (const) at the start and after every step; one with a member `finish(scene)` is told the end. Throws
/// `error` for a bad option, `run_error` if the run fails; observers have then seen everything up to the step
/// before.
template <class Scene, class... Observers>
void run(Scene& scene, const RunOptions& options, Observers&&... observers) {
  require(std::isfinite(options.end), "RunOptions.end", options.end, "must be given");
  require(options.end >= scene.time, "RunOptions.end", options.end,
          shared_detail::join("must not lie before the scene's time ", scene.time));
  require(options.courant > 0, "RunOptions.courant", options.courant, "must be positive");
  require(options.courant <= 1, "RunOptions.courant", options.courant,
          "must be at most 1: larger steps are unstable");
  require(options.max_step > 0, "RunOptions.max_step", options.max_step, "must be positive");
  (detail::show(scene, observers), ...);
  const double span = options.end - scene.time;
  while (scene.time < options.end) {
    double dt = std::min(options.courant * stable_step(scene), options.max_step);
    if (!(dt > 1e-12 * span))
      throw run_error(
          shared_detail::join("t = ", scene.time, " s: the stable step has shrunk to ", dt, " s"));
    const double left = options.end - scene.time;
    const bool last = dt >= left * (1 - 1e-9);
    if (last)
      dt = left;
    else if (2 * dt > left)
      dt = left / 2;  // the last two steps share what is left: a sliver of a step would turn impulses into
                      // huge forces
    step(scene, dt);
    if (last) scene.time = options.end;
    (detail::show(scene, observers), ...);
  }
  (detail::tell_end(scene, observers), ...);
}

/// Of a scene that the compiler has refused: one sentence is enough.
template <class... Parts, class... Observers>
void run(Scene<detail::Refused, Parts...>&, const RunOptions&, Observers&&...) {}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
