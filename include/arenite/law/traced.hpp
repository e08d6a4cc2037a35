// Traced: any law, with the deviatoric strain of its points recorded beside it. A scene that does not ask for
// it stores no such columns.
#pragma once

#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include <arenite/law/jaumann.hpp>
#include <arenite/law/law.hpp>

namespace arenite {

/// Adds the strain deviator e and, as the last history variable, `deviatoric_strain` = sqrt(2/3 e : e), -. e
/// is the sum of the increments' deviators, turned with the matter as a Jaumann stress is: oscillations
/// cancel, where a sum of lengths would pile them up (the far sand of a penetrometer's drop then shows 0.15
/// instead of 0.002).
template <class Law>
class Traced {
 public:
  template <class T>
  struct History {
    typename Law::template History<T> law{};
    std::array<T, 6> e{};  ///< as in Sym; the last two stay zero in the plane
    T deviatoric_strain{};
    constexpr auto members() {
      return std::tuple_cat(law.members(), std::tie(e[0], e[1], e[2], e[3], e[4], e[5], deviatoric_strain));
    }
    constexpr auto members() const {
      return std::tuple_cat(law.members(), std::tie(e[0], e[1], e[2], e[3], e[4], e[5], deviatoric_strain));
    }
  };

  explicit Traced(Law law) : law_{std::move(law)} {}

  const Law& law() const { return law_; }
  double density() const { return law_.density(); }
  double wave_modulus() const { return law_.wave_modulus(); }

  template <class T, int D>
  T update(Sym<T, D>& stress, const Increment<T, D>& increment, History<T>& history) const {
    using std::sqrt;
    Sym<T, D> e;
    for (std::size_t k = 0; k < e.size; ++k) e[k] = history.e[k];
    e = turned(e, increment.spin) + deviator(increment.strain);
    for (std::size_t k = 0; k < e.size; ++k) history.e[k] = e[k];
    history.deviatoric_strain = sqrt(T(2.0 / 3) * contract(e, e));
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
