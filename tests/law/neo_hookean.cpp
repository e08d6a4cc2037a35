// The neo-Hookean solid of examples/extend/laws against closed forms of finite strain.
#include "../../examples/extend/laws/neo_hookean.hpp"

#include "catch.hpp"
#include "states.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

const Elasticity rubber{"rubber", 1000, 1e6, 0.3};
const NeoHookean law{rubber};

template <int D>
struct Point {
  Sym<double, D> stress{};
  NeoHookean::History<double> history{};
  void take(const StrainStep<double, D>& step, int times) {
    for (int k = 0; k < times; ++k) law.update(stress, step, history);
  }
};

}  // namespace

TEST_CASE("simple shear: tau = G gamma, sigma_xx = G gamma^2, in one step as in a thousand") {
  const double gamma = 1.5, shear = rubber.shear();
  for (const int steps : {1, 10, 1000}) {
    Point<2> plane;
    Point<3> solid;
    StrainStep<double, 2> a;
    a.strain[3] = a.spin[0] = gamma / 2 / steps;  // dv_x/dy
    StrainStep<double, 3> b;
    b.strain[5] = gamma / 2 / steps;  // the same in the plane of z and x: dv_z/dx
    b.spin[2] = gamma / 2 / steps;
    plane.take(a, steps);
    solid.take(b, steps);
    CHECK(std::abs(plane.stress[3] / (shear * gamma) - 1) <= 1e-11);
    CHECK(std::abs(plane.stress[0] / (shear * gamma * gamma) - 1) <= 1e-11);
    CHECK(std::abs(plane.stress[1]) + std::abs(plane.stress[2]) <= 1e-11 * shear);
    CHECK(std::abs(solid.stress[5] - plane.stress[3]) <= 1e-11 * shear);
    CHECK(std::abs(solid.stress[2] - plane.stress[0]) <= 1e-11 * shear);
    CHECK(std::abs(law.elastic_energy(plane.stress, plane.history) / (shear * gamma * gamma / 2) - 1) <=
          1e-11);
  }
}

TEST_CASE("uniaxial strain: the stress of its stretch, whose logarithm is the sum of the strains") {
  for (const double strain : {-0.7, 0.7}) {
    const double stretch = std::exp(strain), shear = rubber.shear();
    const double exact = (shear * (stretch * stretch - 1) + rubber.lame() * strain) / stretch;
    double last = 0;
    for (const int steps : {50, 100}) {
      Point<3> p;
      StrainStep<double, 3> step;
      step.strain[1] = strain / steps;
      p.take(step, steps);
      const double error = p.stress[1] / exact - 1;
      if (last != 0) CHECK(std::abs(last / error - 4) <= 0.01);  // of second order
      last = error;
      CHECK(std::abs(p.stress[0] - rubber.lame() * strain / stretch) <= 1e-3 * shear);
    }
    CHECK(std::abs(last) <= 1e-4);
  }
}

TEST_CASE("a rotation gives no stress, and turns the stress that is there") {
  Point<3> p;
  StrainStep<double, 3> turn;
  turn.spin = {0.2, -0.1, 0.3};
  p.take(turn, 100);
  for (const double s : p.stress.c) CHECK(std::abs(s) <= 1e-12 * rubber.shear());
  StrainStep<double, 3> stretch;
  stretch.strain = {{0.3, -0.1, 0.05, 0.2, 0, 0.1}};
  p.take(stretch, 1);
  auto turned_stress = p.stress;
  const double energy = law.elastic_energy(p.stress, p.history);
  p.take(turn, 25);
  for (int k = 0; k < 25; ++k) turned_stress = turned(turned_stress, turn.spin);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(std::abs(p.stress[i] - turned_stress[i]) <= 1e-12 * rubber.shear());
  CHECK(std::abs(law.elastic_energy(p.stress, p.history) / energy - 1) <= 1e-12);
}

TEST_CASE("work is energy: along a path of stretches, and along its derivative the wave modulus") {
  Point<3> p;
  StrainStep<double, 3> step;
  const int steps = 4000;
  step.strain = {{0.4 / steps, -0.2 / steps, 0.1 / steps, 0.3 / steps, 0, 0.1 / steps}};
  step.spin = {0.2 / steps, 0, 0.1 / steps};
  double work = 0, volume = 1;  // over the unit volume before
  for (int k = 0; k < steps; ++k) {
    const auto before = p.stress;
    const double middle = volume * std::exp(trace(step.strain) / 2);
    p.take(step, 1);
    work += middle * contract(before + p.stress, step.strain) / 2;
    volume *= std::exp(trace(step.strain));
  }
  CHECK(std::abs(work / (volume * law.elastic_energy(p.stress, p.history)) - 1) <= 1e-6);

  // A plane wave along the axis of the greatest stretch: density_0 c^2 = J d(sigma)/d(strain), both along it.
  Point<3> q;
  StrainStep<double, 3> stretch;
  stretch.strain[0] = 1e-3;
  q.take(stretch, 500);
  const double modulus = law.wave_modulus(q.stress, q.history);
  const double stress = q.stress[0], h = 1e-6;
  stretch.strain[0] = h;
  q.take(stretch, 1);
  CHECK(std::abs(std::exp(0.5) * (q.stress[0] - stress) / h / modulus - 1) <= 1e-5);
  Point<3> unstressed;
  CHECK(law.wave_modulus(unstressed.stress, unstressed.history) == Approx(law.wave_modulus()));
}

TEST_CASE("the stable step follows the stiffness of stretched material") {
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}},
              Numerics<QuadraticBSpline, Apic, Usl>{}, bodies(fill(Box{{0., 0.}, {1., 0.5}}, law))};
  const double before = stable_step(scene);
  CHECK(before == Approx(0.1 / std::sqrt(law.wave_modulus() / law.density()) / std::sqrt(6)));
  auto& points = scene.body().points;
  NeoHookean::History<double> stretched;
  stretched.f[0] = 3;
  points.store_history(57, stretched);
  const double modulus = law.wave_modulus(Sym<double, 2>{}, stretched);
  CHECK(modulus > 2 * law.wave_modulus());
  CHECK(stable_step(scene) / before == Approx(std::sqrt(law.wave_modulus() / modulus)));
  CHECK(strain_energy(scene.body()) ==
        Approx(points.volume[57] * law.elastic_energy(Sym<double, 2>{}, stretched)));
}
