// Linear elasticity once more, as a user would write it, under names that the library has too.
#pragma once
#include <arenite/arenite.hpp>

struct Held {
  struct Parameters {
    double density = 0, young = 0, poisson = 0;
  };
  template <class T>
  using History = arenite::NoHistory<T>;
  static constexpr bool linear = true;

  explicit Held(const Parameters& p) : elasticity{"Held", p.density, p.young, p.poisson} {}
  double density() const { return elasticity.density(); }
  double wave_modulus() const { return elasticity.wave_modulus(); }
  template <class T, int D>
  T update(arenite::Sym<T, D>& stress, const arenite::StrainStep<T, D>& step, arenite::NoHistory<T>&) const {
    stress = arenite::turned(stress, step.spin) + elasticity.stress(step.strain);
    return T(0);
  }
  template <class T, int D>
  T elastic_energy(const arenite::Sym<T, D>& stress) const {
    return elasticity.energy(stress);
  }
  arenite::Elasticity elasticity;
};

struct Registration : Held {  // a detail of the library
  using Held::Held;
};
