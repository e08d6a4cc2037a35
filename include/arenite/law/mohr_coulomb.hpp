// Mohr-Coulomb plasticity, perfectly plastic, with a constant dilatancy and a tension cut-off; implicit
// return in principal space to the plane, an edge or the apex, without a branch, so that a pack of points
// returns at once.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <arenite/core/principal.hpp>
#include <arenite/law/jaumann.hpp>
#include <arenite/law/law.hpp>
#include <arenite/law/separation.hpp>
#include <arenite/law/strength.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

struct MohrCoulombParameters {
  double density = detail::not_given;   ///< kg/m3; required, positive
  double young = detail::not_given;     ///< Young's modulus, Pa; required, positive
  double poisson = detail::not_given;   ///< Poisson's ratio, -; required, in (-1, 0.5)
  double friction = detail::not_given;  ///< angle of friction, rad; required, in [0, 1.55]; 0: Tresca
  double cohesion = 0;                  ///< Pa; >= 0, positive where friction is 0
  double dilatancy = 0;                 ///< angle of dilatancy, rad; in [0, friction]
  /// V / V0 beyond which the matter dilates no further, -, >= 1. A bound that keeps single points from
  /// growing without limit (up to 77 times at psi = 20 deg); the default lies beyond the loosest packing of
  /// sand.
  double greatest_volume_ratio = 1.5;
  /// Greatest principal stress, Pa, >= 0. Acts below the apex, cohesion / tan(friction); default: the apex.
  double tension = std::numeric_limits<double>::infinity();
};

/// Mohr-Coulomb law. With principal stresses s1 >= s2 >= s3, tension positive:
/// - yield: k s1 - s3 <= sc, k = (1 + sin phi)/(1 - sin phi), sc = 2 c cos(phi)/(1 - sin phi);
/// - potential: k' s1 - s3, where k' is the k of the dilatancy;
/// - cut-off: s1 <= tension, with flow along its normals (Rankine).
///
/// The return follows Clausen, Damkilde & Andersen (2007), Computers & Structures 85, 1795-1807: the trial
/// point goes back to the plane; where that breaks the order of the stresses, to the edge that they cross;
/// where that lies beyond the apex, to the apex. Where that lies beyond the cut-off, the trial point goes
/// back to the cut-off alone, or to the lines and corners where it meets the pyramid: all surfaces at once
/// (Koiter's rule); with associated flow that is the closest point in the energy norm.
///
/// What opened: the volumetric plastic strain of a return to the apex, and that of the cut-off's flow. At the
/// apex grains have lost contact and nothing tells dilatancy from separation; all of it counts as opening,
/// though psi > 0 would ascribe a part to shear. Dilation on planes and edges is a property of the packing
/// and swells the matter.
///
/// @tparam Memory  ForgetsOpening or RemembersOpening: what separated matter does when compressed again.
template <class Memory = ForgetsOpening>
class MohrCoulomb {
 public:
  static constexpr bool twins = true;

  template <class T>
  using History = typename Memory::template History<T>;

