// Drucker-Prager plasticity, perfectly plastic, with a constant dilatancy and a tension cut-off: a smooth
// cone in place of Mohr-Coulomb's pyramid, returned to in closed form. Where it touches the pyramid is a
// parameter.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <arenite/core/principal.hpp>
#include <arenite/law/jaumann.hpp>
#include <arenite/law/law.hpp>
#include <arenite/law/separation.hpp>
#include <arenite/law/strength.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Where the cone meets the Mohr-Coulomb pyramid of the same friction and cohesion.
enum class Cone {
  compression,   ///< at the edges of triaxial compression: the circumscribed cone
  extension,     ///< at the edges of triaxial extension
  plane_strain,  ///< in plastic flow in plane strain, for the given dilatancy
};

struct DruckerPragerParameters {
  double density = detail::not_given;   ///< kg/m3; required, positive
  double young = detail::not_given;     ///< Young's modulus, Pa; required, positive
  double poisson = detail::not_given;   ///< Poisson's ratio, -; required, in (-1, 0.5)
  double friction = detail::not_given;  ///< angle of friction, rad; required, in [0, 1.55]; 0: von Mises
  double cohesion = 0;                  ///< Pa; >= 0, positive where friction is 0
  double dilatancy = 0;                 ///< angle of dilatancy, rad; in [0, friction]
  /// V / V0 beyond which the matter dilates no further, -, >= 1. A bound that keeps single points from
  /// growing without limit (up to 77 times at psi = 20 deg); the default lies beyond the loosest packing of
  /// sand.
  double greatest_volume_ratio = 1.5;
  /// Greatest mean stress, Pa, >= 0. Acts below the apex, cohesion / tan(friction); default: the apex.
  double tension = std::numeric_limits<double>::infinity();
  Cone cone = Cone::compression;  ///< which Mohr-Coulomb strength it reproduces
};

/// Drucker-Prager law. With mean stress p, tension positive, and q = sqrt(J2):
/// - yield: q + eta p <= kappa;
/// - potential: q + eta' p;
/// - cut-off: p <= tension, with purely volumetric flow.
/// A trial stress returns to all of them at once (Koiter's rule).
///
/// Cones, after de Souza Neto, Peric & Owen (2008), Computational Methods for Plasticity, section 6.4.4:
/// - compression: eta = 6 sin(phi)/(sqrt(3) (3 - sin phi)), kappa = 6 c cos(phi)/(sqrt(3) (3 - sin phi)), and
///   eta' is eta with psi for phi; extension: the same with 3 + sin;
/// - plane strain: no plastic strain out of the plane puts s_zz at p - 2/3 eta' q. Mohr's circle in the plane
///   then has radius q sqrt(1 - eta'^2/3) and centre p + eta' q/3, so that eta = sin(phi)/m and
///   kappa = c cos(phi)/m with m = sqrt(1 - eta'^2/3) + eta' sin(phi)/3. The angle of dilatancy in it is
///   psi for eta' = sin(psi)/sqrt(1 + sin^2(psi)/3). With psi = phi it is the book's cone.
///
/// What opened: the volumetric plastic strain of a return to the apex, and that of the cut-off (as in
/// mohr_coulomb.hpp).
///
/// @tparam Memory  ForgetsOpening or RemembersOpening: what separated matter does when compressed again.
template <class Memory = ForgetsOpening>
class DruckerPrager {
 public:
  template <class T>
  using History = typename Memory::template History<T>;

  explicit DruckerPrager(const DruckerPragerParameters& p, const Memory& memory = Memory{})
      : elasticity_("DruckerPrager", p.density, p.young, p.poisson), memory_(memory) {
    detail::check_strength("DruckerPrager", p.friction, p.cohesion, p.dilatancy, p.tension,
                           p.greatest_volume_ratio);
    apex_ = detail::apex(p.friction, p.cohesion);
    detail::check_memory("DruckerPrager", Memory::remembers, p.tension, apex_);
    const double sin = std::sin(p.friction), sin_flow = std::sin(p.dilatancy);
    double per_sin = 0;  // eta / sin(phi)
    if (p.cone == Cone::plane_strain) {
      flow_ = sin_flow / std::sqrt(1 + sin_flow * sin_flow / 3);
      per_sin = 1 / (std::sqrt(1 - flow_ * flow_ / 3) + flow_ * sin / 3);
    } else {
      const double sign = p.cone == Cone::compression ? -1 : 1;
      flow_ = 6 * sin_flow / (std::sqrt(3.0) * (3 + sign * sin_flow));
      per_sin = 6 / (std::sqrt(3.0) * (3 + sign * sin));
    }
    slope_ = per_sin * sin;
    strength_ = per_sin * p.cohesion * std::cos(p.friction);
    limit_ = std::min(p.tension, apex_);
    cuts_ = limit_ < apex_;
    rim_ = strength_ - slope_ * limit_;
    cut_dilation_ = elasticity_.bulk() * flow_ / elasticity_.shear();
    cohesion_ = p.cohesion;
    greatest_volume_ratio_ = p.greatest_volume_ratio;
    const double rate = 1 / (elasticity_.shear() + elasticity_.bulk() * slope_ * flow_);
    fall_ = rate * elasticity_.bulk() * flow_;
    kept_ = fall_ * slope_;
  }

