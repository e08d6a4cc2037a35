// The concept of a constitutive law: mathematics over a scalar, which may be a pack. Storage and loops live
// elsewhere.
#pragma once

#include <concepts>
#include <tuple>

#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// History of a law that has none: it stores no columns.
template <class T>
struct NoHistory {
  constexpr auto members() { return std::tie(); }
  constexpr auto members() const { return std::tie(); }
};

/// A constitutive law for points in D dimensions over scalar T.
///
/// - `History<T>`: a struct of scalars with `members()` giving a tie of them; `NoHistory<T>` if none.
/// - `density()`: mass of the unstressed unit volume, kg/m3.
/// - `wave_modulus()`: density times the square of the fastest wave's speed, Pa; it gives the stable step.
/// - `update(stress, increment, history)`: Cauchy stress [Pa, tension positive] taken through one step, in
///   place. Returns the change of the volumetric strain [-] that the matter *opened* without stress
///   (separated grains): positive where it opens, negative where a law with memory closes what had opened,
///   else T(0). The point's volume does not change by it, V <- V exp(tr(strain) - returned), so that nothing
///   is swollen when it is compressed again. An increment of zero is allowed: it takes an inadmissible
///   initial stress back.
/// - `elastic_energy(stress)`: recoverable energy, J/m3.
/// - optional `static constexpr int widest`: widest pack that a loop may call it with; 1 for a law with `if`s
/// on its
///   scalars. Without it laws are called with a register's worth of points at once: write branches as
///   `select`.
template <class L, class T = double, int D = 3>
concept constitutive_law = requires(const L law, Sym<T, D> stress, const Increment<T, D> increment,
                                    typename L::template History<T> history) {
  { law.density() } -> std::convertible_to<double>;
  { law.wave_modulus() } -> std::convertible_to<double>;
  { law.update(stress, increment, history) } -> std::convertible_to<T>;
  { law.elastic_energy(stress) } -> std::convertible_to<T>;
  history.members();
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
