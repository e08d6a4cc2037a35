// Convergence with the cell size where points cross cells: an elastic bar between two walls that vibrates by
// up to 0.64 cells, against a manufactured solution. As in Steffen, Kirby and Berzins 2008
// (doi:10.1002/nme.2360): with splines the error falls with the square of the cell size; with linear
// functions the error of each crossing stays.
#include <arenite/arenite.hpp>

#include "catch.hpp"

using namespace arenite;

namespace {

constexpr double length = 1, amplitude = 0.02, k = pi / length;
const LinearElastic rubber{{.density = 1000, .young = 1e5, .poisson = 0}};
const double wave = std::sqrt(rubber.wave_modulus() / rubber.density());  // m/s

/// u(X, t) = A sin(k X) sin(w t) of the matter at X, and the acceleration by the body force that it takes:
/// stress is M ln F of F = 1 + u', so that a = b + c^2 u'' / F.
double displacement(double at, double time) {
  return amplitude * std::sin(k * at) * std::sin(wave * k * time);
}
double stretch(double at, double time) {
  return 1 + amplitude * k * std::cos(k * at) * std::sin(wave * k * time);
}
double body_force(double at, double time) {
  const double u = displacement(at, time), c2 = square(wave);
  return -c2 * k * k * u + c2 * k * k * u / stretch(at, time);
}

struct Manufactured {
  template <class Scene>
  void add_force(Scene& scene, double) {
    const auto& points = scene.body().points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Vec<double, 2> x = points.position[p];
      double at = x[0];  // of the matter that is here now, by Newton's iteration
      for (int i = 0; i < 4; ++i) at -= (at + displacement(at, scene.time) - x[0]) / stretch(at, scene.time);
      const typename Scene::Shape::template Cell<typename Scene::Mesh> cell(scene.mesh, points.cell[p]);
      const auto w = cell.weights(x);
      const double f = points.mass[p] * body_force(at, scene.time);
      for (int i = 0; i < w.size(); ++i)
        scene.fields[0].sums[cell.nodes[static_cast<std::size_t>(i)]].add_force({w[i] * f, 0});
    }
  }
};

/// Greatest root mean square of the points' errors within half a period, over the amplitude.
template <class N>
double error_of(int cells, N numerics = {}) {
  const double h = length / cells;
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {length, h}, .cell = h}},
              numerics,
              bodies(fill(Box{{0., 0.}, {length, h}}, rubber, {.per_cell = 4})),
              walls(left(roller), right(roller), bottom(roller), top(roller)),
              Manufactured{}};
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p)
    points.velocity.set(p, Vec<double, 2>(amplitude * std::sin(k * points.position[p][0]) * wave * k, 0));
  const auto along = [&] {  // points keep their order along the bar
    std::vector<double> x;
    for (const auto& place : points.position) x.push_back(place[0]);
    std::sort(x.begin(), x.end());
    return x;
  };
  const auto start = along();
  const double end = length / wave;
  const int steps = 10 * cells;
  double worst = 0;
  for (int n = 1; n <= steps; ++n) {
    step(scene, end / steps);
    const auto now = along();
    double sum = 0;
    for (std::size_t p = 0; p < now.size(); ++p)
      sum += square(now[p] - start[p] - displacement(start[p], scene.time));
    worst = std::max(worst, std::sqrt(sum / static_cast<double>(now.size())) / amplitude);
  }
  return worst;
}

}  // namespace

TEST_CASE("Points cross cells: order 2 on splines, none with linear functions") {
  const auto errors = [](auto numerics) {
    return std::array<double, 3>{error_of(8, numerics), error_of(16, numerics), error_of(32, numerics)};
  };
  const auto linear = errors(Numerics<LinearGrid, Flip, Usl>{});
  const auto quadratic = errors(Numerics<QuadraticBSpline, Flip, Usl>{});
  const auto cubic = errors(Numerics<CubicBSpline, Flip, Usl>{});
  CAPTURE(linear, quadratic, cubic);
  CHECK(linear[2] >= 0.5 * linear[1]);
  CHECK(std::log2(quadratic[1] / quadratic[2]) >= 1.9);
  CHECK(std::log2(cubic[1] / cubic[2]) >= 1.6);  // with 16 points a cell, too slow here, 1.9
}
