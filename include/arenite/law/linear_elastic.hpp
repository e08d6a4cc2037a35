// Linear elasticity with the Jaumann rate: small elastic strains, any rotation.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/law/elasticity.hpp>
#include <arenite/law/jaumann.hpp>
#include <arenite/law/law.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// SI; checked by the constructor of `LinearElastic`.
struct LinearElasticParameters {
  double density = detail::not_given;  ///< kg/m3; required, positive
  double young = detail::not_given;    ///< Young's modulus, Pa; required, positive
  double poisson = detail::not_given;  ///< Poisson's ratio, -; required, in (-1, 0.5)
};

/// Hypoelastic law: the Jaumann rate of the Cauchy stress is Hooke's law of the strain rate. For small
/// elastic strains; in large shear the stress oscillates (tau = G sin(gamma)), as is known of this rate.
class LinearElastic {
 public:
  static constexpr bool linear = true;
  template <class T>
  using History = NoHistory<T>;

  /// Throws `error` that names the parameter and its rule.
  explicit LinearElastic(const LinearElasticParameters& p)
      : elasticity_("LinearElastic", p.density, p.young, p.poisson) {}

  double density() const { return elasticity_.density(); }            ///< kg/m3
  double wave_modulus() const { return elasticity_.wave_modulus(); }  ///< Pa
  const Elasticity& elasticity() const { return elasticity_; }

  /// See law.hpp. Matter never separates: returns 0.
  template <class T, int D>
  T update(Sym<T, D>& stress, const StrainStep<T, D>& step, NoHistory<T>&) const {
    stress = turned(stress, step.spin) + elasticity_.stress(step.strain);
    return T(0);
  }

  template <class T, int D>
  T elastic_energy(const Sym<T, D>& stress) const {
    return elasticity_.energy(stress);
  }

 private:
  Elasticity elasticity_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
