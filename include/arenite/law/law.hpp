// The concept of a constitutive law: mathematics over a scalar, which may be a pack. Storage and loops live
// elsewhere.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <concepts>
#include <limits>
#include <string_view>
#include <tuple>

#include <arenite/law/strain_step.hpp>
#include <arenite/simd/pack_functions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// History of a law that has none: it stores no columns.
template <class T>
struct NoHistory {
  constexpr auto members() { return std::tie(); }
  constexpr auto members() const { return std::tie(); }
};

/// A tie of all numbers of an array, for the `members()` of a history.
template <class Array>
constexpr auto tied(Array& numbers) {
  return std::apply([](auto&... number) { return std::tie(number...); }, numbers);
}

/// The parts of a step's volumetric strain, -, that do not change the mean stress elastically.
template <class T>
struct Inelastic {
  T opening;   ///< by which the matter separated (see below)
  T dilation;  ///< plastic volumetric strain of matter that stayed in contact: its dilatancy
};

/// A constitutive law for points in D dimensions over scalar T: a class, not `final`, with
///
/// - `History<T>`: a struct of scalars with `members()` giving a tie of them; `NoHistory<T>` if none. Points
///   begin with the values that it is made with, or with those of `FillOptions::history`; a member that the
///   law does not change is a parameter that varies by point. Optional `static constexpr std::array names
///   {"opening"}`: a name for each member, by which files and `FillOptions` know it; an empty one hides it.
/// - `density()`: mass of the unstressed unit volume, kg/m3.
/// - `wave_modulus()`: density times the square of the fastest wave's speed in unstressed matter, Pa; it
///   gives the stable step.
/// - `update(stress, step, history)`: Cauchy stress [Pa, tension positive] taken through one `StrainStep`, in
///   place. Returns the change of the volumetric strain [-] that the matter *opened* without stress
///   (separated grains): positive where it opens, negative where a law with memory closes what had opened,
///   else T(0). The point's volume does not change by it, V <- V exp(tr(strain) - opening), so that nothing
///   is swollen when it is compressed again. A step of zero is allowed: it takes an inadmissible initial
///   stress back; `step.dt` may be zero too. A law whose matter also dilates as it flows returns
///   `Inelastic<T>`, its opening and its dilation: averages of the strain must leave the latter where it
///   arises (`NodalAveraging`).
/// - `elastic_energy(stress)` or `elastic_energy(stress, history)`: recoverable energy of the unit volume,
///   J/m3.
///
/// and, where it needs them,
///
/// - `wave_modulus(stress, history)`: the same in a given state; the stable step then follows the state.
/// - `stable_step(h)`: the law's own limit on the step, s, double to double, in matter whose waves of speed c
///   allow a step of h / c; h is the size of a cell times `Numerics::courant_limit`. A viscosity eta, Pa s,
///   has h^2 density / (2 eta).
/// - `static void check_history(name, value)`: throws `error` for an initial value that no point can have.
/// - `is_open(history)`: mask of matter that has separated and carries no stress; averages of strain and
///   stress then leave it out.
/// - `static constexpr bool linear = true`: beside the turn with the matter, what `update` adds to the stress
///   is linear in the strain, whatever history and time. Bodies of such laws take their stresses at the
///   middle of the step (`add_half_step`). A law derived from one that says so and is not itself says false.
/// - `greatest_volume_ratio()`, needed of a law that returns `Inelastic<T>`: V / V0, -, beyond which the
///   matter dilates no further.
/// - `yield(stress)` or `yield(stress, history)`: how far a stress lies outside the yield surface (> 0) or
///   within (< 0), as a fraction of the stress, -, for `Watch`.
/// - `static constexpr int max_pack_width`: most points that a loop may pass at once; 1 for a law with
///   `if`s on its scalars. Without it laws are called with a register's worth of points: write branches as
///   `select`, and the functions of <cmath> without `std::` (`simd/pack_functions.hpp`).
/// - `static constexpr bool two_packs_at_once = true` for a long chain of dependent operations: the loop
///   calls it with two packs side by side.
///
/// A scene checks the name first and then the signature: a member with such a name and another signature is
/// refused.
///
/// Where there are fewer points than a pack has lanes, the unused lanes repeat one of them: a law is called
/// only with states that a point has.
template <class L, class T = double, int D = 3>
concept constitutive_law = requires(const L law, Sym<T, D> stress, const StrainStep<T, D> step,
                                    typename L::template History<T> history) {
  { law.density() } -> std::convertible_to<double>;
  { law.wave_modulus() } -> std::convertible_to<double>;
  requires std::convertible_to<decltype(law.update(stress, step, history)), T> ||
      std::same_as<decltype(law.update(stress, step, history)), Inelastic<T>>;
  requires requires {
    { law.elastic_energy(stress) } -> std::convertible_to<T>;
  } || requires {
    { law.elastic_energy(stress, history) } -> std::convertible_to<T>;
  };
  history.members();
};

