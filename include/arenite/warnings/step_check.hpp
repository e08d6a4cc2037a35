// Step check: whether the length of a step is valid, and stable for the scene. A host that chooses its own
// steps learns of a mistake at its first one.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <arenite/core/cold.hpp>
#include <arenite/core/error.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Checks the length of each step of a scene. The stable step costs a few percent of a step, so it is asked
/// for at the first step, at every `interval`th, and for a step longer than the last answer; `run`, which
/// knows it, passes it on (`know`).
class StepCheck {
 public:
  static constexpr std::size_t interval = 64;  ///< steps for which an answer is assumed valid

  /// dt: length of step number `step`, s; `stable()`: the stable step of the scene now, s; of scenes over the
  /// portions of one mesh the least, which all ask for at once. Throws `error` unless dt is positive and finite.
  /// Warns, once a scene and if it `speaks`, of one above the stable step.
  template <class Stable>
  void operator()(double dt, double time, std::size_t step, const Stable& stable, bool speaks) {
    if (!(dt > 0 && dt <= longest_ && step < until_)) look(dt, time, step, stable, speaks);
  }

  /// The stable step is known at step number `step`, s.
  void know(double stable, std::size_t step) {
    if (has_warned()) return;
    longest_ = std::min(stable * (1 + round_off), std::numeric_limits<double>::max());
    until_ = step + 1;
  }

 private:
  static constexpr double round_off = 1e-6;  // of a step that is a sum, or a share, in single precision
  static constexpr std::size_t for_ever = std::numeric_limits<std::size_t>::max();

  bool has_warned() const { return until_ == for_ever; }

  template <class Stable>
  void look(double dt, double time, std::size_t step, const Stable& stable, bool speaks) {
    require(dt > 0 && std::isfinite(dt), "step: dt", dt, "must be positive and finite (s)");
    judge(dt, time, step, stable(), speaks);
  }
  void judge(double dt, double time, std::size_t step, double bears, bool speaks);

  double longest_ = 0;  // steps up to this one pass unchecked, s
  std::size_t until_ = 0;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <arenite/core/warning.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void StepCheck::judge(double dt, double time, std::size_t step, double bears, bool speaks) {
  know(bears, step);
  until_ = step + interval;
  if (!(dt > longest_)) return;
  longest_ = std::numeric_limits<double>::max();
  until_ = for_ever;
  if (!speaks) return;
  warn(joined_text({"t = ", time, " s, step ", step + 1, ": dt = ", dt, " s is ", dt / bears,
                    " times the stable step of ", bears,
                    " s: velocities grow from step to step until points leave the mesh or numbers are no "
                    "longer finite; take a share below 1 of stable_step(scene), or let run choose"}));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
