// The Newtonian fluid of examples/extend/laws: hydrostatic pressure at rest, a parabola between plates.
#include "../../examples/extend/laws/newtonian_fluid.hpp"

#include "catch.hpp"

using namespace arenite;

TEST_CASE("shear stress is viscosity times shear rate, and none where no time passes") {
  const NewtonianFluid water{{.density = 1000, .bulk = 2e9, .viscosity = 1e-3}};
  Sym<double, 2> stress{{-5, -5, -5, 0}};
  NoHistory<double> history;
  StrainStep<double, 2> step;
  step.strain[3] = 0.01;
  step.dt = 0.005;
  water.update(stress, step, history);
  CHECK(stress[3] == Approx(1e-3 * 2 * 0.01 / 0.005));
  CHECK(trace(stress) / 3 == Approx(-5));
  step.dt = 0;
  water.update(stress, step, history);
  CHECK(stress[3] == 0);
}

TEST_CASE("a column let go comes to rest with the pressure of the weight above") {
  const double height = 1, width = 0.1, density = 1000, g = 9.81, bulk = 1e6, h = 0.1;
  // Damping of the first mode k = pi / (2 H): half its frequency.
  const double nu = 0.5 * 2 * std::sqrt(bulk / density) / (pi / 2 / height);
  const NewtonianFluid honey{{.density = density, .bulk = bulk, .viscosity = 0.75 * density * nu}};
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {width, height + 2 * h}, .cell = h}},
              Numerics<QuadraticBSpline, Flip, Usl>{},
              bodies(fill(Box{{0., 0.}, {width, height}}, honey)),
              walls(left(roller), right(roller), bottom(roller)),
              gravity({0, -g})};
  run(scene, {.end = 0.5, .courant = 1});
  const auto& points = scene.body().points;
  double worst = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double depth = height * (1 - density * g * height / bulk / 2) - points.position[p][1];
    worst = std::max(worst, std::abs(-trace(points.stress[p]) / 3 - density * g * depth));
    CHECK(points.velocity[p].norm() <= 1e-3 * std::sqrt(g * height));
  }
  CAPTURE(worst / (density * g * height));
  CHECK(worst <= 0.02 * density * g * height);
}

TEST_CASE("Poiseuille flow: between plates the velocity is a parabola") {
  const double height = 1, density = 1, viscosity = 1, g = 1e-5, h = 0.1;
  const NewtonianFluid oil{{.density = density, .bulk = 100, .viscosity = viscosity}};
  // Both ends stay plane: nothing but the distance to the plates matters. The flow goes a millionth of a
  // cell.
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.3, height}, .cell = h}},
              Numerics<QuadraticBSpline, Flip, Usl>{},
              bodies(fill(Box{{0., 0.}, {0.3, height}}, oil)),
              walls(bottom(fixed), top(fixed), left(free_along(0)), right(free_along(0))),
              gravity({g, 0})};
  const double spread = density * height * height / viscosity;  // time in which motion spreads, s
  run(scene, {.end = 1.5 * spread, .courant = 1});
  // Points of FLIP move with the velocity of the nodes; their own keeps what the nodes do not see.
  const auto before = scene.body().points.position;
  const double start = scene.time;
  run(scene, {.end = 1.6 * spread, .courant = 1});
  const auto& points = scene.body().points;
  const double fastest = density * g * height * height / (8 * viscosity);
  double worst = 0, mean = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double y = points.position[p][1] / height;
    const Vec<double, 2> u = (points.position[p] - before[p]) / (scene.time - start) / fastest;
    worst = std::max(worst, std::abs(u[0] - 4 * y * (1 - y)));
    mean += u[0] / static_cast<double>(points.size());
    CHECK(std::abs(u[1]) <= 1e-3);
  }
  CAPTURE(worst, mean);
  CHECK(worst <= 0.01);
  CHECK(mean == Approx(2.0 / 3).epsilon(0.01));
}
