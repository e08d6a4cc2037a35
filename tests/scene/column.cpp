// A column under its own weight between smooth walls: the vertical stress is the weight above, the horizontal one
// nu / (1 - nu) of it, however far the column has settled.
#include <algorithm>
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

constexpr double height = 1, width = 0.1, poisson = 0.3, density = 2000, g = 9.81;
constexpr double k0 = poisson / (1 - poisson);
constexpr int cells = 10;

LinearElastic soil() { return LinearElastic{{.density = density, .young = 1e6, .poisson = poisson}}; }

/// Largest deviations from the analytic stress, over rho g H, and largest speed over sqrt(g H).
struct Deviation {
  double vertical = 0, horizontal = 0, speed = 0;
};

/// A point's initial height is that of the point of the same rank in the initial column: no point overtakes another.
template <class Scene>
Deviation deviation(const Scene& scene, std::vector<double> initial) {
  const auto& points = std::get<0>(scene.bodies).points;
  REQUIRE(points.size() == initial.size());
  std::sort(initial.begin(), initial.end());
  std::vector<std::size_t> rank(points.size());
  for (std::size_t p = 0; p < rank.size(); ++p) rank[p] = p;
  std::sort(rank.begin(), rank.end(),
            [&](std::size_t a, std::size_t b) { return points.position[a][1] < points.position[b][1]; });
  Deviation d;
  for (std::size_t k = 0; k < rank.size(); ++k) {
    const auto& s = points.stress[rank[k]];
    const double unit = density * g * height, exact = -density * g * (height - initial[k]);
    d.vertical = std::max(d.vertical, std::abs(s[1] - exact) / unit);
    d.horizontal = std::max({d.horizontal, std::abs(s[0] - k0 * exact) / unit, std::abs(s[2] - k0 * exact) / unit});
    d.speed = std::max(d.speed, points.velocity[rank[k]].norm() / std::sqrt(g * height));
  }
  return d;
}

template <class Scene>
Deviation after(Scene scene, double end) {
  std::vector<double> initial;
  for (const auto& x : std::get<0>(scene.bodies).points.position) initial.push_back(x[1]);
  run(scene, {.end = end, .courant = 0.5});
  return deviation(scene, initial);
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

TEST_CASE("Column: gravity switched on and damped ends in the analytic stress") {
  // PIC damps. The speed of a wave is 26 m/s, the first period 0.15 s. What is left is the error of the discretisation: a
  // cell's stress is that of its centre on triangles (half a cell's weight, 0.05), nearly linear on splines.
  check(after(on_grid(Numerics<QuadraticBSpline, Flip>{.transfer = {.share = 0.9}}, {.per_cell = 4}), 1.5), 0.02, 1e-4);
  check(after(on_triangles(Numerics<LinearSimplex, Flip>{.transfer = {.share = 0.9}}, {.per_cell = 6}), 1.5), 0.06, 1e-4);
  check(after(on_triangles(Numerics<LinearSimplex, Flip, Musl, NodalAveraging>{.transfer = {.share = 0.9}},
                           {.per_cell = 6}),
              1.5),
        0.06, 1e-4);
}

TEST_CASE("Column: geostatic stress stays put") {
  const FillOptions grid{.per_cell = 4, .stress = Geostatic{.surface = height, .k0 = k0}};
  const FillOptions mesh{.per_cell = 6, .stress = Geostatic{.surface = height, .k0 = k0}};
  // Points of equal weight integrate the linear stress against constant gradients, and the weight against linear
  // functions, exactly: the column rests to round-off.
  check(after(on_triangles(Numerics<LinearSimplex, Flip>{}, mesh), 0.3), 1e-12, 1e-12);
  check(after(on_triangles(Numerics<LinearSimplex, Tpic, Usl>{}, mesh), 0.3), 1e-12, 1e-12);
  check(after(on_triangles(Numerics<LinearSimplex, Flip, Musl, NodalAveraging>{}, mesh), 0.3), 1e-12, 1e-12);
  // Splines are integrated with an error at the two ends of the column.
  check(after(on_grid(Numerics<QuadraticBSpline, Flip>{}, grid), 0.3), 0.01, 0.01);
  check(after(on_grid(Numerics<QuadraticBSpline, Apic>{}, grid), 0.3), 0.01, 0.01);
}
