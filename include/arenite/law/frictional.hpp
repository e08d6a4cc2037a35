// Frictional laws: what Mohr-Coulomb and Drucker-Prager share. Elastic trial stress, memory of a separation,
// return to the yield surface, and what opened and dilated.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include <arenite/core/cold.hpp>
#include <arenite/core/refusals.hpp>
#include <arenite/law/elasticity.hpp>
#include <arenite/law/fixed_point.hpp>
#include <arenite/law/frictional/friction.hpp>
#include <arenite/law/frictional/separation.hpp>
#include <arenite/law/frictional/stiffness.hpp>
#include <arenite/law/jaumann.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// Mean stress at the tip of the yield surface, c cot(phi), Pa; infinite without friction.
inline double apex(double friction, double cohesion) {
  return friction > 0 ? cohesion / std::tan(friction) : std::numeric_limits<double>::infinity();
}

/// Constants of strength that laws share.
struct Strength {
  double friction, cohesion, dilatancy, tension, greatest_volume_ratio;
};
/// Throws `error` unless the constants of strength make sense. A memory of separation is one number: it can
/// represent matter that opened on all sides, not a crack.
void check_strength(std::string_view law, const Strength& p, bool remembers);

/// History B of a policy joined to A, unless B is empty or A already contains it.
template <class T, class A, class B>
using WithHistory =
    std::conditional_t<std::is_same_v<B, NoHistory<T>> || std::is_base_of_v<B, A>, A, JoinedHistory<A, B>>;

/// Calls `call` with a policy; of one chosen at run time, with the chosen policy itself.
template <class Policy, class Call>
void visit_policy(const Policy& policy, const Call& call) {
  if constexpr (requires { policy.visit(call); })
    policy.visit(call);
  else
    call(policy);
}
/// Throws `error` unless the friction keeps the history that the stiffness reads: for policies chosen at
/// run time, which the compiler cannot refuse.
template <class Stiffness, class Friction>
void check_history(const Stiffness& stiffness, const Friction& friction) {
  visit_policy(stiffness, [&]<class S>(const S&) {
    if constexpr (requires { requires S::reads_friction_history; })
      visit_policy(friction, []<class F>(const F&) {
        if (!std::is_base_of_v<typename S::template History<double>, typename F::template History<double>>)
          throw error(ARENITE_SAYS_STIFFNESS_HISTORY);
      });
  });
}

/// The result of a comparison of Ts: `bool`, or a mask of a pack.
template <class T>
using mask_of = decltype(std::declval<T>() < std::declval<T>());

/// `mask` and `condition` by lane; `mask` itself where the condition is one of the whole law: a `bool` that
/// has been found true.
template <class M, class C>
M where(const M& mask, [[maybe_unused]] const C& condition) {
  if constexpr (std::is_same_v<C, bool>)
    return mask;
  else
    return mask && condition;
}

/// Mean stress p, Pa, and J2, Pa2, of a stress: they identify most points that lie within the yield
/// surface without a root or a division.
template <class T>
struct Invariants {
  T p, j2;

  template <int D>
  explicit Invariants(const Sym<T, D>& stress) : p(trace(stress) * T(1.0 / 3)) {
    const Sym<T, D> dev = add_isotropic(stress, T(-p));
    j2 = contract(dev, dev) * T(0.5);
  }

  /// Whether it lies within the cone inscribed in Mohr-Coulomb's pyramid of the slope tan(phi), which all
  /// cones of Drucker-Prager contain: J2 (1 + 4/3 tan^2 phi) <= (c - p tan phi)^2.
  auto within_cone(const T& slope, double cohesion) const {
    const T strength = T(cohesion) - slope * p;
    return strength >= T(0) && j2 * (T(1) + T(4.0 / 3) * slope * slope) <= strength * strength;
  }
  /// Whether it lies within the cone inscribed in that of the cut-off.
  auto within_cut(double tension) const {
    const T below = T(tension) - p;
    return below >= T(0) && j2 * T(4.0 / 3) <= below * below;
  }
};

}  // namespace detail

