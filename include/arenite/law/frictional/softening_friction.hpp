// Friction and dilatancy that soften with plastic shear: from peak to residual values.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <string_view>

#include <arenite/law/elasticity.hpp>
#include <arenite/law/frictional/friction.hpp>
#include <arenite/simd/elementary.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Residual angles, and how fast the peak ones fall to them.
struct SofteningParameters {
  double residual_friction = detail::not_given;  ///< rad; required, in (0, 1.55], at most the law's friction
  double residual_dilatancy = 0;     ///< rad, in [0, residual_friction]; 0: ends at constant volume
  double decay = detail::not_given;  ///< eta, per unit of plastic strain, -; required, >= 0
  double cell_size = 0;              ///< size of the cells, m, >= 0; 0: `decay` as it is
  double reference_size = 0;  ///< size of the cells, or thickness of the band, that has `decay`, m, >= 0
};

namespace detail {

/// Common part of policies with softening: checked constants, and the share of the peak that is left.
class Softening {
 public:
  Softening(std::string_view policy, const SofteningParameters& p) : policy_(policy), parameters_(p) {
    check(p.residual_friction > 0 && p.residual_friction <= greatest_friction, policy, "residual_friction",
          p.residual_friction, "must lie in (0, 1.55] rad (88.8 deg)");
    check(p.residual_dilatancy >= 0 && p.residual_dilatancy <= p.residual_friction, policy,
          "residual_dilatancy", p.residual_dilatancy, "must lie in [0, residual_friction]");
    check(p.decay >= 0 && std::isfinite(p.decay), policy, "decay", p.decay, "must not be negative");
    check(p.cell_size >= 0 && std::isfinite(p.cell_size), policy, "cell_size", p.cell_size,
          "must not be negative (m)");
    check((p.cell_size > 0) == (p.reference_size > 0) && p.reference_size >= 0, policy, "reference_size",
          p.reference_size, "must be positive (m) where cell_size is, and 0 where it is not");
    decay_ = p.cell_size > 0 ? p.decay * p.cell_size / p.reference_size : p.decay;
  }

  /// With the cells' size, -.
  double decay() const { return decay_; }

  void check_given(const GivenAngles& given) const {
    check(parameters_.residual_friction <= given.friction, policy_, "residual_friction",
          parameters_.residual_friction, "must not exceed the law's friction");
    check(parameters_.residual_dilatancy <= given.dilatancy, policy_, "residual_dilatancy",
          parameters_.residual_dilatancy, "must not exceed the law's dilatancy");
  }

  /// tan(phi) when all is softened.
  double least_slope() const { return std::tan(parameters_.residual_friction); }

  /// exp(-eta eps_p)
  template <class T>
  T left(const PlasticStrainHistory<T>& history) const {
    return lane_exp_minus(T(history.plastic_strain * T(decay_)));
  }
  /// Tangents of the angles between residual and `peak`, rad.
  template <class T>
  T slope(const T& peak, const T& left) const {
    return slope_between(parameters_.residual_friction, peak, left);
  }
  template <class T>
  T dilatancy_slope(const T& peak, const T& left) const {
    return slope_between(parameters_.residual_dilatancy, peak, left);
  }

 private:
  template <class T>
  static T slope_between(double residual, const T& peak, const T& left) {
    using std::min;
    return lane_tan(T(min(T(T(residual) + (peak - T(residual)) * left), T(greatest_friction))));
  }

  std::string_view policy_;
  SofteningParameters parameters_;
  double decay_;
};

}  // namespace detail

/// phi = phi_r + (phi_p - phi_r) exp(-eta eps_p), and the dilatancy psi alike, with peak values phi_p and
/// psi_p of the law's parameters. eps_p is the sum of the steps' deviatoric plastic strains sqrt(2/3 e:e); a
/// step has the angles of what was sheared before it. With psi_r = 0 the matter ends at its critical state,
/// at constant volume; all it dilates is finite.
///
/// Softening localises in bands of one cell's width, so that the energy that a band dissipates would fall
/// with the cells. Regularised, eta = decay * cell_size / reference_size: a band of a cell's width h softens
/// over a shear of 1/eta, a displacement h/eta that then does not depend on h (crack band; Bazant & Oh 1983,
/// Materiaux et Constructions 16, 155-177). This is valid where softening localises, and where cells are of
/// one size; it is not meant for cells that are far larger than what is sheared at once.
class SofteningFriction {
 public:
  using Parameters = SofteningParameters;
  template <class T>
  using History = PlasticStrainHistory<T>;

  explicit SofteningFriction(const Parameters& p) : softening_("SofteningFriction", p) {}

  bool constant() const { return softening_.decay() == 0; }
  void check(const GivenAngles& given) const { softening_.check_given(given); }
  double least_slope(const GivenAngles&) const { return softening_.least_slope(); }

  template <class T, int D>
  T slope(const GivenAngles& given, const StrainStep<T, D>&, const Sym<T, D>&,
          const History<T>& history) const {
    return softening_.slope(T(given.friction), softening_.left(history));
  }
  template <class T>
  T dilatancy_slope(const GivenAngles& given, const History<T>& history) const {
    return softening_.dilatancy_slope(T(given.dilatancy), softening_.left(history));
  }

 private:
  detail::Softening softening_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
