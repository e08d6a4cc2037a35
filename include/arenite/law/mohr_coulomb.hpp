// Mohr-Coulomb plasticity, perfectly plastic, with a constant dilatancy and a tension cut-off; implicit
// return in principal space to the plane, an edge or the apex, without a branch, so that a pack of points
// returns at once. Derivations: docs/return_mapping.md.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <limits>

#include <arenite/core/principal.hpp>
#include <arenite/law/frictional.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// SI and radians; checked by the constructor of `MohrCoulomb`.
struct MohrCoulombParameters {
  double density = detail::not_given;   ///< kg/m3; required, positive
  double young = detail::not_given;     ///< Young's modulus, Pa; required, positive
  double poisson = detail::not_given;   ///< Poisson's ratio, -; required, in (-1, 0.5)
  double friction = detail::not_given;  ///< angle of friction, rad; required, in [0, 1.55]; 0: Tresca
  double cohesion = 0;                  ///< Pa, >= 0; positive where friction is 0
  double dilatancy = 0;                 ///< angle of dilatancy, rad; in [0, friction]
  /// V / V0 beyond which the matter dilates no further, -, >= 1. A bound that keeps single points from
  /// growing without limit (up to 77 times at psi = 20 deg); the default lies beyond the loosest packing of
  /// sand.
  double greatest_volume_ratio = 1.5;
  /// Greatest principal stress, Pa, >= 0; infinite: that of the apex, cohesion / tan(friction).
  double tension = std::numeric_limits<double>::infinity();
};

namespace detail {

/// Yield surface of Mohr-Coulomb. With principal stresses s1 >= s2 >= s3, tension positive:
/// - yield: k s1 - s3 <= sc, k = (1 + sin phi)/(1 - sin phi), sc = 2 c cos(phi)/(1 - sin phi);
/// - potential: k' s1 - s3, where k' is the k of the dilatancy;
/// - cut-off: s1 <= tension, with flow along its normals (Rankine).
/// `Flow`: numbers of the dilatancy, double or N.
template <class N, class Flow>
class MohrCoulombSurface {
 public:
  MohrCoulombSurface(const MohrCoulombParameters& p, const Elasticity& elasticity,
                     const FrictionAngle<N>& angle, const Flow& sin_dilatancy)
      : tension_(p.tension), cohesion_(p.cohesion), three_bulk_(3 * elasticity.bulk()) {
    const Flow flow = (Flow(1) + sin_dilatancy) / (Flow(1) - sin_dilatancy);  // k'
    nu_ = elasticity.poisson();
    sin_ = angle.sin;
    cohesive_ = N(p.cohesion) * angle.cos;
    inscribed_ = N(1) + sin_ * sin_ * N(1.0 / 3);
    const N per_difference = reciprocal(N(N(1) - sin_));
    slope_ = (N(1) + sin_) * per_difference;
    strength_ = N(2) * cohesive_ * per_difference;
    apex_ = p.cohesion > 0 ? N(N(p.cohesion) / angle.tan) : N(0);
    dilates_ = sin_dilatancy > Flow(0);
    cuts_ = N(tension_) < apex_;
    corner_ = slope_ * N(tension_) - strength_;
    dilation_ = (flow - Flow(1)) * Flow(1 + nu_) / Flow(1 - 2 * nu_);
    const Flow shear2 = Flow(2 * elasticity.shear()), iso = Flow(elasticity.lame()) * (flow - Flow(1));
    const std::array<Flow, 3> r{iso + shear2 * flow, iso, iso - shear2};
    const N per_excess = reciprocal(N(slope_ * N(r[0]) - N(r[2])));
    for (std::size_t i = 0; i < 3; ++i) plane_[i] = N(r[i]) * per_excess;
    extension_ = Edge({N(1), N(1), slope_}, {Flow(1), Flow(1), flow}, {N(0), N(0), -strength_}, nu_);
    compression_ = Edge({N(1), slope_, slope_}, {Flow(1), flow, flow}, {N(0), -strength_, -strength_}, nu_);
  }

  /// Returns a trial stress [Pa] to the yield surface, in place; one within it stays bit for bit. The result
  /// is opening and dilation, volumetric strains. The opening is the volumetric plastic strain of a return to
  /// the apex, and that of the cut-off's flow.
  template <class T, int D>
  Inelastic<T> return_to_yield(Sym<T, D>& stress) const {
    const auto outside = outside_inscribed_cone(stress);
    if (!any_of(outside)) return {T(0), T(0)};
    return return_from(stress, outside);
  }