/// An elastic, perfectly plastic law with a yield surface for friction.
///
/// @tparam Surface   yield surface over numbers N of its friction and numbers of its dilatancy, made of
///                   parameters, elasticity, angle of friction and sine of the dilatancy, with
///                   `return_to_yield(stress)`, `return_from(stress, mask of points)` and `yield(stress)`
/// @tparam Memory    ForgetsOpening or RemembersOpening: what separated matter does when compressed again
/// @tparam Friction  ConstantFriction, or a policy by point (friction.hpp)
/// @tparam Stiffness ConstantStiffness, or a policy by point (stiffness.hpp)
template <template <class, class> class Surface, class Parameters, class Memory, class Friction,
          class Stiffness>
class Frictional : public Memory, public detail::ElasticPart<Stiffness> {
  using Elastic = detail::ElasticPart<Stiffness>;
  static constexpr bool constant = std::is_same_v<Friction, ConstantFriction>;
  static constexpr bool constant_stiffness = std::is_same_v<Stiffness, ConstantStiffness>;
  static constexpr bool bounded = requires(const Friction f, GivenAngles g) { f.least_slope(g); };
  static constexpr bool implicit = requires(const Friction f) { f.implicit(); };
  static constexpr bool sums_plastic_strain =
      std::is_base_of_v<PlasticStrainHistory<double>, typename Friction::template History<double>>;
  static constexpr bool has_dilatancy =
      requires(const Friction f, GivenAngles g, const typename Friction::template History<double> h) {
    f.dilatancy_slope(g, h);
  };

 public:
  using Elastic::elasticity;
  template <class T>
  using History = detail::WithHistory<
      T, detail::WithHistory<T, typename Memory::template History<T>, typename Friction::template History<T>>,
      typename Stiffness::template History<T>>;

  static_assert(
      !requires { requires Stiffness::reads_friction_history; } ||
          std::is_base_of_v<typename Stiffness::template History<double>,
                            typename Friction::template History<double>>,
      ARENITE_SAYS_STIFFNESS_HISTORY);

  Frictional(std::string_view name, const Parameters& p, const Memory& memory, const Friction& friction,
             const Stiffness& stiffness)
      : Memory(memory),
        Elastic(Elasticity(name, p.density, p.young, p.poisson), stiffness),
        surface_(p, elasticity(), detail::friction_angle(p.friction), std::sin(p.dilatancy)),
        greatest_volume_ratio_(p.greatest_volume_ratio),
        given_{p.friction, p.dilatancy, std::tan(p.friction), std::tan(p.dilatancy)},
        friction_(friction),
        parameters_(p) {
    detail::check_strength(name, {p.friction, p.cohesion, p.dilatancy, p.tension, p.greatest_volume_ratio},
                           memory.remembers());
    if constexpr (requires { friction.check(given_); }) friction.check(given_);
    if constexpr (requires { requires Stiffness::reads_friction_history; })
      detail::check_history(stiffness, friction);
    if constexpr (bounded) least_slope_ = friction.least_slope(given_);
    if constexpr (implicit)
      pressure_changes_ =
          friction.implicit() && (own_dilatancy() || p.dilatancy > 0 ||
                                  p.tension < detail::apex(std::atan(least_slope_), p.cohesion));
  }

  /// That of the parameters' angle of friction.
  const Surface<double, double>& surface() const { return surface_; }
  /// Whether stresses, moduli, cohesion and tension may be scaled together, and strains (`ByPoint`).
  bool scales() const {
    constexpr bool constant_by_point = requires { requires Friction::constant_by_point; };
    return constant_stiffness && (constant_by_point || detail::same_as_constant(friction_)) &&
           !Memory::remembers();
  }
  double greatest_volume_ratio() const { return greatest_volume_ratio_; }  ///< V / V0, -

