// A column under its own weight between smooth walls: the vertical stress is the weight above, the horizontal
// one nu / (1 - nu) of it, however far the column has settled.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "courant.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

constexpr double height = 1, width = 0.1, poisson = 0.3, density = 2000, g = 9.81;
constexpr double k0 = poisson / (1 - poisson);
constexpr int cells = 10;

LinearElastic soil() { return LinearElastic{{.density = density, .young = 1e7, .poisson = poisson}}; }

/// Largest deviations from the analytic stress, over rho g H, and largest speed over sqrt(g H).
struct Deviation {
  double vertical = 0, horizontal = 0, speed = 0;
};

/// Of the mean stresses in time over a run to `end`. No point changes its cell: they keep their order.
template <class Scene>
Deviation mean_deviation(Scene scene, double end) {
  const auto& points = scene.body().points;
  const auto initial = points.position;
  std::vector<Sym<double, 2>> mean(points.size());
  Deviation d;
  run(scene, {.end = end, .courant = test::courant(scene, 0.5)}, [&](const auto& s) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      mean[p] += points.stress[p] * (s.time_step / end);
      d.speed = std::max(d.speed, points.velocity[p].norm() / std::sqrt(g * height));
    }
  });
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double unit = density * g * height, exact = -density * g * (height - initial[p][1]);
    d.vertical = std::max(d.vertical, std::abs(mean[p][1] - exact) / unit);
    d.horizontal = std::max(
        {d.horizontal, std::abs(mean[p][0] - k0 * exact) / unit, std::abs(mean[p][2] - k0 * exact) / unit});
  }
  return d;
}

template <class N>
auto on_grid(N numerics, FillOptions options) {
  const double h = height / cells;
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {width, height + 2 * h}, .cell = h}},
               numerics,
               bodies(fill(Box{{0., 0.}, {width, height}}, soil(), options)),
               walls(left(roller), right(roller), bottom(roller)),
               gravity({0, -g})};
}

template <class N>
auto on_triangles(N numerics, FillOptions options) {
  const auto mesh = test::triangles({0, 0}, {width, height + 0.2}, 1, cells + 2);
  return Scene{PlaneStrain{},
               SimplexMesh<2>(mesh),
               numerics,
               bodies(fill(Box{{0., 0.}, {width, height}}, soil(), options)),
               walls(left(roller), right(roller), bottom(roller)),
               gravity({0, -g})};
}

void check(const Deviation& d, double stress, double speed) {
  CAPTURE(d.vertical, d.horizontal, d.speed);
  CHECK(d.vertical <= stress);
  CHECK(d.horizontal <= stress);
  CHECK(d.speed <= speed);
}

}  // namespace

TEST_CASE("Column: gravity switched on swings about the analytic stress") {
  // The mean over whole periods 4 H / c is the static stress. A cell's stress is one on triangles: points off
  // its middle are wrong by up to half a cell's weight, 0.05.
  const double end = 8 * height / std::sqrt(soil().wave_modulus() / density);
  const double fall = 1;  // the speed g H / c is below sqrt(g H)
  check(mean_deviation(on_grid(Numerics<QuadraticBSpline, Flip>{}, {.per_cell = 4}), end), 0.03, fall);
  check(mean_deviation(on_grid(Numerics<QuadraticBSpline, Apic, Usl>{}, {.per_cell = 4}), end), 0.03, fall);
  check(mean_deviation(on_triangles(Numerics<LinearSimplex, Flip>{}, {.per_cell = 6}), end), 0.06, fall);
  check(mean_deviation(on_triangles(Numerics<LinearSimplex, Flip, Musl, NodalAveraging>{}, {.per_cell = 6}),
                       end),
        0.06, fall);
}

TEST_CASE("Column: geostatic stress stays put") {
  const FillOptions grid{.per_cell = 4, .stress = Geostatic{.surface = height, .k0 = k0}};
  const FillOptions mesh{.per_cell = 6, .stress = Geostatic{.surface = height, .k0 = k0}};
  // Points of equal weight integrate the linear stress against constant gradients, and the weight against
  // linear functions, exactly: the column rests to round-off.
  check(mean_deviation(on_triangles(Numerics<LinearSimplex, Flip>{}, mesh), 0.3), 1e-12, 1e-12);
  check(mean_deviation(on_triangles(Numerics<LinearSimplex, Tpic, Usl>{}, mesh), 0.3), 1e-12, 1e-12);
  check(mean_deviation(on_triangles(Numerics<LinearSimplex, Flip, Musl, NodalAveraging>{}, mesh), 0.3), 1e-12,
        1e-12);
  // Splines are integrated with an error at the two ends of the column: a fraction of a cell's weight, 0.1.
  check(mean_deviation(on_grid(Numerics<QuadraticBSpline, Flip>{}, grid), 0.3), 0.02, 0.001);
  check(mean_deviation(on_grid(Numerics<QuadraticBSpline, Apic>{}, grid), 0.3), 0.02, 0.001);
}
