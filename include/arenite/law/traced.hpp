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

/// Adds the strain deviator e to the history: the sum of the increments' deviators, turned with the matter as
/// a Jaumann stress is. Oscillations cancel, where a sum of lengths would pile them up (the far sand of a
/// penetrometer's drop then shows 0.15 instead of 0.002). `D`: dimension of the scenes that it is made for; a
/// plane one stores three components instead of five.
template <class Law, int D = 3>
class Traced {
 public:
  static constexpr bool twins = requires { Law::twins; };

  template <class T>
  struct History {
    typename Law::template History<T> law{};
    std::array<T, D == 2 ? 3 : 5> e{};  ///< xx, yy, xy (, yz, zx); zz is minus the sum of the first two
    constexpr auto members() { return joined(*this); }
    constexpr auto members() const { return joined(*this); }

    /// e as a tensor.
    template <int Plane>
    Sym<T, Plane> tensor() const {
      Sym<T, Plane> s{{e[0], e[1], T(-(e[0] + e[1])), e[2]}};
      if constexpr (Plane == 3 && D == 3) {
        s[4] = e[3];
        s[5] = e[4];
      }
      return s;
    }
    template <int Plane>
    void take(const Sym<T, Plane>& s) {
      e[0] = s[0];
      e[1] = s[1];
      e[2] = s[3];
      if constexpr (Plane == 3 && D == 3) {
        e[3] = s[4];
        e[4] = s[5];
      }
    }

   private:
    template <class Self>
    static constexpr auto joined(Self& self) {
      return std::tuple_cat(self.law.members(),
                            std::apply([](auto&... v) { return std::tie(v...); }, self.e));
    }
  };

  explicit Traced(Law law) : law_{std::move(law)} {}

  const Law& law() const { return law_; }
  double density() const { return law_.density(); }
  double wave_modulus() const { return law_.wave_modulus(); }

  template <class T, int Plane>
  T update(Sym<T, Plane>& stress, const Increment<T, Plane>& increment, History<T>& history) const {
    static_assert(Plane <= D, "Traced: made for plane scenes; in space leave its second argument out");
    history.take(turned(history.template tensor<Plane>(), increment.spin) + deviator(increment.strain));
    return law_.update(stress, increment, history.law);
  }

  /// sqrt(2/3 e : e), -.
  template <class T>
  static T deviatoric_strain(const History<T>& history) {
    using std::sqrt;
    const auto e = history.template tensor<D>();
    return sqrt(T(2.0 / 3) * contract(e, e));
  }

  template <class T, int Plane>
  T elastic_energy(const Sym<T, Plane>& stress) const {
    return law_.elastic_energy(stress);
  }

  /// That of the law, if it has one.
  template <class T, int Plane>
  T yield(const Sym<T, Plane>& stress) const requires requires(const Law law) {
    law.yield(stress);
  }
  { return law_.yield(stress); }

 private:
  Law law_;
};

template <class L>
inline constexpr bool is_traced = false;
template <class L, int D>
inline constexpr bool is_traced<Traced<L, D>> = true;

}  // namespace arenite
