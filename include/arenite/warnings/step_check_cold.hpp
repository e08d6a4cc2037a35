// Cold functions of step_check.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/warning.hpp>
#include <arenite/warnings/step_check.hpp>

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
