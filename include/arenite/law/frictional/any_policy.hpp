// Policy chosen at run time: what those of friction, memory and stiffness share.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <type_traits>
#include <utility>
#include <variant>

#include <arenite/law/frictional/policies.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// Histories of policies as one, each once.
template <class T, class Joined, class... H>
struct HistoryOfAll {
  using type = Joined;
};
template <class T, class Joined, class First, class... H>
struct HistoryOfAll<T, Joined, First, H...>
    : HistoryOfAll<T,
                   std::conditional_t<std::is_same_v<Joined, NoHistory<T>>, First,
                                      std::conditional_t<std::is_same_v<First, NoHistory<T>> ||
                                                             std::is_base_of_v<First, Joined>,
                                                         Joined, JoinedHistory<Joined, First>>>,
                   H...> {};

/// One policy of a family, the same for all points: its history is that of all of them.
template <class Family>
class AnyPolicy {
  template <class... P>
  struct Histories {
    template <class T>
    using of = typename HistoryOfAll<T, NoHistory<T>, typename P::template History<T>...>::type;
  };

 public:
  using Policy = typename Family::template in<std::variant>;
  template <class T>
  using JoinedHistories = typename Family::template in<Histories>::template of<T>;
  template <class T>
  struct History : JoinedHistories<T> {};

  AnyPolicy() = default;
  explicit AnyPolicy(const Policy& policy) : policy_{policy} {}

  const Policy& policy() const { return policy_; }

  /// Calls `call` with the policy: once for all points of a pack.
  template <class Call>
  decltype(auto) visit(const Call& call) const {
    return std::visit(call, policy_);
  }

 protected:
  /// The part that a policy P reads of the history of all.
  template <class T, class P, class All>
  static auto& own(const P&, [[maybe_unused]] All& history) {
    using Part = typename P::template History<T>;
    if constexpr (std::is_empty_v<Part>) {
      static Part none;
      return none;
    } else {
      return static_cast<std::conditional_t<std::is_const_v<All>, const Part, Part>&>(history);
    }
  }

 private:
  Policy policy_{};
};

}  // namespace detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
