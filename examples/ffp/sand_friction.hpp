// Friction of the sand, chosen at run time: one type for all laws of the options, so that a drop's scene is
// compiled once for them.
#pragma once

#include <variant>

#include <arenite/law/inertial_friction.hpp>
#include <arenite/law/linear_rate_friction.hpp>
#include <arenite/law/logarithmic_friction.hpp>
#include <arenite/law/rate_softening_friction.hpp>
#include <arenite/law/softening_friction.hpp>

#include "law_options.hpp"

namespace arenite::ffp {

/// One of the library's policies (arenite/law/friction.hpp). All points have the same one, so that a step
/// asks once for each pack of points.
class SandFriction {
 public:
  template <class T>
  using History = JoinedHistory<ShearRateHistory<T>, PlasticStrainHistory<T>>;
  using Policy = std::variant<LinearRateFriction, InertialFriction, LogarithmicFriction, SofteningFriction,
                              RateSofteningFriction>;

  explicit SandFriction(const Policy& policy) : policy_{policy} {}

  bool constant() const {
    return std::visit([](const auto& p) { return p.constant(); }, policy_);
  }
  bool implicit() const { return std::holds_alternative<InertialFriction>(policy_); }
  void check(const GivenAngles& given) const {
    std::visit(
        [&](const auto& p) {
          if constexpr (requires { p.check(given); }) p.check(given);
        },
        policy_);
  }
  double least_slope(const GivenAngles& given) const {
    return std::visit(
        [&](const auto& p) {
          if constexpr (requires { p.least_slope(given); })
            return p.least_slope(given);
          else
            return given.slope;
        },
        policy_);
  }
  template <class T, int D>
  void follow(const StrainStep<T, D>& step, History<T>& history) const {
    std::visit(
        [&](const auto& p) {
          if constexpr (requires { p.follow(step, own(p, history)); }) p.follow(step, own(p, history));
        },
        policy_);
  }
  template <class T, int D>
  T slope(const GivenAngles& given, const StrainStep<T, D>& step, const Sym<T, D>& trial,
          const History<T>& history) const {
    return std::visit(
        [&](const auto& p) {
          if constexpr (requires { p.slope(given, step, trial, own(p, history)); })
            return p.slope(given, step, trial, own(p, history));
          else
            return p.slope(given.slope, step, own(p, history));
        },
        policy_);
  }
  template <class T>
  T dilatancy_slope(const GivenAngles& given, const History<T>& history) const {
    return std::visit(
        [&](const auto& p) {
          if constexpr (requires { p.dilatancy_slope(given, own(p, history)); })
            return p.dilatancy_slope(given, own(p, history));
          else
            return T(given.dilatancy_slope);
        },
        policy_);
  }
  template <class T>
  void flow(const T& strain, History<T>& history) const {
    history.plastic_strain = history.plastic_strain + strain;
  }

 private:
  /// The part of the history that a policy reads.
  template <class P, class T>
  static typename P::template History<T>& own(const P&, History<T>& history) {
    return history;
  }
  template <class P, class T>
  static const typename P::template History<T>& own(const P&, const History<T>& history) {
    return history;
  }

  Policy policy_;
};

/// The policy of a law other than Mohr-Coulomb; `cell`: the edge of its cells, m.
inline SandFriction friction_of(const LawOptions& o, double cell) {
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
      return SandFriction{LinearRateFriction{{.time = o.rate_time, .smoothing = o.rate_smoothing}}};
    case LawKind::mu_i:
      return SandFriction{InertialFriction{{.rise = o.mu_rise,
                                            .reference_inertia = o.mu_inertia,
                                            .grain_size = o.grain_size,
                                            .grain_density = o.grain_density,
                                            .smoothing = o.rate_smoothing}}};
    case LawKind::log_rate:
      return SandFriction{LogarithmicFriction{
          {.per_decade = o.per_decade, .reference_rate = o.reference_rate, .smoothing = o.rate_smoothing}}};
    case LawKind::softening:
      return SandFriction{SofteningFriction{softening()}};
    case LawKind::softening_rate:
      return SandFriction{RateSofteningFriction{{.softening = softening(),
                                                 .friction_per_decade = o.per_decade,
                                                 .dilatancy_per_decade = o.dilatancy_per_decade,
                                                 .reference_rate = o.reference_rate,
                                                 .smoothing = o.rate_smoothing}}};
  }
  throw error("friction_of: Mohr-Coulomb has no friction by point");
}

}  // namespace arenite::ffp