/// Whether a law's matter dilates as it flows: `update` returns `Inelastic<T>`.
template <class L, class T = double, int D = 3>
inline constexpr bool dilates =
    std::same_as<decltype(std::declval<const L&>().update(std::declval<Sym<T, D>&>(),
                                                          std::declval<const StrainStep<T, D>&>(),
                                                          std::declval<typename L::template History<T>&>())),
                 Inelastic<T>>;

/// Whether a law reports which matter has separated (`is_open`).
template <class L, class T = double>
inline constexpr bool knows_opening = requires(const L law, const typename L::template History<T> history) {
  law.is_open(history);
};

/// Whether a law's stiffness depends on the state (`wave_modulus(stress, history)`).
template <class L, class T = double, int D = 3>
inline constexpr bool stiffness_varies = requires(const L law, const Sym<T, D> stress,
                                                  const typename L::template History<T> history) {
  { law.wave_modulus(stress, history) } -> std::convertible_to<T>;
};

/// Whether a law has its own limit on the step (`stable_step`).
template <class L>
inline constexpr bool limits_step = requires(const L law) {
  { law.stable_step(1.0) } -> std::convertible_to<double>;
};

/// Whether a law knows its yield surface (`yield`).
template <class L, class T = double, int D = 3>
inline constexpr bool knows_yield = requires(const L law, const Sym<T, D> stress,
                                             const typename L::template History<T> history) {
  requires requires { law.yield(stress); } || requires {
    law.yield(stress, history);
  };
};

/// `elastic_energy` and `yield` of a law, by stress and history or only by stress.
template <class L, class S, class H>
auto elastic_energy_of(const L& law, const S& stress, const H& history) {
  if constexpr (requires { law.elastic_energy(stress, history); })
    return law.elastic_energy(stress, history);
  else
    return law.elastic_energy(stress);
}
template <class L, class S, class H>
auto yield_of(const L& law, const S& stress, const H& history) {
  if constexpr (requires { law.yield(stress, history); })
    return law.yield(stress, history);
  else
    return law.yield(stress);
}

/// Whether the stress that a law adds is linear in the strain increment (`static constexpr bool linear =
/// true`).
template <class L>
inline constexpr bool is_linear = requires {
  requires L::linear;
};

/// Both parts of what `update` returned; a law that returns only its opening does not dilate.
template <class T>
Inelastic<T> inelastic(const T& opening) {
  return {opening, T(0)};
}
template <class T>
Inelastic<T> inelastic(const Inelastic<T>& parts) {
  return parts;
}

/// Most points that a loop may pass to law L at once.
template <class L>
inline constexpr int max_pack_width = [] {
  if constexpr (requires { L::max_pack_width; }) return L::max_pack_width;
  return std::numeric_limits<int>::max();
}();

/// Whether law L is called with two packs side by side.
template <class L>
inline constexpr bool two_packs_at_once = [] {
  if constexpr (requires { L::two_packs_at_once; }) return L::two_packs_at_once;
  return false;
}();

/// Number of a history's members, and their names; empty ones where it has none.
template <class H>
inline constexpr std::size_t history_size = std::tuple_size_v<decltype(std::declval<H&>().members())>;
template <class H>
inline constexpr std::array<std::string_view, history_size<H>> history_names = [] {
  std::array<std::string_view, history_size<H>> names{};
  if constexpr (requires { H::names; }) std::copy(H::names.begin(), H::names.end(), names.begin());
  return names;
}();

/// Two histories as one: that of a law beside that of a policy, or of a law that wraps it.
template <class A, class B>
struct JoinedHistory : A, B {
  constexpr auto members() { return std::tuple_cat(A::members(), B::members()); }
  constexpr auto members() const { return std::tuple_cat(A::members(), B::members()); }
  static constexpr auto names = [] {
    std::array<std::string_view, history_size<A> + history_size<B>> all{};
    std::copy(history_names<B>.begin(), history_names<B>.end(),
              std::copy(history_names<A>.begin(), history_names<A>.end(), all.begin()));
    return all;
  }();
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
