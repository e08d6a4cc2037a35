// The error bar of a scene: an elastic bar that vibrates in its first mode, at three sizes of the cells.
#include <arenite/arenite.hpp>
#include <arenite/error_bar/convergence.hpp>

#include "catch.hpp"

using namespace arenite;

namespace {

constexpr double length = 1, wave = pi / (2 * length);  // k of the first mode, fixed at one end, 1/m
const LinearElastic law{{.density = 1000, .young = 1e5, .poisson = 0.25}};

/// Time of a quarter of the period, s: until the velocity by the mode's shape is zero first.
double quarter(int cells) {
  const double h = length / cells;
  const auto first_mode = [](const std::array<double, 3>& x) {
    return std::array{0.01 * std::sin(wave * x[0]), 0.0, 0.0};
  };
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {length + 2 * h, h}, .cell = h}},
              Numerics<LinearGrid, Flip, Usl>{},
              bodies(fill(Box{{0., 0.}, {length, h}}, law, {.per_cell = 4, .velocity = first_mode})),
              walls(left(roller), bottom(roller), top(roller))};
  const auto& points = scene.body().points;
  std::vector<double> shape;
  for (std::size_t p = 0; p < points.size(); ++p) shape.push_back(std::sin(wave * points.position[p][0]));
  double before = 0, then = 0, zero = 0;
  run(scene, {.end = 2 * length / std::sqrt(law.wave_modulus() / law.density()), .courant = 0.1},
      [&](const auto& s) {
        double now = 0;
        for (std::size_t p = 0; p < points.size(); ++p) now += shape[p] * points.velocity[p][0];
        if (s.time > 0 && before * now <= 0 && zero == 0)
          zero = then + (s.time - then) * before / (before - now);
        before = now;
        then = s.time;
        return zero > 0 ? RunFlow::stop : RunFlow::go_on;
      });
  return zero;
}

}  // namespace

TEST_CASE("Convergence of a scene: the error bar contains the bar's period") {
  std::vector<SizedResult> results;
  for (const int cells : {12, 17, 24}) results.push_back({length / cells, quarter(cells)});
  const Convergence c = convergence(results);
  const double exact = length / std::sqrt(law.wave_modulus() / law.density());
  CAPTURE(c.results[0].value, c.results[1].value, c.results[2].value, exact, c.uncertainty);
  REQUIRE(c.monotone());
  CAPTURE(*c.order, *c.extrapolated);
  CHECK(c.converged);
  CHECK(std::abs(*c.order - 2) < 0.3);  // the lumped mass errs by (k h)^2 / 24
  CHECK(std::abs(c.value() - exact) < c.uncertainty);
  CHECK(c.uncertainty < 2e-3 * exact);
}
