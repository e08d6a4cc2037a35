// The Kelvin-Voigt solid of examples/extend/laws: stress of a rate, creep, and a bar whose vibration dies
// out.
#include "../../examples/extend/laws/kelvin_voigt.hpp"

#include "catch.hpp"
#include "courant.hpp"

using namespace arenite;

namespace {

constexpr double tau = 0.02;  // s
const Elasticity rubber{"rubber", 1000, 1e5, 0.25};
const KelvinVoigt<2> law{rubber, tau};

}  // namespace

TEST_CASE("a constant rate: stress = M (strain + tau x rate), whatever the number of steps") {
  const double strain = -1e-3, time = 0.1, modulus = rubber.wave_modulus();
  for (const int steps : {1, 10, 100, 1000}) {
    Sym<double, 2> stress;
    KelvinVoigt<2>::History<double> history;
    StrainStep<double, 2> step;
    step.strain[1] = strain / steps;
    step.dt = time / steps;
    for (int k = 0; k < steps; ++k) law.update(stress, step, history);
    CHECK(stress[1] == Approx(modulus * strain * (1 + tau / time)).epsilon(1e-12));
    CHECK(law.elastic_energy(stress, history) == Approx(modulus * strain * strain / 2).epsilon(1e-12));
    law.update(stress, {.strain = {}, .spin = {}, .dt = 1e-6}, history);  // no strain: the dashpot relaxes
    CHECK(stress[1] == Approx(modulus * strain).epsilon(1e-12));
  }
}

TEST_CASE("where no time passes there is no rate") {
  Sym<double, 2> stress;
  KelvinVoigt<2>::History<double> history;
  StrainStep<double, 2> step;
  step.strain[1] = 1e-3;
  law.update(stress, step, history);
  CHECK(stress[1] == Approx(rubber.wave_modulus() * 1e-3).epsilon(1e-14));
}

TEST_CASE("creep under a constant stress: strain = stress / M (1 - exp(-t / tau))") {
  const double load = -100, time = 0.03, modulus = rubber.wave_modulus();
  double last = 0;
  for (const int steps : {100, 200}) {
    Sym<double, 2> stress;
    KelvinVoigt<2>::History<double> history;
    double strain = 0;
    StrainStep<double, 2> step;
    step.dt = time / steps;
    for (int k = 0; k < steps; ++k) {
      const double elastic = stress[1] - history.viscous[1];
      step.strain[1] = (load - elastic) / (modulus * (1 + tau / step.dt));  // so that the load is carried
      strain += step.strain[1];
      law.update(stress, step, history);
      CHECK(stress[1] == Approx(load).epsilon(1e-12));
    }
    const double error = strain / (load / modulus * (1 - std::exp(-time / tau))) - 1;
    if (last != 0) CHECK(last / error == Approx(2).epsilon(0.01));  // implicit Euler: of first order
    last = error;
  }
  CHECK(std::abs(last) <= 0.005);
}

TEST_CASE("the stable step of a scene is that of waves and viscosity together") {
  const double h = 0.1 / std::sqrt(6), c2 = rubber.wave_modulus() / rubber.density();
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}},
              Numerics<QuadraticBSpline, Apic, Usl>{}, bodies(fill(Box{{0., 0.}, {1., 0.5}}, law))};
  const double step = stable_step(scene);
  CHECK(c2 * step * step / (h * h) + 2 * tau * c2 * step / (h * h) == Approx(1));
  CHECK(step < 0.3 * h / std::sqrt(c2));
}

TEST_CASE("a bar's first mode dies out as the damped oscillator, at any step") {
  // With rollers on its sides nothing but the axial strain is left, and u'' = c^2 (u + tau u')_xx: for the
  // mode sin(k x) an oscillator of omega = k c with the damping beta = tau omega^2 / 2.
  const double length = 1, speed = 0.01, wave = pi / (2 * length);
  const double omega = wave * std::sqrt(rubber.wave_modulus() / rubber.density());
  const int cells = 20;
  const double h = length / cells;
  for (const double share : {0.5, 1.0, 2.0})  // of tau
    for (const double courant : {1.0, 0.25}) {
      const double beta = share * tau * omega * omega / 2, damped = std::sqrt(omega * omega - beta * beta);
      Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {length + 4 * h, h}, .cell = h}},
                  Numerics<QuadraticBSpline, Flip, Usl>{},
                  bodies(fill(Box{{0., 0.}, {length, h}}, KelvinVoigt<2>{rubber, share * tau})),
                  walls(left(roller), bottom(roller), top(roller))};
      auto& points = scene.body().points;
      std::vector<double> shape;
      for (std::size_t p = 0; p < points.size(); ++p) {
        shape.push_back(std::sin(wave * points.position[p][0]));
        points.velocity.set(p, Vec<double, 2>(speed * shape[p], 0));
      }
      double worst = 0;
      run(scene, {.end = 2 * 2 * pi / omega, .courant = courant}, [&](const auto& s) {
        double top = 0, bottom = 0;
        for (std::size_t p = 0; p < points.size(); ++p) {
          top += shape[p] * points.velocity[p][0];
          bottom += shape[p] * shape[p];
        }
        const double t = s.time - s.time_step / 2;  // velocities are those of the middle of a step
        const double exact =
            std::exp(-beta * t) * (std::cos(damped * t) - beta / damped * std::sin(damped * t));
        if (s.steps > 0) worst = std::max(worst, std::abs(top / bottom / speed - exact));
      });
      CAPTURE(share, courant, worst, scene.steps);
      CHECK(worst <= 0.02);
    }
}
