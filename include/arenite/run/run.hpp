// Run: steps a scene to an end time and shows it to observers.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>

#include <arenite/run/run_flow.hpp>
#include <arenite/scene/stable_step.hpp>
#include <arenite/scene/step.hpp>
#include <arenite/watch/watch.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {
/// Whether an observer may end a run.
template <class Observer, class Scene>
concept ends_runs = requires(Observer& observer, const Scene& scene) {
  { observer(scene) } -> std::same_as<RunFlow>;
};
/// Shows the scene to an observer; returns whether it ends the run.
template <class Scene, class Observer>
bool show(const Scene& scene, Observer& observer) {
  constexpr bool fits = std::invocable<Observer&, const Scene&>;
  static_assert(fits, "run: an observer is called with the scene: [](const auto& scene) { .. }");
  if constexpr (fits) {
    if constexpr (ends_runs<Observer, Scene>)
      return observer(scene) == RunFlow::stop;
    else
      observer(scene);
  }
  return false;
}
/// Shows it to all; returns whether one of them, in any of the scenes that step together, ends the run.
template <class Scene, class... Observers>
bool show_all(const Scene& scene, Observers&... observers) {
  bool stops = false;
  ((stops = show(scene, observers) || stops), ...);
  if constexpr (Scene::is_portion && (ends_runs<Observers, Scene> || ...))
    stops = scene.communicator().least(stops ? 0.0 : 1.0) == 0.0;
  return stops;
}
/// Calls `finish` of an observer that has it, at the end of a run.
template <class Scene, class Observer>
void tell_end(const Scene& scene, Observer& observer) {
  if constexpr (requires { observer.finish(scene); }) observer.finish(scene);
}

/// Whether an observer is a `Watch`, or calls one from time to time.
template <class Observer>
inline constexpr bool is_watch = [] {
  if constexpr (requires(Observer & observer) { observer.called(); })
    return std::same_as<std::remove_cvref_t<decltype(std::declval<Observer&>().called())>, Watch>;
  else
    return std::same_as<Observer, Watch>;
}();
/// Whether an observer brings a scene to rest.
template <class Observer>
inline constexpr bool settles = requires {
  Observer::settles;
};

/// Whether all parts that do work report how much.
template <class Scene>
bool counts_all_work(const Scene& scene) {
  bool all = true;
  scene.for_each_part([&](const auto& part) {
    using P = std::remove_cvref_t<decltype(part)>;
    all = all && (counts_energy<P, Scene> || !(adds_force<P, Scene> || applies_impulses<P, Scene>));
  });
  return all;
}

}  // namespace detail

/// The watch of a run that was given none.
class DefaultWatch {
 public:
  template <class Scene>
  DefaultWatch(const Scene& scene, bool on, bool settles)
      : on_{on}, watch_{limits(detail::counts_all_work(scene))} {
    if (settles) watch_.accept_damping();
  }
  template <class Scene>
  void operator()(const Scene& scene) {
    if (on_) watch_(scene);
  }
  template <class Scene>
  void finish(const Scene& scene) {
    if (on_) watch_.finish(scene);
  }
  template <class F>
  void visit_state(F&& f) {
    watch_.visit_state(f);
  }

 private:
  static WatchLimits limits(bool knows_energy) {
    WatchLimits all = WatchLimits::of_runs();
    if (!knows_energy) all.energy_gain = all.residual = std::numeric_limits<double>::infinity();
    return all;
  }

  bool on_;
  WatchOfRun watch_;
};

/// When a run ends, and its steps.
struct RunOptions {
  double end = std::numeric_limits<double>::quiet_NaN();      ///< s, on the scene's clock
  double courant = 0.5;                                       ///< share of the stable step, above 0 to 1, -
  double max_step = std::numeric_limits<double>::infinity();  ///< s
  bool watch =
      true;  ///< checks for implausible results (`WatchLimits::of_runs`), unless an observer is a `Watch`

  /// Length of a step where `stable` is the stable one, s.
  double step_length(double stable) const { return std::min(courant * stable, max_step); }

