// A law that knows the time: a Newtonian fluid, weakly compressible. Its pressure follows the volume, its
// shear stress the rate of strain.
#pragma once

#include <arenite/arenite.hpp>

class NewtonianFluid {
 public:
  template <class T>
  using History = arenite::NoHistory<T>;

  struct Parameters {
    double density = 0;    // kg/m3
    double bulk = 0;       // bulk modulus, Pa
    double viscosity = 0;  // Pa s
  };
  explicit NewtonianFluid(const Parameters& p)
      : density_{p.density}, bulk_{p.bulk}, viscosity_{p.viscosity} {}

  double density() const { return density_; }
  double wave_modulus() const { return bulk_; }

  // The scene takes no longer steps than this. Waves and viscosity together are stable while
  // (c dt / h)^2 + 2 nu dt / h^2 <= 1, with nu = 4/3 viscosity / density for motion along a wave.
  double stable_step(double h) const {
    const double nu = 4 * viscosity_ / (3 * density_), c = std::sqrt(bulk_ / density_);
    return h * h / (nu + std::hypot(nu, c * h));
  }

  // The mean stress carries the pressure from step to step; the deviator depends only on the rate.
  template <class T, int D>
  T update(arenite::Sym<T, D>& stress, const arenite::StrainStep<T, D>& step, History<T>&) const {
    const T mean = trace(stress) * T(1.0 / 3) + T(bulk_) * trace(step.strain);
    stress = add_isotropic(deviator(step.strain) * T(2 * viscosity_ * step.per_time()), mean);
    return T(0);  // nothing separates
  }

  template <class T, int D>
  T elastic_energy(const arenite::Sym<T, D>& stress) const {
    const T mean = trace(stress) * T(1.0 / 3);
    return mean * mean * T(0.5 / bulk_);
  }

 private:
  double density_, bulk_, viscosity_;
};
