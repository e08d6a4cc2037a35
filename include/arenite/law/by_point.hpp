// A law whose stiffness, strength and friction vary by point: factors in the history, which the law does not
// change and a fill gives (`FillOptions::history`).
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <string_view>
#include <tuple>
#include <utility>

#include <arenite/core/error.hpp>
#include <arenite/law/frictional/friction.hpp>
#include <arenite/law/law.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Friction by point: tan(phi) is that of the law's parameters times the point's `friction`; the dilatancy is
/// at most as large. A policy of Mohr-Coulomb and Drucker-Prager.
struct PointFriction {
  template <class T>
  struct History {
    T friction{1};  ///< factor of tan(phi), -, not negative
    static constexpr std::array<std::string_view, 1> names{"friction"};
    constexpr auto members() { return std::tie(friction); }
    constexpr auto members() const { return std::tie(friction); }
  };

  template <class T, int D>
  T slope(double given, const StrainStep<T, D>&, const History<T>& history) const {
    return T(given) * history.friction;
  }
  template <class T>
  T dilatancy_slope(const GivenAngles& given, const History<T>&) const {
    return T(given.dilatancy_slope);
  }
  /// Whether the slope is a constant of the point: no rate, no pressure, no past.
  static constexpr bool constant_by_point = true;
};

/// Factors of a point's constants; those of the law's parameters where they are 1.
template <class T>
struct PointFactors {
  T stiffness{1};  ///< of Young's modulus, -, positive
  T strength{1};   ///< of cohesion and tension, -, positive
  static constexpr std::array<std::string_view, 2> names{"stiffness", "strength"};
  constexpr auto members() { return std::tie(stiffness, strength); }
  constexpr auto members() const { return std::tie(stiffness, strength); }
};

namespace detail {

/// A law beneath its `ByPoint`, with a yield surface by point if it has one.
template <class Law, bool knows = knows_yield<Law>>
struct YieldByPoint : Law {
  explicit YieldByPoint(Law law) : Law(std::move(law)) {}
};
template <class Law>
struct YieldByPoint<Law, true> : Law {
  explicit YieldByPoint(Law law) : Law(std::move(law)) {}

  template <class T, int D, class History>
  T yield(const Sym<T, D>& stress, const History& history) const {
    return yield_of(static_cast<const Law&>(*this), stress * (T(1) / history.strength),
                    static_cast<const typename Law::template History<T>&>(history));
  }
};

}  // namespace detail

/// A law with Young's modulus and strength by point: `ByPoint<LinearElastic>`; with friction too
/// `ByPoint<MohrCoulomb<ForgetsOpening, PointFriction>>`. The law is called with the stress over the strength
/// and with the strain times stiffness over strength, which is exact for a law that is elastic and perfectly
/// plastic: one that says so by `bool scales() const`, or is linear.
template <class Law>
class ByPoint : public detail::YieldByPoint<Law> {
 public:
  template <class T>
  using History = JoinedHistory<typename Law::template History<T>, PointFactors<T>>;

  /// Throws `error` for a law that rates, pressures or a past change.
  explicit ByPoint(Law law) : detail::YieldByPoint<Law>(std::move(law)) {
    if constexpr (!is_linear<Law>)
      require(
          this->scales(), "ByPoint.law", "given",
          "must be elastic and perfectly plastic: with constant friction and stiffness, without a memory of "
          "opening");
  }
  static constexpr bool linear = is_linear<Law>;

  const Law& law() const { return *this; }
  /// Throws `error` for a factor that no point can have. 0 passes: a host's functions give it before they are
  /// called; a point that keeps it ends a run as not finite.
  static void check_history(std::string_view name, double value) {
    require(value >= 0, {"FillOptions.history, ", name}, value, "must not be negative (a factor)");
  }

  using Law::wave_modulus;
  template <class T, int D>
  T wave_modulus(const Sym<T, D>&, const History<T>& history) const {
    return T(Law::wave_modulus()) * history.stiffness;
  }

  template <class T, int D>
  auto update(Sym<T, D>& stress, const StrainStep<T, D>& step, History<T>& history) const {
    const T ratio = history.stiffness / history.strength;
    const StrainStep<T, D> scaled{step.strain * ratio, step.spin, step.dt};
    stress = stress * (T(1) / history.strength);
    const auto parts = inelastic(Law::update(stress, scaled, static_cast<Inner<T>&>(history)));
    stress = stress * history.strength;
    if constexpr (dilates<Law>)
      return Inelastic<T>{parts.opening / ratio, parts.dilation / ratio};
    else
      return T(parts.opening / ratio);
  }

  template <class T, int D>
  T elastic_energy(const Sym<T, D>& stress, const History<T>& history) const {
    return elastic_energy_of(law(), stress, static_cast<const Inner<T>&>(history)) / history.stiffness;
  }

 private:
  template <class T>
  using Inner = typename Law::template History<T>;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