  /// See law.hpp. With memory the returned opening is negative in a step that closes.
  template <class T, int D>
  Inelastic<T> update(Sym<T, D>& stress, const StrainStep<T, D>& step, History<T>& history) const {
    const auto& carried = Memory::carried(stress, step, history);
    Inelastic<T> parts;
    if constexpr (constant_stiffness) {
      stress = turned(stress, carried.spin) + elasticity().stress(carried.strain);
      parts = return_to_yield(stress, carried, history, T(1));
    } else {
      // f times the moduli: the same as f times the strain, and 1/f of the plastic strain.
      const T factor = Elastic::stiffness_factor(stress, history), compliance = reciprocal(factor);
      stress = turned(stress, carried.spin) + elasticity().stress(carried.strain * factor);
      parts = return_to_yield(stress, carried, history, compliance);
      parts = {parts.opening * compliance, parts.dilation * compliance};
    }
    Memory::open(parts.opening, history);
    if (Memory::remembers()) parts.opening = parts.opening + trace(step.strain) - trace(carried.strain);
    return parts;
  }

  /// How far a stress lies outside the yield surface (> 0) or within (< 0), -; 0 at no stress. With friction
  /// by point that of a step without strain and time.
  template <class T, int D>
  T yield(const Sym<T, D>& stress) const requires constant {
    return surface_.yield(stress);
  }
  template <class T, int D>
  T yield(const Sym<T, D>& stress, History<T> history) const requires(!constant) {
    if (detail::same_as_constant(friction_)) return surface_.yield(stress);
    const T slope = slope_of_point(stress, StrainStep<T, D>{}, history);
    return surface_of_point(slope, history).yield(stress);
  }

 private:
  /// `compliance`: over that of the parameters' moduli, -. A point's result never depends on the others of
  /// its pack: returns are selected by lane, and a test of the whole pack only skips what no lane would use.
  template <class T, int D>
  Inelastic<T> return_to_yield(Sym<T, D>& stress, [[maybe_unused]] const StrainStep<T, D>& step,
                               [[maybe_unused]] History<T>& history,
                               [[maybe_unused]] const T& compliance) const {
    if constexpr (constant) {
      return surface_.return_to_yield(stress);
    } else {
      if constexpr (requires { friction_.follow(step, history); }) friction_.follow(step, history);
      Sym<T, D> back;
      Inelastic<T> parts{T(0), T(0)};
      const bool returns = return_by_point(stress, step, history, back, parts);
      constexpr bool tells = requires { friction_.flow(compliance, history); };
      if constexpr (tells || sums_plastic_strain) {
        const auto flow = [&](const T& strain) {
          if constexpr (tells)
            friction_.flow(strain, history);
          else
            history.plastic_strain = history.plastic_strain + strain;
        };
        if (returns) {
          using std::sqrt;
          const Sym<T, D> plastic = deviator(stress - back);  // strain times 2 G of the point, Pa
          const T per_stress = T(std::sqrt(2.0 / 3) / (2 * elasticity().shear())) * compliance;
          flow(T(sqrt(contract(plastic, plastic)) * per_stress));
        } else {
          flow(T(0));
        }
      }
      if (returns) stress = back;
      return parts;
    }
  }

  /// Returns a trial stress to `back`, with its parts; false, without either, where all points stay.
  template <class T, int D>
  bool return_by_point(const Sym<T, D>& stress, const StrainStep<T, D>& step, History<T>& history,
                       Sym<T, D>& back, Inelastic<T>& parts) const {
    if (detail::same_as_constant(friction_)) {
      back = stress;
      parts = surface_.return_to_yield(back);
      return true;
    }
    const detail::Invariants<T> invariants(stress);
    const auto within_cut = invariants.within_cut(parameters_.tension);
    const auto within_cone = [&](const T& slope) {
      return invariants.within_cone(slope, parameters_.cohesion);
    };
    detail::mask_of<T> within(false);  // the cones of all slopes
    if constexpr (bounded) {
      // A stress within the cones of the least and of the greatest slope lies within all between them, as
      // sqrt(J2 (1 + 4/3 tan^2 phi)) + p tan(phi) is convex in tan(phi). Without cohesion the least is
      // enough; with it the flatter cone is the stronger one in tension, c / tan(phi).
      within = within_cone(T(least_slope_));
      if (parameters_.cohesion > 0) within = within && within_cone(T(greatest_slope_));
      if (all_of(within && within_cut)) return false;
    }
    const T slope = slope_of_point(stress, step, history);
    const auto outside = !((within || within_cone(slope)) && within_cut);
    if (!any_of(outside)) return false;
    if constexpr (!implicit) {
      back = stress;
      parts = surface_of_point(slope, history).return_from(back, outside);
    } else {
      detail::FixedPoint<T> end(slope, T(least_slope_), T(greatest_slope_));
      do {
        back = stress;
        parts = surface_of_point(end.at(), history).return_from(back, outside);
      } while (pressure_changes_ && end.goes_on(slope_of_point(back, step, history)));
    }
    return true;
  }