  /// As `return_to_yield`, only of the points in `outside`; the stresses of the others stay.
  template <class T, int D, class M>
  Inelastic<T> return_from(Sym<T, D>& stress, const M& outside) const {
    const Principal<T, D> trial(stress);
    const auto& s = trial.value;
    const T excess = T(slope_) * s[0] - s[2] - T(strength_);
    M returns = excess > T(0);
    if (any_of(cuts_)) returns = returns || where(M(s[0] > T(tension_)), cuts_);
    returns = returns && outside;
    if (!any_of(returns)) return {T(0), T(0)};

    std::array<T, 3> y = s;
    const T active = select(excess > T(0), excess, T(0));
    for (std::size_t i = 0; i < 3; ++i) y[i] = s[i] - active * T(plane_[i]);

    // The order is broken: on the edge s1 = s2 (extension) or s2 = s3 (compression). Both at once: beyond the
    // apex on both.
    const auto extends = y[0] < y[1];
    const auto on_edge = extends || y[1] < y[2];
    const T t = select(extends, extension_(s), compression_(s));
    const T low = T(slope_) * t - T(strength_);
    y = {select(on_edge, t, y[0]), select(on_edge, select(extends, t, low), y[1]),
         select(on_edge, low, y[2])};

    const auto at_apex = returns && on_edge && t > T(apex_);
    for (T& value : y) value = select(at_apex, T(apex_), value);
    T opening = select(at_apex, T(s[0] + s[1] + s[2] - T(3 * apex_)), T(0));  // times 3 K, Pa
    if (any_of(cuts_)) cut_off(s, where(returns, cuts_), y, opening);

    const Sym<T, D> back = trial.with(y);
    for (std::size_t i = 0; i < stress.size; ++i) stress[i] = select(returns, back[i], stress[i]);
    const T per_stress = T(1 / three_bulk_);
    if (!any_of(dilates_)) return {opening * per_stress, T(0)};
    const T plastic = s[0] + s[1] + s[2] - (y[0] + y[1] + y[2]);  // volumetric strain times 3 K, Pa
    return {opening * per_stress,
            select(where(returns, dilates_), T((plastic - opening) * per_stress), T(0))};
  }

  /// The greater of (s1 - s3)/2 + (s1 + s3)/2 sin(phi) - c cos(phi) and, with a cut-off, s1 - tension, over
  /// max(|s1|, |s3|) + c.
  template <class T, int D>
  T yield(const Sym<T, D>& stress) const {
    using std::abs, std::max;
    const auto s = Principal<T, D>(stress).value;
    T f = (s[0] - s[2]) * T(0.5) + (s[0] + s[2]) * T(N(0.5) * sin_) - T(cohesive_);
    if (any_of(cuts_)) f = select(where(s[0] - T(tension_) > f, cuts_), T(s[0] - T(tension_)), f);
    return f / max(T(max(abs(s[0]), abs(s[2])) + T(cohesion_)), T(smallest_divisor));
  }

 private:
  /// Return to an edge, base + t line with s1 = 0 at the base: the trial point s reaches it at
  /// s1 = weight . s + offset. The normal of both flows is the compliance times the potential's edge.
  struct Edge {
    std::array<N, 3> weight{};
    N offset{};

    Edge() = default;
    Edge(const std::array<N, 3>& line, const std::array<Flow, 3>& potential, const std::array<N, 3>& base,
         double nu) {
      const Flow sum = Flow(nu) * (potential[0] + potential[1] + potential[2]);
      std::array<Flow, 3> n{};
      N along(0);
      for (std::size_t i = 0; i < 3; ++i) {
        n[i] = Flow(1 + nu) * potential[i] - sum;
        along += N(n[i]) * line[i];
      }
      offset = N(0);
      const N per_along = reciprocal(along);
      for (std::size_t i = 0; i < 3; ++i) {
        weight[i] = N(n[i]) * per_along;
        offset -= weight[i] * base[i];
      }
    }
    template <class T>
    T operator()(const std::array<T, 3>& s) const {
      return s[0] * T(weight[0]) + s[1] * T(weight[1]) + s[2] * T(weight[2]) + T(offset);
    }
  };

  /// Whether a stress lies outside the cone inscribed in the pyramid (and outside that of the cut-off): a
  /// cheap test, for most points never leave it.
  template <class T, int D>
  auto outside_inscribed_cone(const Sym<T, D>& stress) const {
    const T p = trace(stress) * T(1.0 / 3);
    const Sym<T, D> dev = add_isotropic(stress, T(-p));
    const T j2 = contract(dev, dev) * T(0.5);
    const T shear_strength = T(cohesive_) - T(sin_) * p;
    auto inside = shear_strength >= T(0) && j2 * T(inscribed_) <= shear_strength * shear_strength;
    if (any_of(cuts_)) {
      const T below = T(tension_) - p;
      inside = inside && below >= T(0) && j2 * T(4.0 / 3) <= below * below;
    }
    return !inside;
  }

