// A law that knows the time and keeps a history: a Kelvin-Voigt solid, a spring beside a dashpot.
#pragma once

#include <arenite/arenite.hpp>

/// Stress C : (strain + tau x rate of strain), where C is Hooke's law and tau the retardation time. `D`: the
/// scene's dimension.
template <int D>
class KelvinVoigt {
 public:
  template <class T>
  struct History {
    arenite::Sym<T, D> viscous;  // the dashpot's part of the stress, Pa
    auto members() { return arenite::tied(viscous.c); }
    auto members() const { return arenite::tied(viscous.c); }
  };

  struct Parameters {  // what Python gives by name: ar.compile(law=.., name="KelvinVoigt<2>")
    double density = 0, young = 0, poisson = 0, tau = 0;  // kg/m3, Pa, -, s
  };
  KelvinVoigt(const arenite::Elasticity& elasticity, double tau) : elasticity_{elasticity}, tau_{tau} {}
  explicit KelvinVoigt(const Parameters& p)
      : KelvinVoigt({"KelvinVoigt", p.density, p.young, p.poisson}, p.tau) {}

  double density() const { return elasticity_.density(); }
  double wave_modulus() const { return elasticity_.wave_modulus(); }

  // Stable while (c dt / h)^2 + 2 nu dt / h^2 <= 1, with nu = tau c^2.
  double stable_step(double h) const {
    const double c2 = wave_modulus() / density(), nu = tau_ * c2;
    return h * h / (nu + std::hypot(nu, std::sqrt(c2) * h));
  }

  template <class T>
  T update(arenite::Sym<T, D>& stress, const arenite::StrainStep<T, D>& step, History<T>& history) const {
    const arenite::Sym<T, D> change = elasticity_.stress(step.strain);
    const arenite::Sym<T, D> elastic = turned(stress - history.viscous, step.spin) + change;
    history.viscous = change * T(tau_ * step.per_time());
    stress = elastic + history.viscous;
    return T(0);
  }

  // The energy of the spring: the dashpot's stress stores nothing.
  template <class T>
  T elastic_energy(const arenite::Sym<T, D>& stress, const History<T>& history) const {
    return elasticity_.energy(stress - history.viscous);
  }

 private:
  arenite::Elasticity elasticity_;
  double tau_;  // s
};