  /// tan(phi) of each point.
  template <class T, int D>
  T slope_of_point(const Sym<T, D>& stress, const StrainStep<T, D>& step, History<T>& history) const {
    using std::min;
    // Unless it is called once in each step, `slope` must not change the history.
    std::conditional_t<bounded || implicit, const History<T>, History<T>>& seen = history;
    const T greatest = T(greatest_slope_);
    if constexpr (requires { friction_.slope(given_, step, stress, seen); })
      return min(T(friction_.slope(given_, step, stress, seen)), greatest);
    else
      return min(T(friction_.slope(given_.slope, step, seen)), greatest);
  }

  /// Whether the policy gives the dilatancy, too.
  bool own_dilatancy() const {
    if constexpr (requires { friction_.own_dilatancy(); })
      return friction_.own_dilatancy();
    else
      return has_dilatancy;
  }

  /// The surface of each point.
  template <class T>
  auto surface_of_point(const T& slope, [[maybe_unused]] const History<T>& history) const {
    using std::min;
    const auto angle = detail::friction_of_slope(slope);
    if constexpr (has_dilatancy) {
      T sin_flow = T(sin_dilatancy_);
      if (own_dilatancy())
        sin_flow =
            detail::friction_of_slope(T(min(T(friction_.dilatancy_slope(given_, history)), slope))).sin;
      return Surface<T, T>(parameters_, elasticity(), angle, sin_flow);
    } else {
      return Surface<T, double>(parameters_, elasticity(), angle, sin_dilatancy_);
    }
  }

  Surface<double, double> surface_;  // of the parameters
  double greatest_volume_ratio_;     // -
  GivenAngles given_;
  double sin_dilatancy_ = std::sin(given_.dilatancy);
  double least_slope_ = 0, greatest_slope_ = std::tan(detail::greatest_friction);
  bool pressure_changes_ = false;  // in a return, and the friction follows it
  [[no_unique_address]] Friction friction_;
  [[no_unique_address]] std::conditional_t<constant, Nothing, Parameters> parameters_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void detail::check_strength(std::string_view law, const Strength& p, bool remembers) {
  check(p.friction >= 0 && p.friction <= greatest_friction, law, "friction", p.friction,
        "must lie in [0, 1.55] rad (88.8 deg)");
  check(p.cohesion >= 0 && std::isfinite(p.cohesion), law, "cohesion", p.cohesion,
        "must not be negative (Pa)");
  check(p.friction > 0 || p.cohesion > 0, law, "cohesion", p.cohesion,
        "must be positive where friction is 0: matter without both has no strength");
  check(p.dilatancy >= 0 && p.dilatancy <= p.friction, law, "dilatancy", p.dilatancy,
        "must lie in [0, friction]");
  check(p.tension >= 0, law, "tension", p.tension, "must not be negative (Pa)");
  check(p.greatest_volume_ratio >= 1, law, "greatest_volume_ratio", p.greatest_volume_ratio,
        "must be at least 1");
  check(!remembers || p.tension >= apex(p.friction, p.cohesion), law, "tension", p.tension,
        "a law that remembers its opening needs the cut-off at the apex (leave tension out)");
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
