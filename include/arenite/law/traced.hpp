// Traced: any law, with the deviatoric strain that its points have been through recorded beside it. A scene
// that does not ask for it stores no such column.
#pragma once

#include <cmath>
#include <tuple>
#include <utility>

#include <arenite/law/law.hpp>

namespace arenite {

/// Adds the history variable `deviatoric_strain`, -: the sum over all increments of sqrt(2/3 e : e), e the
/// deviator of the strain increment. It never falls; in a monotonic path it is the usual equivalent
/// deviatoric strain.
template <class Law>
class Traced {
 public:
  template <class T>
  struct History {
    typename Law::template History<T> law{};
    T deviatoric_strain{};
    constexpr auto members() { return std::tuple_cat(law.members(), std::tie(deviatoric_strain)); }
    constexpr auto members() const { return std::tuple_cat(law.members(), std::tie(deviatoric_strain)); }
  };

  explicit Traced(Law law) : law_{std::move(law)} {}

  const Law& law() const { return law_; }
  double density() const { return law_.density(); }
  double wave_modulus() const { return law_.wave_modulus(); }

  template <class T, int D>
  T update(Sym<T, D>& stress, const Increment<T, D>& increment, History<T>& history) const {
    using std::sqrt;
    const Sym<T, D> e = deviator(increment.strain);
    history.deviatoric_strain = history.deviatoric_strain + sqrt(T(2.0 / 3) * contract(e, e));
    return law_.update(stress, increment, history.law);
  }

  template <class T, int D>
  T elastic_energy(const Sym<T, D>& stress) const {
    return law_.elastic_energy(stress);
  }

 private:
  Law law_;
};

template <class L>
inline constexpr bool is_traced = false;
template <class L>
inline constexpr bool is_traced<Traced<L>> = true;

}  // namespace arenite
