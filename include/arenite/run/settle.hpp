// Settle: dynamic relaxation. Steps a damped scene until its forces are in balance.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>

#include <arenite/run/run.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Unbalanced force ratio of the last step: sum of |m dv/dt| of the nodes over the sum of the greater of force (internal and of parts) and weight. 0 where nothing acts.
template <class Scene>
double out_of_balance(const Scene& scene) {
  static_assert(Scene::has_start_state,
                "out_of_balance: the scene does not keep the forces of its nodes: name a part that damps, "
                "LocalDamping{} or ViscousDamping{..}");
  using V = typename Scene::V;
  const V acceleration = scene.acceleration();
  const auto owns = scene.node_owner();
  double out = 0, all = 0;
  if (scene.time_step > 0)
    for (const auto& field : scene.fields)
      for (std::size_t i = 0; i < field.size(); ++i) {
        if (!(field.mass[i] > 0) || !owns(static_cast<Index>(i))) continue;
        const V change = field.velocity[i] - field.start[i];
        out += static_cast<double>(field.mass[i] * change.norm()) / scene.time_step;
        all +=
            static_cast<double>(std::max(field.sums[i].force().norm(), field.mass[i] * acceleration.norm()));
      }
  sum_over(scene.communicator(), out, all);
  return all > 0 ? out / all : 0;
}

/// When a scene counts as settled, and its steps.
struct SettleOptions {
  double ratio = 1e-3;                                    ///< greatest force out of balance, -; positive
  double end = std::numeric_limits<double>::quiet_NaN();  ///< s on the scene's clock; required: by when
  double courant = 0.5;                                   ///< as in `RunOptions`
  bool watch = true;                                      ///< as in `RunOptions`

  /// Options of its run. Throws `error` unless a scene at this time, s, can settle so.
  RunOptions of_run(double time) const {
    require(ratio > 0, "SettleOptions.ratio", ratio, "must be positive");
    require(end > time && std::isfinite(end), "SettleOptions.end", end,
            {"must be given, and lie behind the scene's time ", time});
    return {.end = end, .courant = courant, .watch = watch};
  }
};

/// Observer of `settle`: ends a run of a scene in which a part damps once its forces have been in balance for
/// ten steps.
struct Settled {
  static constexpr bool settles = true;
  SettleOptions options;
  std::size_t from;    ///< the scene's steps at the start
  int below = 0;       ///< steps in balance so far
  double reached = 0;  ///< `out_of_balance` of the last step, -
  template <class Scene>
  RunFlow operator()(const Scene& scene) {
    if (scene.steps > from) {
      reached = out_of_balance(scene);
      below = reached <= options.ratio ? below + 1 : 0;
    }
    return below < 10 ? RunFlow::go_on : RunFlow::stop;
  }
  /// After the run, at this time, s: whether the scene has settled; false if another observer ended the run
  /// before. Throws `run_error` if the end came first.
  bool at_end(double time) const {
    if (below >= 10 || time < options.end) return below >= 10;
    throw run_error(
        joined_text({"t = ", time, " s: settle: forces are out of balance by ", reached, ", not at most ",
                     options.ratio, "; more time, or a part that damps (LocalDamping)?"}));
  }

  template <class F>
  void visit_state(F&& f) {
    f("below", below);
    f("reached", reached);
  }
};

/// Steps a scene, in which a part damps (`LocalDamping`), until `out_of_balance` has been at most
/// `options.ratio` for ten steps. Observers as in `run`. Returns whether the scene has settled: false if an
/// observer ended the run first. Switch damping off afterwards and continue with `run`:
/// `scene.part<LocalDamping>().switch_off()`. Throws `error` for a bad option, `run_error` if `options.end`
/// comes first, with the ratio that was reached.
template <class Scene, class... Observers>
bool settle(Scene& scene, const SettleOptions& options, Observers&&... observers) {
  const RunOptions of_run = options.of_run(scene.time);
  Settled check{options, scene.steps};
  run(scene, of_run, observers..., check);
  return check.at_end(scene.time);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