  double density() const { return elasticity_.density(); }            ///< kg/m3
  double wave_modulus() const { return elasticity_.wave_modulus(); }  ///< Pa
  const Elasticity& elasticity() const { return elasticity_; }
  const Memory& memory() const { return memory_; }
  double greatest_volume_ratio() const { return greatest_volume_ratio_; }  ///< V / V0, -
  template <class T>
  requires Memory::remembers auto is_open(const History<T>& history) const {
    return memory_.is_open(history);
  }
  double slope() const { return slope_; }        ///< eta, -
  double flow_slope() const { return flow_; }    ///< eta', -
  double strength() const { return strength_; }  ///< kappa, Pa

  /// See law.hpp. With memory the returned opening is negative in a step that closes.
  template <class T, int D>
  Inelastic<T> update(Sym<T, D>& stress, const Increment<T, D>& increment, History<T>& history) const {
    const auto& felt = memory_.carried(stress, increment, history);
    stress = turned(stress, felt.spin) + elasticity_.stress(felt.strain);
    Inelastic<T> parts = return_to_yield(stress);
    memory_.open(parts.opening, history);
    if constexpr (Memory::remembers)
      parts.opening = parts.opening + trace(increment.strain) - trace(felt.strain);
    return parts;
  }

  /// Takes a trial stress [Pa] back to the yield surface, in place; one within it stays bit for bit. Returns
  /// what opened and what dilated, -.
  template <class T, int D>
  Inelastic<T> return_to_yield(Sym<T, D>& stress) const {
    using std::max, std::min;
    const T p = trace(stress) * T(1.0 / 3);
    const Sym<T, D> dev = add_isotropic(stress, T(-p));
    const T j2 = contract(dev, dev) * T(0.5);
    const T room = T(strength_) - T(slope_) * p;
    const auto returns = !(room >= T(0) && j2 <= room * room && p <= T(limit_));
    if (!any_of(returns)) return {T(0), T(0)};

    const T inverse = reciprocal_root(max(j2, T(detail::smallest_square<T>)));
    const T q = j2 * inverse;
    const T excess = max(T(q - room), T(0));
    // As a sum without a difference: where there is room q is not negative, whatever the round-off, and the
    // apex, which may be infinite, stays out of it.
    const T q_cone = min(q, room) + excess * T(kept_);
    const T p_cone = p - excess * T(fall_);
    // Beyond the cut-off, or the tip: to the cut-off alone, or to the circle where it meets the cone.
    const auto beyond = q_cone < T(0) || p_cone > T(limit_);
    const T q_beyond = cuts_ ? T(min(q, T(rim_))) : T(0);
    const T p_back = select(beyond, T(limit_), p_cone);
    const T scale = select(beyond, q_beyond, q_cone) * inverse;
    for (std::size_t i = 0; i < stress.size; ++i) {
      const T back = i < 3 ? scale * dev[i] + p_back : scale * dev[i];
      stress[i] = select(returns, back, stress[i]);
    }
    T relief = p - T(limit_);
    if (cuts_) relief = max(T(relief - max(T(q - T(rim_)), T(0)) * T(cut_dilation_)), T(0));
    const T per_stress = T(1 / elasticity_.bulk());
    const T opening = select(returns && beyond, T(relief * per_stress), T(0));
    if (flow_ == 0) return {opening, T(0)};
    return {opening, select(returns, T((p - p_back) * per_stress - opening), T(0))};
  }

  template <class T, int D>
  T elastic_energy(const Sym<T, D>& stress) const {
    return elasticity_.energy(stress);
  }

  /// How far a stress lies outside the yield surface (> 0) or within (< 0), -: the greater of q + eta p -
  /// kappa and p - tension, over q + |p| + c. 0 at no stress.
  template <class T, int D>
  T yield(const Sym<T, D>& stress) const {
    using std::abs, std::max, std::sqrt;
    const T p = trace(stress) * T(1.0 / 3);
    const Sym<T, D> dev = add_isotropic(stress, T(-p));
    const T q = sqrt(contract(dev, dev) * T(0.5));
    const T f = max(T(q + T(slope_) * p - T(strength_)), T(p - T(limit_)));
    return f / max(T(q + abs(p) + T(cohesion_)), T(detail::smallest_divisor));
  }

 private:
  Elasticity elasticity_;
  [[no_unique_address]] Memory memory_;
  double slope_, flow_, strength_;  // eta, eta', -; kappa, Pa
  double fall_, kept_;              // of p to the cone, and what q keeps, per unit of yield function, -
  double apex_, limit_;             // mean stress at the tip; the lower of it and the cut-off, Pa
  bool cuts_;                       // whether the cut-off lies below the apex
  double rim_, cut_dilation_;       // q where the cut-off meets the cone, Pa; K eta' / G, -
  double cohesion_;                 // Pa
  double greatest_volume_ratio_;    // -
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
