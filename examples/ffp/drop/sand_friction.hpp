// Friction of the sand as the options name it, chosen at run time, so that a drop's scene is compiled once for
// all laws.
#pragma once

#include <arenite/law/frictional/any_friction.hpp>

#include "../options/law_options.hpp"

namespace arenite::ffp {

/// The policy of a law other than Mohr-Coulomb; `cell`: the edge of its cells, m.
inline AnyFriction friction_of(const LawOptions& o, double cell) {
  const auto softening = [&] {
    return SofteningParameters{.residual_friction = o.residual.value() * pi / 180,
                               .residual_dilatancy = o.residual_dilatancy * pi / 180,
                               .decay = o.decay,
                               .cell_size = o.decay_cell ? cell : 0,
                               .reference_size = o.decay_cell.value_or(0)};
  };
  switch (o.kind) {
    case LawKind::mohr_coulomb:
      break;
    case LawKind::linear_rate:
      return AnyFriction{LinearRateFriction{{.time = o.rate_time, .smoothing = o.rate_smoothing}}};
    case LawKind::mu_i:
      return AnyFriction{InertialFriction{{.rise = o.mu_rise,
                                           .reference_inertia = o.mu_inertia,
                                           .grain_size = o.grain_size,
                                           .grain_density = o.grain_density,
                                           .smoothing = o.rate_smoothing}}};
    case LawKind::log_rate:
      return AnyFriction{LogarithmicFriction{
          {.per_decade = o.per_decade, .reference_rate = o.reference_rate, .smoothing = o.rate_smoothing}}};
    case LawKind::softening:
      return AnyFriction{SofteningFriction{softening()}};
    case LawKind::softening_rate:
      return AnyFriction{RateSofteningFriction{{.softening = softening(),
                                                .friction_per_decade = o.per_decade,
                                                .dilatancy_per_decade = o.dilatancy_per_decade,
                                                .reference_rate = o.reference_rate,
                                                .smoothing = o.rate_smoothing}}};
  }
  throw error("friction_of: Mohr-Coulomb has no friction by point");
}

}  // namespace arenite::ffp
