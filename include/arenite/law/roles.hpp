// Roles of a law: its optional members, matched by name first and then by signature. Otherwise a
// member with a role's name and another signature would be ignored without a message.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/role_names.hpp>
#include <arenite/law/law.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// By the type of its address: the use of a member that is not static would be another compile error.
template <class L>
constexpr bool max_pack_width_is_right() {
  if constexpr (!names_max_pack_width<L>)
    return true;
  else if constexpr (std::is_same_v<decltype(&L::max_pack_width), const int*>)
    return L::max_pack_width > 0;
  else
    return false;
}
template <class L>
concept two_packs_at_once_is_right = !names_two_packs_at_once<L> || requires {
  typename std::bool_constant<L::two_packs_at_once>;
};

}  // namespace detail

/// Whether the members of a law on packs are as required.
template <class L>
concept wishes_packs_rightly = detail::max_pack_width_is_right<L>() && detail::two_packs_at_once_is_right<L>;

/// Whether the `update` of a law can be called with scalars P, which may be packs.
template <class L, class P, int D>
concept takes_lanes = requires(const L law, Sym<P, D> stress, const StrainStep<P, D> step,
                               typename L::template History<P> history) {
  law.update(stress, step, history);
};

/// Stops the compiler with the cure for a law that `constitutive_law` lets pass and that would not do what
/// its members say.
template <class L, class T, int D>
constexpr bool check_law() {
  using History = typename L::template History<T>;
  static_assert(!std::is_final_v<L>, "law: must not be final");
  // An overload makes the address of a member ambiguous.
  static_assert(
      requires { &L::wave_modulus; } || stiffness_varies<L, T, D>,
      "law: wave_modulus in a given state must be wave_modulus(stress, history) const");
  static_assert(!names_stable_step<L> || limits_step<L>,
                "law: stable_step must be double stable_step(double h) const");
  static_assert(!names_is_open<L> || knows_opening<L, T>, "law: is_open must be is_open(history) const");
  static_assert(!names_yield<L> || knows_yield<L, T, D>,
                "law: yield must be yield(stress) const or yield(stress, history) const");
  static_assert(
      !(names_greatest_volume_ratio<L> || dilates<L, T, D>) ||
          requires(const L law) {
            { law.greatest_volume_ratio() } -> std::convertible_to<double>;
          },
      "law: one that returns Inelastic needs double greatest_volume_ratio() const");
  static_assert(detail::max_pack_width_is_right<L>(),
                "law: max_pack_width must be static constexpr int, and positive");
  static_assert(detail::two_packs_at_once_is_right<L>,
                "law: two_packs_at_once must be static constexpr bool");
  static_assert(
      !names_linear<L> || requires { typename std::bool_constant<L::linear>; },
      "law: linear must be static constexpr bool");
  static_assert(
      !names_names<History> ||
          requires { typename std::enable_if<std::size(History::names) == history_size<History>>::type; },
      "law: History::names must be a static constexpr std::array with a name for each of members()");
  return true;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
