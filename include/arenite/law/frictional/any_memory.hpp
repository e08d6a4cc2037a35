// Memory of separation chosen at run time.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/law/frictional/any_policy.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One of `Memories` (policies.hpp), the same for all points: `AnyMemory{RemembersOpening{}}`; none: forgets.
/// A law with it has the bits of one with that policy itself. The history has `opening`, which stays 0 if the
/// policy forgets.
class AnyMemory : public detail::AnyPolicy<Memories> {
 public:
  AnyMemory() = default;
  explicit AnyMemory(const Policy& policy) : AnyPolicy(policy) {}

  bool remembers() const {
    return visit([](const auto& p) { return p.remembers(); });
  }

  template <class T, int D>
  StrainStep<T, D> carried(Sym<T, D>& stress, const StrainStep<T, D>& step, History<T>& history) const {
    return visit(
        [&](const auto& p) -> StrainStep<T, D> { return p.carried(stress, step, own<T>(p, history)); });
  }
  template <class T>
  void open(const T& opening, History<T>& history) const {
    visit([&](const auto& p) { p.open(opening, own<T>(p, history)); });
  }
  /// Whether matter is open, and so carries no stress.
  template <class T>
  auto is_open(const History<T>& history) const {
    using mask_of = decltype(std::declval<T>() > std::declval<T>());
    return visit([&](const auto& p) -> mask_of {
      if constexpr (requires { p.is_open(own<T>(p, history)); })
        return p.is_open(own<T>(p, history));
      else
        return mask_of(false);
    });
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
