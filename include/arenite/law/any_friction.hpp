// Friction chosen at run time: one type for all of the library's policies, so that what is compiled with it
// serves them all.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <type_traits>
#include <variant>

#include <arenite/law/inertial_friction.hpp>
#include <arenite/law/linear_rate_friction.hpp>
#include <arenite/law/logarithmic_friction.hpp>
#include <arenite/law/rate_softening_friction.hpp>
#include <arenite/law/softening_friction.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One of the library's policies (friction.hpp), the same for all points: `AnyFriction{LinearRateFriction{..}}`.
/// Stresses, rates, openings and dilations have the bits of a law with that policy itself where the scalar is
/// double, but for products that the compiler fuses in one of them alone (FMA at -O3; seen in `yield` of
/// scalars). In float the constants of its dilatancy are computed in float, too, and differ by round-off.
///
/// In Mohr-Coulomb a point-step takes 0.2 to 0.7 ns more where all is elastic and 0.6 to 1.2 ns where 60 % yield,
/// of some 55 ns of a scene's (packs of eight, AVX-512): 1.00 to 1.05 of the time of steps.
///
/// The history has both `shear_rate`, which stays 0 if the policy does not read it, and `plastic_strain`,
/// which is kept up for all of them.
class AnyFriction {
 public:
  template <class T>
  using History = JoinedHistory<ShearRateHistory<T>, PlasticStrainHistory<T>>;
  using Policy = std::variant<ConstantFriction, LinearRateFriction, InertialFriction, LogarithmicFriction,
                              SofteningFriction, RateSofteningFriction>;

  AnyFriction() = default;
  explicit AnyFriction(const Policy& policy) : policy_{policy} {}

  const Policy& policy() const { return policy_; }

  bool constant() const {
    return std::visit(
        [](const auto& p) {
          if constexpr (std::is_same_v<decltype(p), const ConstantFriction&>)
            return true;
          else
            return p.constant();
        },
        policy_);
  }
  bool implicit() const { return std::holds_alternative<InertialFriction>(policy_); }
  bool own_dilatancy() const {
    return std::visit(
        [](const auto& p) {
          return requires(GivenAngles g) { p.dilatancy_slope(g, History<double>{}); };
        },
        policy_);
  }
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
            return detail::no_least_slope;
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
          if constexpr (std::is_same_v<decltype(p), const ConstantFriction&>)
            return T(given.slope);
          else if constexpr (requires { p.slope(given, step, trial, own(p, history)); })
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

  Policy policy_{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
