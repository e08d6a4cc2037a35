// Cold functions of frictional.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <arenite/law/frictional.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void detail::check_strength(std::string_view law, const Strength& p, bool remembers) {
  check(p.friction >= 0 && p.friction <= greatest_friction, law, "friction", p.friction,
        "must lie in [0, 1.55] rad (88.8 deg)");
  check(p.cohesion >= 0 && std::isfinite(p.cohesion), law, "cohesion", p.cohesion,
        "must not be negative (Pa)");
  check(p.friction > 0 || p.cohesion > 0, law, "cohesion", p.cohesion,
        "must be positive where friction is 0: matter without both has no strength");
  check(p.dilatancy >= 0 && p.dilatancy <= p.friction, law, "dilatancy", p.dilatancy,
        "must lie in [0, friction]");
  check(p.tension >= 0, law, "tension", p.tension, "must not be negative (Pa)");
  check(p.greatest_volume_ratio >= 1, law, "greatest_volume_ratio", p.greatest_volume_ratio,
        "must be at least 1");
  check(!remembers || p.tension >= apex(p.friction, p.cohesion), law, "tension", p.tension,
        "a law that remembers its opening needs the cut-off at the apex (leave tension out)");
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