  /// Where a return y of the trial stresses s to the pyramid lies beyond the cut-off: returns s
  /// only to the cut-off or, where that lies outside the pyramid, to both. Sets y, and the opening: the
  /// volumetric strain of the cut-off's flow times 3 K, Pa.
  template <class T, class M>
  void cut_off(const std::array<T, 3>& s, const M& returns, std::array<T, 3>& y, T& opening) const {
    using std::max, std::min;
    const T limit = T(tension_);
    const auto beyond = returns && y[0] > limit;
    if (!any_of(beyond)) return;

    // Only the cut-off: its face, edge or corner, whose normals are the axes of s1, s2, s3.
    const T side = (s[0] - limit) * T(nu_ / (1 - nu_));
    const auto two = s[1] - side > limit;
    const T third = s[2] - (s[0] + s[1] - limit - limit) * T(nu_);
    const auto three = two && third > limit;
    std::array<T, 3> cut{limit, select(two, limit, T(s[1] - side)),
                         select(three, limit, select(two, third, T(s[2] - side)))};

    // Both: the line s1 = tension, s3 = corner_ between the edges of the pyramid, or one of its ends. Any
    // flow in the plane of s1 and s3 leads there, whatever the dilatancy.
    const T corner = T(corner_);
    const auto both = cut[2] < corner;
    const T middle = s[1] - ((s[0] - limit) + (s[2] - corner)) * T(nu_);
    cut[1] = select(both, T(min(max(middle, corner), limit)), cut[1]);
    cut[2] = select(both, corner, cut[2]);

    // Only shear shortens the axes of s2 and s3; it dilates by k' - 1 times the shortening.
    const std::array<T, 3> plastic{s[0] - cut[0], s[1] - cut[1], s[2] - cut[2]};
    const T sum = plastic[0] + plastic[1] + plastic[2];
    const T lateral = sum * T(nu_ / (1 + nu_));
    const T shortened = min(T(plastic[1] - lateral), T(0)) + min(T(plastic[2] - lateral), T(0));
    const T opened = max(T(sum + shortened * T(dilation_)), T(0));
    for (std::size_t i = 0; i < 3; ++i) y[i] = select(beyond, cut[i], y[i]);
    opening = select(beyond, opened, opening);
  }

  // In the order in which a return asks for them: another one was 10 % slower in packs of two and four.
  N slope_, strength_, apex_;     // k; sc, Pa; mean stress at the apex, Pa
  double tension_;                // Pa
  mask_of<N> cuts_;               // whether the cut-off lies below the apex
  N corner_;                      // s3 where the cut-off intersects the pyramid, Pa
  Flow dilation_;                 // (k' - 1) 3 K / (2 G)
  mask_of<Flow> dilates_;         // whether the angle of dilatancy is positive
  N sin_, cohesive_, inscribed_;  // sin(phi); c cos(phi), Pa; 1 + sin^2(phi)/3
  double cohesion_;               // Pa
  std::array<N, 3> plane_;  // change of the stresses on the way to the plane, per unit of yield function
  Edge extension_, compression_;  // s1 = s2; s2 = s3
  double three_bulk_, nu_;        // 3 K, Pa; Poisson's ratio
};

}  // namespace detail

/// Mohr-Coulomb law. Where planes, edges, apex and cut-off intersect, a trial stress returns to all of them
/// at once (Koiter's rule).
///
/// Opening: the volumetric plastic strain of a return to the apex, and that of the cut-off's flow. At the
/// apex grains have lost contact and nothing distinguishes dilatancy from separation; all of it counts as
/// opening, though psi > 0 would ascribe a part to shear. Dilation on planes and edges is a property of the
/// packing and swells the matter.
template <class Memory = ForgetsOpening, class Friction = ConstantFriction,
          class Stiffness = ConstantStiffness>
class MohrCoulomb
    : public Frictional<detail::MohrCoulombSurface, MohrCoulombParameters, Memory, Friction, Stiffness> {
 public:
  static constexpr bool two_packs_at_once = true;

  explicit MohrCoulomb(const MohrCoulombParameters& p, const Memory& memory = {},
                       const Friction& friction = {}, const Stiffness& stiffness = {})
      : MohrCoulomb::Frictional("MohrCoulomb", p, memory, friction, stiffness) {}
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
