// Friction chosen at run time: one type for all of the library's policies, so that code compiled with it
// serves them all.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/law/frictional/any_policy.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One of `Frictions` (policies.hpp), the same for all points: `AnyFriction{LinearRateFriction{..}}`.
/// Stresses, rates, openings and dilations have the bits of a law with that policy itself where the scalar is
/// double, except for products that the compiler fuses in only one of them (FMA at -O3; seen in `yield` of
/// scalars). In float the constants of its dilatancy are computed in float, too, and differ by round-off.
///
/// In Mohr-Coulomb a point-step takes 0.2 to 0.9 ns more where all is elastic and 0.6 to 1.6 ns where 60 %
/// yield (packs of eight, AVX-512). A drop with `LinearRateFriction`, which is the cheapest, takes 1.06 to
/// 1.08 of the time (packs of two): much of it for the two numbers of the history.
///
/// The history is that of all of them: `shear_rate`, which stays 0 if the policy does not read it, and
/// `plastic_strain`, which is kept up for all.
class AnyFriction : public detail::AnyPolicy<Frictions> {
 public:
  AnyFriction() = default;
  explicit AnyFriction(const Policy& policy)
      : AnyPolicy(policy),
        constant_(visit([](const auto& p) { return detail::same_as_constant(p); })),
        own_dilatancy_(visit([](const auto& p) {
          return requires(GivenAngles g, const History<double> h) {
            p.dilatancy_slope(g, own<double>(p, h));
          };
        })) {}

  bool constant() const { return constant_; }
  bool own_dilatancy() const { return own_dilatancy_; }
  bool implicit() const {
    return visit([](const auto& p) {
      if constexpr (requires { p.implicit(); }) return p.implicit();
      return false;
    });
  }
  void check(const GivenAngles& given) const {
    visit([&](const auto& p) {
      if constexpr (requires { p.check(given); }) p.check(given);
    });
  }
  double least_slope(const GivenAngles& given) const {
    return visit([&](const auto& p) {
      if constexpr (requires { p.least_slope(given); }) return p.least_slope(given);
      return detail::no_least_slope;
    });
  }

  template <class T, int D>
  void follow(const StrainStep<T, D>& step, History<T>& history) const {
    visit([&](const auto& p) {
      if constexpr (requires { p.follow(step, own<T>(p, history)); }) p.follow(step, own<T>(p, history));
    });
  }
  template <class T, int D>
  T slope(const GivenAngles& given, const StrainStep<T, D>& step, const Sym<T, D>& trial,
          const History<T>& history) const {
    return visit([&](const auto& p) -> T {
      if constexpr (requires { p.slope(given, step, trial, own<T>(p, history)); })
        return p.slope(given, step, trial, own<T>(p, history));
      else
        return p.slope(given.slope, step, own<T>(p, history));
    });
  }
  template <class T>
  T dilatancy_slope(const GivenAngles& given, const History<T>& history) const {
    return visit([&](const auto& p) -> T {
      if constexpr (requires { p.dilatancy_slope(given, own<T>(p, history)); })
        return p.dilatancy_slope(given, own<T>(p, history));
      else
        return T(given.dilatancy_slope);
    });
  }

 private:
  bool constant_ = true, own_dilatancy_ = false;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
