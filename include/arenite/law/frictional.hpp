// Frictional laws: what Mohr-Coulomb and Drucker-Prager share. Elastic trial stress, memory of a separation,
// return to the yield surface, and what opened and dilated.
#pragma once

#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>

#include <arenite/law/elasticity.hpp>
#include <arenite/law/friction.hpp>
#include <arenite/law/jaumann.hpp>
#include <arenite/law/separation.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// Greatest angle of friction, rad: 88.8 deg. The round-off of a return grows with 1 / (pi/2 - friction); in
/// float it is here 3e-5 of the trial stress.
inline constexpr double greatest_friction = 1.55;

/// Mean stress at the tip of the yield surface, c cot(phi), Pa; infinite without friction.
inline double apex(double friction, double cohesion) {
  return friction > 0 ? cohesion / std::tan(friction) : std::numeric_limits<double>::infinity();
}

/// Throws `error` unless the constants of strength make sense. A memory of separation is one number: it can
/// stand for matter that opened on all sides, not for a crack.
template <class Parameters>
void check_strength(std::string_view law, const Parameters& p, bool remembers) {
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

/// Whether a stress may lie outside the yield surface, by point: outside the cone inscribed in Mohr-Coulomb's
/// pyramid, which all cones of Drucker-Prager contain, or that of the cut-off. Needs no root and no division:
/// J2 (1 + 4/3 tan^2 phi) <= (c - p tan phi)^2.
template <class T, int D>
auto may_yield(const Sym<T, D>& stress, const T& slope, double cohesion, double tension) {
  const T p = trace(stress) * T(1.0 / 3);
  const Sym<T, D> dev = add_isotropic(stress, T(-p));
  const T j2 = contract(dev, dev) * T(0.5);
  const T strength = T(cohesion) - slope * p, below = T(tension) - p;
  return !(strength >= T(0) && j2 * (T(1) + T(4.0 / 3) * slope * slope) <= strength * strength &&
           below >= T(0) && j2 * T(4.0 / 3) <= below * below);
}

}  // namespace detail

/// An elastic, perfectly plastic law with a yield surface for friction.
///
/// @tparam Surface   yield surface over numbers N, made of parameters, elasticity and angle of friction, with
///                   `return_to_yield(stress)` and `yield(stress)`
/// @tparam Memory    ForgetsOpening or RemembersOpening: what separated matter does when compressed again
/// @tparam Friction  ConstantFriction, or a policy by point (friction.hpp)
template <template <class> class Surface, class Parameters, class Memory, class Friction>
class Frictional : public Memory {
  static constexpr bool constant = std::is_same_v<Friction, ConstantFriction>;

 public:
  template <class T>
  using History = std::conditional_t<
      constant ||
          std::is_same_v<typename Memory::template History<T>, typename Friction::template History<T>>,
      typename Memory::template History<T>,
      JoinedHistory<typename Memory::template History<T>, typename Friction::template History<T>>>;

  Frictional(std::string_view name, const Parameters& p, const Memory& memory, const Friction& friction)
      : Memory(memory),
        elasticity_(name, p.density, p.young, p.poisson),
        surface_(p, elasticity_, detail::friction_angle(p.friction)),
        greatest_volume_ratio_(p.greatest_volume_ratio),
        given_slope_(std::tan(p.friction)),
        friction_(friction),
        parameters_(p) {
    detail::check_strength(name, p, Memory::remembers);
  }

  double density() const { return elasticity_.density(); }            ///< kg/m3
  double wave_modulus() const { return elasticity_.wave_modulus(); }  ///< Pa
  const Elasticity& elasticity() const { return elasticity_; }
  /// That of the parameters' angle of friction.
  const Surface<double>& surface() const { return surface_; }
  double greatest_volume_ratio() const { return greatest_volume_ratio_; }  ///< V / V0, -

  /// See law.hpp. With memory the returned opening is negative in a step that closes.
  template <class T, int D>
  Inelastic<T> update(Sym<T, D>& stress, const StrainStep<T, D>& step, History<T>& history) const {
    const auto& carried = Memory::carried(stress, step, history);
    stress = turned(stress, carried.spin) + elasticity_.stress(carried.strain);
    Inelastic<T> parts = return_to_yield(stress, carried, history);
    Memory::open(parts.opening, history);
    if constexpr (Memory::remembers)
      parts.opening = parts.opening + trace(step.strain) - trace(carried.strain);
    return parts;
  }

  template <class T, int D>
  T elastic_energy(const Sym<T, D>& stress) const {
    return elasticity_.energy(stress);
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
    return surface_of(slope_of_point(StrainStep<T, D>{}, history)).yield(stress);
  }

 private:
  template <class T, int D>
  Inelastic<T> return_to_yield(Sym<T, D>& stress, [[maybe_unused]] const StrainStep<T, D>& step,
                               [[maybe_unused]] History<T>& history) const {
    if constexpr (constant) {
      return surface_.return_to_yield(stress);
    } else {
      const T slope = slope_of_point(step, history);
      if (detail::same_as_constant(friction_)) return surface_.return_to_yield(stress);
      if (!any_of(detail::may_yield(stress, slope, parameters_.cohesion, parameters_.tension)))
        return {T(0), T(0)};
      return surface_of(slope).return_to_yield(stress);
    }
  }

  template <class T, int D>
  T slope_of_point(const StrainStep<T, D>& step, History<T>& history) const {
    using std::min;
    return min(T(friction_.slope(given_slope_, step, history)), T(greatest_slope_));
  }

  template <class T>
  Surface<T> surface_of(const T& slope) const {
    return {parameters_, elasticity_, detail::friction_of_slope(slope)};
  }

  Elasticity elasticity_;
  Surface<double> surface_;                     // of the parameters
  double greatest_volume_ratio_, given_slope_;  // -
  double greatest_slope_ = std::tan(detail::greatest_friction);
  [[no_unique_address]] Friction friction_;
  [[no_unique_address]] std::conditional_t<constant, Nothing, Parameters> parameters_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
