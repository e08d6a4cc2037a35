// Stiffness of a frictional law as a policy: the moduli of its parameters, or moduli that grow with the mean
// pressure.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <arenite/law/elasticity.hpp>
#include <arenite/law/law.hpp>
#include <arenite/simd/elementary.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The moduli of the law's parameters, everywhere and always.
///
/// Another policy has a `History<T>` and
///
///   template <class T, int D>
///   T factor(const Sym<T, D>& stress, const History<T>& history) const;
///   template <class T, int D>
///   T energy(const Elasticity& elasticity, const Sym<T, D>& stress, const History<T>& history) const;
///
/// by how much all moduli of a point, in its stress at the start of the step, exceed those of the law's
/// parameters, -, positive; and the elastic energy of the unit volume, J/m3. Poisson's ratio is that of the
/// parameters. A history that the friction policy has too is one and the same, kept up by that policy; with
/// `static constexpr bool reads_friction_history = true` the compiler refuses another friction policy.
struct ConstantStiffness {
  template <class T>
  using History = NoHistory<T>;

  template <class T, int D>
  T factor(const Sym<T, D>&, const NoHistory<T>&) const {
    return T(1);
  }
  template <class T, int D>
  T energy(const Elasticity& elasticity, const Sym<T, D>& stress, const NoHistory<T>&) const {
    return elasticity.energy(stress);
  }
};

/// E = E_ref (p / p_ref)^n of the mean pressure p at the start of the step, E_ref of the law's parameters;
/// not below that of `lowest_pressure`. Ohde (1939) and Janbu (1963), as in the hardening soil model (Schanz,
/// Vermeer & Bonnier 1999).
///
/// The stress is integrated, not derived from a potential (hypoelastic): what a closed cycle returns depends
/// on its path. Isotropic cycles return all. Sheared by tau under the pressure p_2 and back under p_1, the
/// matter takes tau^2 / (2 G_ref) (1/f_2 - 1/f_1) with f = (p / p_ref)^n: it gives energy where the pressure
/// was higher on the way out. From 100 to 50 kPa with n = 0.5 that is 41 % of the energy of the shear.
class PressureStiffness {
 public:
  template <class T>
  using History = NoHistory<T>;

  struct Parameters {
    double exponent = 0.5;              ///< n, -, in [0, 1]; 0: the moduli of the law's parameters
    double reference_pressure = 100e3;  ///< p_ref, Pa, positive
    double lowest_pressure = 1e3;       ///< below it the moduli are those at it, Pa, positive
  };

  PressureStiffness() : PressureStiffness(Parameters{}) {}
  explicit PressureStiffness(const Parameters& p)
      : exponent_(p.exponent),
        per_reference_(1 / p.reference_pressure),
        lowest_(p.lowest_pressure / p.reference_pressure) {
    detail::check(p.exponent >= 0 && p.exponent <= 1, "PressureStiffness", "exponent", p.exponent,
                  "must lie in [0, 1]");
    detail::check(p.reference_pressure > 0 && std::isfinite(p.reference_pressure), "PressureStiffness",
                  "reference_pressure", p.reference_pressure, "must be positive (Pa)");
    detail::check(p.lowest_pressure > 0 && std::isfinite(p.lowest_pressure), "PressureStiffness",
                  "lowest_pressure", p.lowest_pressure, "must be positive (Pa)");
  }

  template <class T, int D>
  T factor(const Sym<T, D>& stress, const NoHistory<T>&) const {
    using std::max;
    return power(max(T(trace(stress) * T(-per_reference_ / 3)), T(lowest_)));
  }

  /// J2 / (2 G) + integral of p dp / K from 0, J/m3.
  template <class T, int D>
  T energy(const Elasticity& elasticity, const Sym<T, D>& stress, const NoHistory<T>& history) const {
    using std::max;
    const Sym<T, D> dev = deviator(stress);
    const T shear = contract(dev, dev) * T(0.25 / elasticity.shear()) / factor(stress, history);
    // By p in units of p_ref: up to the lowest, or of tension, quadratic; beyond it a power.
    const T p = trace(stress) * T(-per_reference_ / 3), high = max(p, T(lowest_));
    const T low = select(p > T(lowest_), T(lowest_), p);
    const double at_lowest = std::pow(lowest_, 2 - exponent_) / (2 - exponent_);
    const T beyond = high * high / power(high) * T(1 / (2 - exponent_)) - T(at_lowest);
    const T below = low * low * T(0.5 / std::pow(lowest_, exponent_));
    return shear + (below + max(beyond, T(0))) * T(1 / (elasticity.bulk() * per_reference_ * per_reference_));
  }

 private:
  /// x^n
  template <class T>
  T power(const T& x) const {
    using std::abs, std::sqrt;
    if (exponent_ == 0.5) return sqrt(x);
    const T log = lane_log(x) * T(exponent_), inverse = lane_exp_minus(T(abs(log)));
    return select(log > T(0), T(T(1) / inverse), inverse);
  }

  double exponent_, per_reference_, lowest_;  // -; 1/Pa; of p_ref, -
};

namespace detail {

/// Density, moduli and energy of a law with a policy of stiffness: the members that a law has of them.
template <class Stiffness>
class ElasticPart {
 public:
  ElasticPart(const Elasticity& elasticity, const Stiffness& stiffness)
      : elasticity_(elasticity), stiffness_(stiffness) {}

  double density() const { return elasticity_.density(); }      ///< kg/m3
  const Elasticity& elasticity() const { return elasticity_; }  ///< of the parameters
  /// Of the parameters' moduli, and in a given state, Pa.
  double wave_modulus() const { return elasticity_.wave_modulus(); }
  template <class T, int D, class History>
  T wave_modulus(const Sym<T, D>& stress, const History& history) const {
    return T(elasticity_.wave_modulus()) * stiffness_factor(stress, history);
  }
  template <class T, int D, class History>
  T elastic_energy(const Sym<T, D>& stress, const History& history) const {
    return stiffness_.energy(elasticity_, stress, kept<T>(history));
  }

 protected:
  template <class T, int D, class History>
  T stiffness_factor(const Sym<T, D>& stress, const History& history) const {
    return stiffness_.factor(stress, kept<T>(history));
  }

 private:
  /// The stiffness's part of the law's history.
  template <class T, class History>
  static decltype(auto) kept([[maybe_unused]] const History& history) {
    using Kept = typename Stiffness::template History<T>;
    if constexpr (std::is_same_v<Kept, NoHistory<T>>)
      return Kept{};
    else
      return static_cast<const Kept&>(history);
  }

  Elasticity elasticity_;
  Stiffness stiffness_;
};

template <>
class ElasticPart<ConstantStiffness> {
 public:
  ElasticPart(const Elasticity& elasticity, const ConstantStiffness&) : elasticity_(elasticity) {}

  double density() const { return elasticity_.density(); }  ///< kg/m3
  const Elasticity& elasticity() const { return elasticity_; }
  double wave_modulus() const { return elasticity_.wave_modulus(); }  ///< Pa
  template <class T, int D>
  T elastic_energy(const Sym<T, D>& stress) const {
    return elasticity_.energy(stress);
  }

 private:
  Elasticity elasticity_;
};

}  // namespace detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
