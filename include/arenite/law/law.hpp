// The concept of a constitutive law: mathematics over a scalar, which may be a pack. Storage and loops live
// elsewhere.
#pragma once

#include <concepts>
#include <limits>
#include <tuple>

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// History of a law that has none: it stores no columns.
template <class T>
struct NoHistory {
  constexpr auto members() { return std::tie(); }
  constexpr auto members() const { return std::tie(); }
};

/// The parts of a step's volumetric strain, -, that do not change the mean stress elastically.
template <class T>
struct Inelastic {
  T opening;   ///< by which the matter separated (see below)
  T dilation;  ///< plastic volumetric strain of matter that stayed in contact: its dilatancy
};

/// A constitutive law for points in D dimensions over scalar T.
///
/// - `History<T>`: a struct of scalars with `members()` giving a tie of them; `NoHistory<T>` if none.
/// - `density()`: mass of the unstressed unit volume, kg/m3.
/// - `wave_modulus()`: density times the square of the fastest wave's speed, Pa; it gives the stable step.
/// - `update(stress, increment, history)`: Cauchy stress [Pa, tension positive] taken through one step, in
///   place. Returns the change of the volumetric strain [-] that the matter *opened* without stress
///   (separated grains): positive where it opens, negative where a law with memory closes what had opened,
///   else T(0). The point's volume does not change by it, V <- V exp(tr(strain) - opening), so that nothing
///   is swollen when it is compressed again. An increment of zero is allowed: it takes an inadmissible
///   initial stress back. A law whose matter also dilates as it flows returns `Inelastic<T>`, its opening and
///   its dilation: averages of the strain must leave the latter where it arises (`NodalAveraging`).
/// - `elastic_energy(stress)`: recoverable energy, J/m3.
/// - optional `static constexpr int widest`: widest pack that a loop may call it with; 1 for a law with `if`s
///   on its scalars. Without it laws are called with a register's worth of points at once: write branches as
///   `select`.
/// - optional `static constexpr bool twins = true` for a long chain of dependent operations: the loop calls
///   it with two packs side by side.
/// - optional `is_open(history)`: mask of matter that has separated and bears no stress; averages of strain
///   and stress then leave it out.
/// - `greatest_volume_ratio()`, needed of a law that returns `Inelastic<T>`: V / V0, -, beyond which the
///   matter dilates no further.
///
/// Where there are fewer points than a pack has lanes, the lanes left over repeat one of them: a law meets no
/// state that no point has.
template <class L, class T = double, int D = 3>
concept constitutive_law = requires(const L law, Sym<T, D> stress, const Increment<T, D> increment,
                                    typename L::template History<T> history) {
  { law.density() } -> std::convertible_to<double>;
  { law.wave_modulus() } -> std::convertible_to<double>;
  requires std::convertible_to<decltype(law.update(stress, increment, history)), T> ||
      std::same_as<decltype(law.update(stress, increment, history)), Inelastic<T>>;
  { law.elastic_energy(stress) } -> std::convertible_to<T>;
  history.members();
};

/// Whether a law's matter dilates as it flows: `update` returns `Inelastic<T>`.
template <class L, class T = double, int D = 3>
inline constexpr bool dilates =
    std::same_as<decltype(std::declval<const L&>().update(std::declval<Sym<T, D>&>(),
                                                          std::declval<const Increment<T, D>&>(),
                                                          std::declval<typename L::template History<T>&>())),
                 Inelastic<T>>;

/// Whether a law knows of its matter whether it has separated (`is_open`).
template <class L, class T = double>
inline constexpr bool knows_opening = requires(const L law, const typename L::template History<T> history) {
  law.is_open(history);
};

/// What `update` returned as both parts; a law that returns its opening alone does not dilate.
template <class T>
Inelastic<T> inelastic(const T& opening) {
  return {opening, T(0)};
}
template <class T>
Inelastic<T> inelastic(const Inelastic<T>& parts) {
  return parts;
}

/// What a law asks of the loops that call it.
struct LaneWishes {
  int widest = std::numeric_limits<int>::max();  ///< most points at once
  bool twins = false;                            ///< two packs side by side
};

/// The wishes of law L: its members `widest` and `twins`, where it has them. A law that wraps another repeats
/// the other's.
template <class L>
inline constexpr LaneWishes lane_wishes = [] {
  LaneWishes wishes;
  if constexpr (requires { L::widest; }) wishes.widest = L::widest;
  if constexpr (requires { L::twins; }) wishes.twins = L::twins;
  return wishes;
}();

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
