// Strain at the middle of a step's motion: against matrices, and on a disc that spins.
#include <arenite/arenite.hpp>
#include <cmath>
#include <random>

#include "catch.hpp"

using namespace arenite;

namespace {

/// Strain steps of a random gradient beside sym and skew of G + squares / 2 G^2.
template <int D, int squares>
void check_random_gradients() {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 50; ++k) {
    Eigen::Matrix<double, D, D> g;
    for (int i = 0; i < D * D; ++i) g.data()[i] = normal(random);
    const Eigen::Matrix<double, D, D> whole = g + 0.5 * squares * g * g;
    const auto step = strain_step_of<double, D, squares>([&](std::size_t b) {
      std::array<double, static_cast<std::size_t>(D)> column{};
      for (int a = 0; a < D; ++a) column[static_cast<std::size_t>(a)] = g(a, static_cast<int>(b));
      return column;
    });
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) CHECK(step.gradient(i, j) == Approx(whole(i, j)).margin(1e-13));
  }
}

struct Spun {
  double radius, energy;  // over those at the start
};

/// A disc of rubber after one turn, at a rim speed of 0.05 of the wave speed.
template <class N>
Spun spin(double courant) {
  const double radius = 0.3, rate = 0.05 * std::sqrt(1e6 / 1000 * 0.7 / (1.3 * 0.4)) / radius;
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
  const auto turning = [&](const auto& x) {
    return std::array{-rate * (x[1] - 0.5), rate * (x[0] - 0.5), 0.0};
  };
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 1. / 16}}, N{},
              bodies(fill(Ball({0.5, 0.5}, radius), rubber, {.per_cell = 4, .velocity = turning})),
              TrackEnergy{}};
  const auto size = [&] {
    double sum = 0;
    const auto& points = scene.template body<0>().points;
    for (std::size_t p = 0; p < points.size(); ++p)
      sum += (Vec<double, 2>(points.position[p]) - Vec<double, 2>(0.5, 0.5)).squaredNorm();
    return std::sqrt(sum / static_cast<double>(points.size()));
  };
  const double before = size(), energy = energies(scene).kinetic;
  run(scene, {.end = 2 * pi / rate, .courant = courant, .watch = false});
  const Energies e = energies(scene);
  return {size() / before, (e.kinetic + e.strain) / energy};
}

template <class Order>
void check_disc() {
  using Middle = Numerics<QuadraticBSpline, Apic, MidpointStrain<Order>>;
  const Spun begin = spin<Numerics<QuadraticBSpline, Apic, Order>>(0.5), middle = spin<Middle>(0.5);
  CAPTURE(begin.radius, begin.energy, middle.radius, middle.energy);
  // Elastic, it is longer by 0.1 % than at rest: rho w^2 R^2 / E.
  CHECK(std::abs(middle.radius - 1) < 1.5e-3);
  CHECK(std::abs(middle.energy - 1) < 0.2 * std::abs(begin.energy - 1));
  CHECK(std::abs(begin.energy - 1) > 5e-3);  // what it cures
  CHECK(std::abs(begin.radius - 1) > 2e-3);
}

}  // namespace

TEST_CASE("The strain at the middle is that of the gradient and half of its square") {
  check_random_gradients<2, -1>();
  check_random_gradients<2, 1>();
  check_random_gradients<3, -1>();
  check_random_gradients<3, 1>();
}

TEST_CASE("The stretch that straight paths of points add in a rotation is strained") {
  const double angle = 0.01;
  const auto step = strain_step_of<double, 2, -1>([&](std::size_t b) {
    return b == 0 ? std::array{0.0, angle} : std::array{-angle, 0.0};
  });
  CHECK(step.strain[0] == Approx(std::log(std::hypot(1, angle))).epsilon(1e-4));
  CHECK(step.strain[1] == Approx(std::log(std::hypot(1, angle))).epsilon(1e-4));
  CHECK(step.strain[3] == 0);
}

TEST_CASE("A disc that spins neither swells nor shrinks, and keeps its energy") {
  check_disc<Usl>();
  check_disc<Musl>();
  check_disc<Usf>();
}