  /// Throws `error` unless a scene at this time, s, can run so. A host's own loop may have no end.
  void check(double time, bool may_have_no_end = false) const {
    require(std::isfinite(end) || (may_have_no_end && end > 0), "RunOptions.end", end, "must be given");
    require(end >= time, "RunOptions.end", end, {"must not lie before the scene's time ", time});
    require(courant > 0, "RunOptions.courant", courant, "must be positive");
    require(courant <= 1, "RunOptions.courant", courant, "must be at most 1: larger steps are unstable");
    require(max_step > 0, "RunOptions.max_step", max_step, "must be positive");
  }
};

/// Steps of a run, before the first.
struct ExpectedSteps {
  double count = 0;
  double length = 0;  ///< s
};

/// The steps that a run would take if the stable step stayed what it is now. A mesh that is compressed to half
/// its height, say, doubles them. Throws `error` for a bad option.
template <class Scene>
ExpectedSteps expected_steps(const Scene& scene, const RunOptions& options) {
  options.check(scene.time);
  const double left = options.end - scene.time;
  const double length = std::min(options.step_length(stable_step(scene)), left);
  return {length > 0 ? std::ceil(left / length * (1 - 1e-9)) : 0, length};
}

/// The next step towards `options.end`, `span` s after the start of the run. Returns its length, s.
template <class Scene>
double step_towards(Scene& scene, const RunOptions& options, double span) {
  const double stable = scene.communicator().least(stable_step(scene));
  scene.step_check.know(stable, scene.steps);
  double dt = options.step_length(stable);
  if (!(dt > 1e-12 * span))
    throw run_error(joined_text({"t = ", scene.time, " s: the stable step has shrunk to ", dt, " s"}));
  const double left = options.end - scene.time;
  const bool last = dt >= left * (1 - 1e-9);
  if (last)
    dt = left;
  else if (2 * dt > left)
    dt = left / 2;  // the last two steps share what is left: a sliver of a step would turn impulses into
                    // huge forces
  step(scene, dt);
  if (last) scene.time = options.end;
  return dt;
}

namespace detail {

template <class Scene, class... Observers>
void run_steps(Scene& scene, const RunOptions& options, Observers&... observers) {
  bool stops = show_all(scene, observers...);
  const double span = options.end - scene.time;
  while (scene.time < options.end && !stops) {
    step_towards(scene, options, span);
    stops = show_all(scene, observers...);
  }
  (tell_end(scene, observers), ...);
}

}  // namespace detail

/// Steps `scene` until `options.end`. The last two steps are shortened to hit it exactly: a run that
/// continues from there does not have the bits of one to a later end. To have them, save the scene by an
/// observer (`every` shortens no step), or end the run by one. Each observer is called with the scene (const)
/// at the start and after every step; its `finish(scene)`, if it has one, is called at the end. An observer
/// that returns `RunFlow::stop` ends the run there (with several scenes over one mesh: in all of them, which
/// then need an observer that returns a `RunFlow` each). Warns of implausible results, and stops if energy
/// doubles from nothing, unless `options.watch` is false or an observer is a `Watch`. Throws `error` for a
/// bad option, `run_error` if the run fails; observers have then seen everything up to the previous step.
///
/// Scenes over the portions of one mesh (`on_portion`) are run together, each by its own call: all take the
/// least of their steps, and if one fails all do.
template <class Scene, class... Observers>
void run(Scene& scene, const RunOptions& options, Observers&&... observers) {
  options.check(scene.time);
  const auto steps = [&] {
    if constexpr ((detail::is_watch<std::remove_cvref_t<Observers>> || ...)) {
      detail::run_steps(scene, options, observers...);
    } else {
      DefaultWatch watch(scene, options.watch, (detail::settles<std::remove_cvref_t<Observers>> || ...));
      detail::run_steps(scene, options, observers..., watch);
    }
  };
  if constexpr (Scene::is_portion) {
    try {
      steps();
    } catch (const std::exception& e) {
      scene.communicator().fail(e.what());
      throw;
    }
  } else {
    steps();
  }
}

/// For a scene that the compiler has refused: the error is already reported.
template <class... Parts, class... Observers>
void run(RefusedScene<Parts...>&, const RunOptions&, Observers&&...) {}

/// Refused by the compiler: a scene that cannot change.
template <class Scene, class... Observers>
void run(const Scene&, const RunOptions&, Observers&&...) {
  static_assert(!std::is_object_v<Scene>,
                "run: the scene is stepped in place: it must be a variable that is not const");
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