  explicit MohrCoulomb(const MohrCoulombParameters& p, const Memory& memory = Memory{})
      : elasticity_("MohrCoulomb", p.density, p.young, p.poisson), memory_(memory) {
    detail::check_strength("MohrCoulomb", p.friction, p.cohesion, p.dilatancy, p.tension,
                           p.greatest_volume_ratio);
    const double sin = std::sin(p.friction);
    apex_ = detail::apex(p.friction, p.cohesion);
    detail::check_memory("MohrCoulomb", Memory::remembers, p.tension, apex_);
    cuts_ = p.tension < apex_;
    tension_ = p.tension;
    dilates_ = p.dilatancy > 0;
    greatest_volume_ratio_ = p.greatest_volume_ratio;
    cohesion_ = p.cohesion;
    sin_ = sin;
    cohesive_ = p.cohesion * std::cos(p.friction);
    inscribed_ = 1 + sin * sin / 3;
    slope_ = (1 + sin) / (1 - sin);
    strength_ = 2 * cohesive_ / (1 - sin);

    const double flow = (1 + std::sin(p.dilatancy)) / (1 - std::sin(p.dilatancy));
    corner_ = slope_ * tension_ - strength_;
    dilation_ = (flow - 1) * (1 + p.poisson) / (1 - 2 * p.poisson);
    const double lame = elasticity_.lame(), shear2 = 2 * elasticity_.shear();
    const double iso = lame * (flow - 1);
    const std::array<double, 3> r{iso + shear2 * flow, iso, iso - shear2};
    const double fall = slope_ * r[0] - r[2];
    for (std::size_t i = 0; i < 3; ++i) plane_[i] = r[i] / fall;
    extension_ = edge({1, 1, slope_}, {1, 1, flow}, {0, 0, -strength_});
    compression_ = edge({1, slope_, slope_}, {1, flow, flow}, {0, -strength_, -strength_});
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
    if (!any_of(outside_inscribed_cone(stress))) return {T(0), T(0)};

    const Principal<T, D> trial(stress);
    const auto& s = trial.value;
    const T excess = T(slope_) * s[0] - s[2] - T(strength_);
    auto returns = excess > T(0);
    if (cuts_) returns = returns || s[0] > T(tension_);
    if (!any_of(returns)) return {T(0), T(0)};

    std::array<T, 3> y = s;
    const T fall = select(excess > T(0), excess, T(0));
    for (std::size_t i = 0; i < 3; ++i) y[i] = s[i] - fall * T(plane_[i]);

    // The order is broken: on the edge s1 = s2 (extension) or s2 = s3 (compression). Both at once: beyond the
    // apex on both.
    const auto extends = y[0] < y[1];
    const auto on_edge = extends || y[1] < y[2];
    const T t = select(extends, extension_(s), compression_(s));
    const T low = T(slope_) * t - T(strength_);
    y = {select(on_edge, t, y[0]), select(on_edge, select(extends, t, low), y[1]),
         select(on_edge, low, y[2])};

    const auto at_apex = on_edge && t > T(apex_);
    for (T& value : y) value = select(at_apex, T(apex_), value);
    T relief = select(at_apex, T(s[0] + s[1] + s[2] - T(3 * apex_)), T(0));
    if (cuts_) cut_off(s, y, relief);

    const Sym<T, D> back = trial.with(y);
    for (std::size_t i = 0; i < stress.size; ++i) stress[i] = select(returns, back[i], stress[i]);
    const T per_stress = T(1 / (3 * elasticity_.bulk()));
    if (!dilates_) return {relief * per_stress, T(0)};
    const T fallen = s[0] + s[1] + s[2] - (y[0] + y[1] + y[2]);
    return {relief * per_stress, select(returns, T((fallen - relief) * per_stress), T(0))};
  }

  template <class T, int D>
  T elastic_energy(const Sym<T, D>& stress) const {
    return elasticity_.energy(stress);
  }

  /// How far a stress lies outside the yield surface (> 0) or within (< 0), -: the greater of (s1 - s3)/2 +
  /// (s1 + s3)/2 sin(phi) - c cos(phi) and, with a cut-off, s1 - tension, over max(|s1|, |s3|) + c. 0 at no
  /// stress.
  template <class T, int D>
  T yield(const Sym<T, D>& stress) const {
    using std::abs, std::max;
    const auto s = Principal<T, D>(stress).value;
    T f = (s[0] - s[2]) * T(0.5) + (s[0] + s[2]) * T(0.5 * sin_) - T(cohesive_);
    if (cuts_) f = max(f, T(s[0] - T(tension_)));
    return f / max(T(max(abs(s[0]), abs(s[2])) + T(cohesion_)), T(detail::smallest_divisor));
  }

 private:
  /// Return to an edge: the trial point s meets it where s1 = weight . s + offset.
  struct Edge {
    std::array<double, 3> weight{};
    double offset = 0;
    template <class T>
    T operator()(const std::array<T, 3>& s) const {
      return s[0] * T(weight[0]) + s[1] * T(weight[1]) + s[2] * T(weight[2]) + T(offset);
    }
  };

