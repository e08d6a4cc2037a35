// Drucker-Prager plasticity, perfectly plastic, with a constant dilatancy and a tension cut-off: a smooth
// cone in place of Mohr-Coulomb's pyramid, returned to in closed form. Where it touches the pyramid is a
// parameter. Derivations: docs/return_mapping.md.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>

#include <arenite/core/principal.hpp>
#include <arenite/law/frictional.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Where the cone agrees with the Mohr-Coulomb pyramid of the same friction and cohesion.
enum class Cone {
  compression,   ///< at the edges of triaxial compression: the circumscribed cone
  extension,     ///< at the edges of triaxial extension
  plane_strain,  ///< in plastic flow in plane strain, for the given dilatancy
};

/// SI and radians; checked by the constructor of `DruckerPrager`.
struct DruckerPragerParameters {
  double density = detail::not_given;   ///< kg/m3; required, positive
  double young = detail::not_given;     ///< Young's modulus, Pa; required, positive
  double poisson = detail::not_given;   ///< Poisson's ratio, -; required, in (-1, 0.5)
  double friction = detail::not_given;  ///< angle of friction, rad; required, in [0, 1.55]; 0: von Mises
  double cohesion = 0;                  ///< Pa, >= 0; positive where friction is 0
  double dilatancy = 0;                 ///< angle of dilatancy, rad; in [0, friction]
  /// V / V0 beyond which the matter dilates no further, -, >= 1. See `MohrCoulombParameters`.
  double greatest_volume_ratio = 1.5;
  /// Greatest mean stress, Pa, >= 0; infinite: that of the apex, cohesion / tan(friction).
  double tension = std::numeric_limits<double>::infinity();
  Cone cone = Cone::compression;  ///< which Mohr-Coulomb strength it reproduces
};

namespace detail {

/// Yield surface of Drucker-Prager. With mean stress p, tension positive, and q = sqrt(J2):
/// - yield: q + eta p <= kappa;
/// - potential: q + eta' p;
/// - cut-off: p <= tension, with purely volumetric flow.
/// `Flow`: numbers of the dilatancy, double or N.
template <class N, class Flow>
class DruckerPragerSurface {
 public:
  DruckerPragerSurface(const DruckerPragerParameters& p, const Elasticity& elasticity,
                       const FrictionAngle<N>& angle, const Flow& sin_dilatancy)
      : bulk_(elasticity.bulk()), cohesion_(p.cohesion) {
    using std::min, std::sqrt;
    const double root = std::sqrt(3.0);
    N per_sin;  // eta / sin(phi)
    if (p.cone == Cone::plane_strain) {
      flow_ = sin_dilatancy / sqrt(Flow(Flow(1) + sin_dilatancy * sin_dilatancy / Flow(3)));
      per_sin =
          reciprocal(N(N(sqrt(Flow(Flow(1) - flow_ * flow_ / Flow(3)))) + N(flow_ / Flow(3)) * angle.sin));
    } else {
      const double sign = p.cone == Cone::compression ? -1 : 1;
      flow_ = Flow(6) * sin_dilatancy / (Flow(root) * (Flow(3) + Flow(sign) * sin_dilatancy));
      per_sin = N(6 / root) * reciprocal(N(N(3) + N(sign) * angle.sin));
    }
    dilates_ = sin_dilatancy > Flow(0);
    slope_ = per_sin * angle.sin;
    strength_ = per_sin * N(p.cohesion) * angle.cos;
    const N apex = p.cohesion > 0 ? N(N(p.cohesion) / angle.tan) : N(0);
    limit_ = min(N(p.tension), apex);
    cuts_ = limit_ < apex;
    q_at_limit_ = strength_ - slope_ * limit_;
    cut_dilation_ = Flow(bulk_) * flow_ / Flow(elasticity.shear());
    const N rate = reciprocal(N(N(elasticity.shear()) + N(Flow(bulk_) * flow_) * slope_));
    p_change_ = rate * N(bulk_) * N(flow_);
    q_kept_ = p_change_ * slope_;
  }

  const N& slope() const { return slope_; }         ///< eta, -
  const Flow& flow_slope() const { return flow_; }  ///< eta', -
  const N& strength() const { return strength_; }   ///< kappa, Pa

  /// Returns a trial stress [Pa] to the yield surface, in place; one within it stays bit for bit. The result
  /// is opening and dilation, volumetric strains. The opening is the volumetric plastic strain of a return to
  /// the apex, and that of the cut-off's flow.
  template <class T, int D>
  Inelastic<T> return_to_yield(Sym<T, D>& stress) const {
    return return_from(stress, mask_of<T>(true));
  }

