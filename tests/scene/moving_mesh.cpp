// A mesh that moves against one that does not: material points carry the state, so that the mesh's motion
// must not show beyond the error of the discretisation.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

constexpr double height = 0.5;

/// A column of a law under gravity, dropped onto the ground; far above it a rigid body that touches nothing
/// leads the mesh.
template <class N, class L, class... Motion>
auto scene(N numerics, L law, double speed, const FillOptions& fill_options, Motion... motion) {
  auto data = test::triangles({0, 0}, {0.3, 1.2}, 6, 24);
  test::name_region(data, "leader", [](const auto& x) { return x[1] > 1.0; });
  const auto velocity = [speed](double) { return std::array<double, 3>{0, speed, 0}; };
  return Scene{PlaneStrain{},
               SimplexMesh<2>(data),
               numerics,
               bodies(fill(Box{{0., 0.}, {0.3, height}}, law, fill_options)),
               walls(left(roller), right(roller), on("bottom", fixed)),
               gravity({0, -9.81}),
               rigids(rigid(MeshSurface{"leader"}, Prescribed{velocity}, Friction::frictionless())),
               motion...};
}

template <class N, class L, class... Motion>
auto scene(N numerics, L law, double speed, int per_cell, Motion... motion) {
  return scene(numerics, law, speed, FillOptions{.per_cell = per_cell}, motion...);
}

/// Mean height of the points over time.
template <class Scene>
std::vector<double> history(Scene s, double end) {
  std::vector<double> mean;
  run(s, {.end = end, .courant = 1, .max_step = 4e-4}, [&](const auto& now) {
    const auto& x = now.body().points.position;
    double sum = 0;
    for (const auto& at : x) sum += at[1] / static_cast<double>(x.size());
    mean.push_back(sum);
  });
  CHECK(s.lost_points() == 0);
  CHECK(s.rigid().impulse.norm() == 0);
  return mean;
}

/// Largest difference of two histories, over the largest travel.
double apart(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0, travel = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    most = std::max(most, std::abs(a[k] - b[k]));
    travel = std::max(travel, std::abs(b[k] - b[0]));
  }
  return most / travel;
}

}  // namespace

// Points that change cells jolt linear elements. Stresses averaged over filled elements leave next to nothing
// of it (0.6 % of the travel at most), few points or many; with elements that count as filled from 0.9 of
// their volume on it was 10 %.
TEST_CASE("Moving mesh: an elastic column swings as on a fixed mesh") {
  const LinearElastic law{{.density = 1500, .young = 1e6, .poisson = 0.3}};
  const MovingMesh<> motion{.fixed_below = 0, .moving_from = 1.0};
  const Numerics<LinearSimplex, Flip, Musl, ElementAverage> numerics{};
  const auto fixed_mesh = history(scene(numerics, law, -1.5, 28), 0.1);
  CHECK(apart(history(scene(numerics, law, 1.5, 28, motion), 0.1), fixed_mesh) <= 0.01);
  const double many = apart(history(scene(numerics, law, -1.5, 28, motion), 0.1), fixed_mesh);
  const double few =
      apart(history(scene(numerics, law, -1.5, 6, motion), 0.1), history(scene(numerics, law, -1.5, 6), 0.1));
  CHECK(many <= 0.01);
  CHECK(few <= 0.01);
  // A mesh that does not move is a fixed one, bit for bit.
  CHECK(apart(history(scene(numerics, law, 0, 6, motion), 0.02), history(scene(numerics, law, 0, 6), 0.02)) ==
        0);
}

TEST_CASE("Moving mesh: a column of sand settles as on a fixed mesh") {
  const MohrCoulomb law{{.density = 1500, .young = 1e6, .poisson = 0.2, .friction = 30_deg}};
  const MovingMesh<> motion{.fixed_below = 0, .moving_from = 1.0};
  const Numerics<LinearSimplex, Flip, Musl, ElementAverage> numerics{};
  const auto fixed_mesh = history(scene(numerics, law, -1.5, 28), 0.05);
  CHECK(apart(history(scene(numerics, law, -1.5, 28, motion), 0.05), fixed_mesh) <= 0.01);
}

// Points at rest change cells: the stress of a cell acts on the volume of the points that happen to be in it, unless it is averaged and
// acts on the whole cell (`ElementAverage`). The remaining errors: points of a cell have one stress, at any distance from its middle
// (also on a mesh at rest), and the scatter of their number changes their weight and mean position.
TEST_CASE("Moving mesh: ground at rest stays at rest to the scatter of the points in the cells") {
  const double density = 1500, poisson = 0.3, floor = density * 9.81 * height;
  const LinearElastic law{{.density = density, .young = 1e7, .poisson = poisson}};
  const auto rms = [&](double speed, int per_cell) {
    auto s = scene(Numerics<LinearSimplex, Flip, Musl, ElementAverage>{}, law, speed,
                   FillOptions{.per_cell = per_cell,
                               .stress = Geostatic{.surface = height, .k0 = poisson / (1 - poisson)}},
                   MovingMesh<>{.fixed_below = 0, .moving_from = 1.0});
    double most = 0;
    run(s, {.end = 0.1}, [&](const auto& now) {
      const auto& points = now.body().points;
      double sum = 0;
      for (std::size_t p = 0; p < points.size(); ++p)
        sum += square(points.stress[p](1, 1) / floor + 1 - points.position[p][1] / height);
      most = std::max(most, std::sqrt(sum / static_cast<double>(points.size())));
    });
    return most;
  };
  // On a mesh at rest: the mean over a triangle of height h has an rms distance of h / sqrt(18) from its middle.
  const double at_rest = 0.05 / std::sqrt(18.) / height;
  CHECK(rms(0, 28) == Approx(at_rest).epsilon(0.02));
  CHECK(rms(-1.5, 28) <= 1.2 * at_rest);
  CHECK(rms(1.5, 28) <= 1.3 * at_rest);
}

TEST_CASE("Moving mesh: the zones move as given, and a used-up zone stops the run with its name") {
  const LinearElastic law{{.density = 1500, .young = 1e6, .poisson = 0.3}};
  auto s = scene(Numerics<LinearSimplex, Flip>{}, law, -2, 6,
                 MovingMesh<>{.fixed_below = 0.6, .moving_from = 1.0});
  const auto before = s.mesh.positions();
  run(s, {.end = 0.05});
  const double travel = s.rigid().displacement[1];
  CHECK(std::abs(travel + 0.1) <= 1e-12);
  for (Index i = 0; i < s.mesh.node_count(); ++i) {
    const double y = before[i][1], share = y <= 0.6 ? 0 : y < 1 ? (y - 0.6) / 0.4 : 1;
    REQUIRE(std::abs(s.mesh.position(i)[1] - y - share * travel) <= 1e-12);
  }
  std::string what;
  try {
    run(s, {.end = 1});
  } catch (const run_error& e) {
    what = e.what();
  }
  CAPTURE(what);
  CHECK(what.find("t = 0.19") == 0);
  CHECK(what.find("compressing zone") != std::string::npos);
}
