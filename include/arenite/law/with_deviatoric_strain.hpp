// Any law, with the deviatoric strain of its points recorded beside it. A scene that does not ask for it
// stores no such columns.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include <arenite/law/jaumann.hpp>
#include <arenite/law/law.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The strain deviator of a point: in the plane three components, in space five.
template <class T, int D>
struct DeviatoricStrain {
  std::array<T, D == 2 ? 3 : 5> e{};  ///< xx, yy, xy (, yz, zx); zz is minus the sum of the first two
  constexpr auto members() { return tied(e); }
  constexpr auto members() const { return tied(e); }

  /// As a tensor.
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
};

/// Adds the strain deviator e to the history of a law: the sum of the steps' deviators, turned with the
/// matter as a Jaumann stress is. Oscillations cancel. A sum of magnitudes would add
/// them up (the far sand of a penetrometer's drop then shows 0.15 instead of 0.002). `D`: dimension of the
/// scenes that it is made for; a plane one stores three components instead of five.
template <class Law, int D = 3>
class WithDeviatoricStrain : public Law {
 public:
  template <class T>
  using History = JoinedHistory<typename Law::template History<T>, DeviatoricStrain<T, D>>;

  explicit WithDeviatoricStrain(Law law) : Law{std::move(law)} {}

  const Law& law() const { return *this; }

  template <class T, int Plane>
  auto update(Sym<T, Plane>& stress, const StrainStep<T, Plane>& step, History<T>& history) const {
    static_assert(Plane <= D,
                  "WithDeviatoricStrain: made for plane scenes; in space leave its second argument out");
    history.take(turned(history.template tensor<Plane>(), step.spin) + deviator(step.strain));
    return Law::update(stress, step, static_cast<typename Law::template History<T>&>(history));
  }

  /// sqrt(2/3 e : e), -.
  template <class T>
  static T deviatoric_strain(const History<T>& history) {
    using std::sqrt;
    const auto e = history.template tensor<D>();
    return sqrt(T(2.0 / 3) * contract(e, e));
  }
};

/// Whether L records the deviatoric strain.
template <class L>
inline constexpr bool has_deviatoric_strain = false;
template <class L, int D>
inline constexpr bool has_deviatoric_strain<WithDeviatoricStrain<L, D>> = true;

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