  /// As `return_to_yield`, only of the points in `outside`; the stresses of the others stay.
  template <class T, int D, class M>
  Inelastic<T> return_from(Sym<T, D>& stress, const M& outside) const {
    using std::max, std::min;
    const T p = trace(stress) * T(1.0 / 3);
    const Sym<T, D> dev = add_isotropic(stress, T(-p));
    const T j2 = contract(dev, dev) * T(0.5);
    const T shear_strength = T(strength_) - T(slope_) * p;
    const M returns =
        outside && !(shear_strength >= T(0) && j2 <= shear_strength * shear_strength && p <= T(limit_));
    if (!any_of(returns)) return {T(0), T(0)};

    const T inverse = reciprocal_root(max(j2, T(smallest_square<T>)));
    const T q = j2 * inverse;
    const T excess = max(T(q - shear_strength), T(0));
    // As a sum without a difference: where shear_strength is positive q is not negative, whatever the
    // round-off, and the apex, which may be infinite, stays out of it.
    const T q_cone = min(q, shear_strength) + excess * T(q_kept_);
    const T p_cone = p - excess * T(p_change_);
    // Beyond the cut-off, or the tip: only to the cut-off, or to its intersection with the cone.
    const auto beyond = q_cone < T(0) || p_cone > T(limit_);
    const M beyond_cut = any_of(cuts_) ? where(M(beyond), cuts_) : M(false);
    const T q_beyond = select(beyond_cut, T(min(q, T(q_at_limit_))), T(0));
    const T p_back = select(beyond, T(limit_), p_cone);
    const T scale = select(beyond, q_beyond, q_cone) * inverse;
    for (std::size_t i = 0; i < stress.size; ++i) {
      const T back = i < 3 ? scale * dev[i] + p_back : scale * dev[i];
      stress[i] = select(returns, back, stress[i]);
    }
    T opening = p - T(limit_);  // times K, Pa
    if (any_of(cuts_)) {
      const T sheared = max(T(q - T(q_at_limit_)), T(0));
      opening = select(beyond_cut, T(max(T(opening - sheared * T(cut_dilation_)), T(0))), opening);
    }
    const T per_stress = T(1 / bulk_);
    opening = select(returns && beyond, T(opening * per_stress), T(0));
    if (!any_of(dilates_)) return {opening, T(0)};
    return {opening, select(where(returns, dilates_), T((p - p_back) * per_stress - opening), T(0))};
  }

  /// The greater of q + eta p - kappa and p - tension, over q + |p| + c.
  template <class T, int D>
  T yield(const Sym<T, D>& stress) const {
    using std::abs, std::max, std::sqrt;
    const T p = trace(stress) * T(1.0 / 3);
    const Sym<T, D> dev = add_isotropic(stress, T(-p));
    const T q = sqrt(contract(dev, dev) * T(0.5));
    const T f = max(T(q + T(slope_) * p - T(strength_)), T(p - T(limit_)));
    return f / max(T(q + abs(p) + T(cohesion_)), T(smallest_divisor));
  }

 private:
  double bulk_, cohesion_;  // Pa
  Flow flow_;               // eta', -
  mask_of<Flow> dilates_;   // whether the angle of dilatancy is positive
  N slope_, strength_;      // eta, -; kappa, Pa
  N p_change_, q_kept_;     // of p to the cone, and what q keeps, per unit of yield function, -
  N limit_;                 // the lower of apex and cut-off, Pa
  mask_of<N> cuts_;         // whether the cut-off lies below the apex
  N q_at_limit_;            // q where the cut-off intersects the cone, Pa
  Flow cut_dilation_;       // K eta' / G, -
};

}  // namespace detail

/// Drucker-Prager law. A trial stress returns to cone and cut-off at once (Koiter's rule).
///
/// Opening: as in mohr_coulomb.hpp.
template <class Memory = ForgetsOpening, class Friction = ConstantFriction,
          class Stiffness = ConstantStiffness>
class DruckerPrager
    : public Frictional<detail::DruckerPragerSurface, DruckerPragerParameters, Memory, Friction, Stiffness> {
 public:
  explicit DruckerPrager(const DruckerPragerParameters& p, const Memory& memory = {},
                         const Friction& friction = {}, const Stiffness& stiffness = {})
      : DruckerPrager::Frictional("DruckerPrager", p, memory, friction, stiffness) {}
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
