// Stiffness chosen at run time.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/law/frictional/any_policy.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One of `Stiffnesses` (policies.hpp), the same for all points: `AnyStiffness{PressureStiffness{}}`; none:
/// the moduli of the law's parameters. A law with it has the bits of one with that policy itself. It shares
/// the history of `AnyFriction` or `RateSofteningFriction`; the stable step follows the state of the points.
class AnyStiffness : public detail::AnyPolicy<Stiffnesses> {
 public:
  static constexpr bool reads_friction_history = true;
  template <class T>
  using History = JoinedHistories<T>;

  AnyStiffness() = default;
  explicit AnyStiffness(const Policy& policy) : AnyPolicy(policy) {}

  template <class T, int D>
  T factor(const Sym<T, D>& stress, const History<T>& history) const {
    return visit([&](const auto& p) -> T { return p.factor(stress, own<T>(p, history)); });
  }
  template <class T, int D>
  T energy(const Elasticity& elasticity, const Sym<T, D>& stress, const History<T>& history) const {
    return visit([&](const auto& p) -> T { return p.energy(elasticity, stress, own<T>(p, history)); });
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