  /// The edge base + t l, where base has s1 = 0. The normal of both flows there is the compliance times the
  /// edge l' of the potential, which spares the cross product. With nu < 1/2 its product with l is positive.
  Edge edge(const std::array<double, 3>& l, const std::array<double, 3>& potential,
            const std::array<double, 3>& base) const {
    const double nu = elasticity_.poisson();
    const double sum = nu * (potential[0] + potential[1] + potential[2]);
    std::array<double, 3> n{};
    double along = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      n[i] = (1 + nu) * potential[i] - sum;
      along += n[i] * l[i];
    }
    Edge e;
    for (std::size_t i = 0; i < 3; ++i) {
      e.weight[i] = n[i] / along;
      e.offset -= e.weight[i] * base[i];
    }
    return e;
  }

  /// Whether a stress lies outside the cone inscribed in the pyramid (and outside that of the cut-off): a
  /// cheap test, for most points never leave it.
  template <class T, int D>
  auto outside_inscribed_cone(const Sym<T, D>& stress) const {
    const T p = trace(stress) * T(1.0 / 3);
    const Sym<T, D> dev = add_isotropic(stress, T(-p));
    const T j2 = contract(dev, dev) * T(0.5);
    const T room = T(cohesive_) - T(sin_) * p;
    auto inside = room >= T(0) && j2 * T(inscribed_) <= room * room;
    if (cuts_) {
      const T left = T(tension_) - p;
      inside = inside && left >= T(0) && j2 * T(4.0 / 3) <= left * left;
    }
    return !inside;
  }

  /// Where the return y of the trial stresses s to the pyramid lies beyond the cut-off: takes s back to the
  /// cut-off alone or, where that lies outside the pyramid, to both. Sets y, and the relief: the volumetric
  /// strain of the cut-off's flow times 3 K, Pa.
  template <class T>
  void cut_off(const std::array<T, 3>& s, std::array<T, 3>& y, T& relief) const {
    using std::max, std::min;
    const T limit = T(tension_);
    const double nu = elasticity_.poisson();
    const auto beyond = y[0] > limit;
    if (!any_of(beyond)) return;

    // The cut-off alone: its face, edge or corner, whose normals are the axes of s1, s2, s3.
    const T side = (s[0] - limit) * T(nu / (1 - nu));
    const auto two = s[1] - side > limit;
    const T third = s[2] - (s[0] + s[1] - limit - limit) * T(nu);
    const auto three = two && third > limit;
    std::array<T, 3> cut{limit, select(two, limit, T(s[1] - side)),
                         select(three, limit, select(two, third, T(s[2] - side)))};

    // Both: the line s1 = tension, s3 = corner_ between the edges of the pyramid, or one of its ends. Any
    // flow in the plane of s1 and s3 leads there, whatever the dilatancy.
    const T corner = T(corner_);
    const auto both = cut[2] < corner;
    const T middle = s[1] - ((s[0] - limit) + (s[2] - corner)) * T(nu);
    cut[1] = select(both, T(min(max(middle, corner), limit)), cut[1]);
    cut[2] = select(both, corner, cut[2]);

    // Shear alone shortens the axes of s2 and s3, k' - 1 times less than it dilates.
    const std::array<T, 3> fall{s[0] - cut[0], s[1] - cut[1], s[2] - cut[2]};
    const T sum = fall[0] + fall[1] + fall[2];
    const T lateral = sum * T(nu / (1 + nu));
    const T shortened = min(T(fall[1] - lateral), T(0)) + min(T(fall[2] - lateral), T(0));
    const T opened = max(T(sum + shortened * T(dilation_)), T(0));
    for (std::size_t i = 0; i < 3; ++i) y[i] = select(beyond, cut[i], y[i]);
    relief = select(beyond, opened, relief);
  }

  Elasticity elasticity_;
  [[no_unique_address]] Memory memory_;
  double slope_, strength_;        // k; sc, Pa
  double apex_, tension_;          // Pa
  bool cuts_;                      // whether the cut-off lies below the apex
  double corner_, dilation_;       // s3 where it meets the pyramid, Pa; (k' - 1) 3 K / (2 G)
  bool dilates_;                   // whether the angle of dilatancy is positive
  double greatest_volume_ratio_;   // -
  double sin_, cohesive_;          // sin(phi); c cos(phi), Pa
  double inscribed_, cohesion_;    // 1 + sin^2(phi)/3; Pa
  std::array<double, 3> plane_{};  // fall of the stresses on the way to the plane, per unit of yield function
  Edge extension_, compression_;   // s1 = s2; s2 = s3
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
