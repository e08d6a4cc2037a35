// Oedometer: a layer between smooth walls pressed from above. The strain is uniform and uniaxial, so that the
// stress is M times the logarithmic strain (the Jaumann rate integrated at no spin), the lateral one nu / (1
// - nu) of it, and sand at failure rests at the active ratio (1 - sin phi) / (1 + sin phi).
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "courant.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

constexpr double height = 0.4, platen = 0.1, speed = 0.5, squeeze = 0.008;

LinearElastic soil() { return LinearElastic{{.density = 1000, .young = 1e7, .poisson = 0.3}}; }

auto pressing() {
  return Prescribed{[](double) { return std::array<double, 3>{0, -speed, 0}; }};
}

/// A mesh that follows the platen: its own strain is that of the soil, and the platen's nodes stay on its
/// face.
MovingMesh<> following() { return {.fixed_below = 0, .moving_from = height}; }

/// A linear velocity from the start, so that no wave runs through the layer.
template <class Scene>
void start_uniform(Scene& scene) {
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    auto v = points.velocity[p];
    v.setZero();
    v[1] = -speed * points.position[p][1] / height;
    points.velocity.set(p, v);
    if constexpr (std::remove_cvref_t<decltype(points)>::affine) {
      auto gradient = points.velocity_gradient[p];
      gradient(1, 1) = -speed / height;
      points.velocity_gradient.set(p, gradient);
    }
  }
}

/// Presses to a compression `squeeze` and compares all stresses. `ratio`: the lateral over the axial stress.
template <class Scene>
void check(Scene scene, double ratio, double tolerance) {
  start_uniform(scene);
  run(scene, {.end = squeeze / speed, .courant = test::courant(scene, 0.5)});
  const auto& body = scene.body();
  const double strain = std::log((height - squeeze) / height);
  double axial = 0, lateral = 0;
  for (const auto& s : body.points.stress) {
    axial = std::max(axial, std::abs(s[1] / (body.law.wave_modulus() * strain) - 1));
    lateral = std::max({lateral, std::abs(s[0] / s[1] - ratio), std::abs(s[2] / s[1] - ratio)});
  }
  CAPTURE(axial, lateral);
  CHECK(lateral <= tolerance);
  if (ratio == soil().elasticity().poisson() / (1 - soil().elasticity().poisson())) CHECK(axial <= tolerance);
}

template <class N, class L>
auto on_triangles(N numerics, L law) {
  auto data = test::triangles({0, 0}, {0.2, height + platen}, 2, 5);
  test::name_region(data, "platen", [](const auto& x) { return x[1] > height; });
  return Scene{PlaneStrain{},
               SimplexMesh<2>(data),
               numerics,
               bodies(fill(Cells("all"), law, {.per_cell = 6})),
               walls(left(roller), right(roller), bottom(roller)),
               rigids(rigid(MeshSurface{"platen"}, pressing(), Friction::frictionless())),
               following()};
}

template <class N, class L>
auto on_tetrahedra(N numerics, L law) {
  auto data = test::tetrahedra({0, 0, 0}, {0.1, height + platen, 0.1}, {1, 5, 1});
  test::name_region(data, "platen", [](const auto& x) { return x[1] > height; });
  return Scene{ThreeDimensional{},
               SimplexMesh<3>(data),
               numerics,
               bodies(fill(Cells("all"), law, {.per_cell = 4})),
               walls(left(roller), right(roller), front(roller), back(roller), bottom(roller)),
               rigids(rigid(MeshSurface{"platen"}, pressing(), Friction::frictionless())),
               following()};
}

constexpr double k0 = 0.3 / 0.7;

}  // namespace

TEST_CASE("Oedometer on triangles: elastic, and every cure of locking gives the same") {
  check(on_triangles(Numerics<LinearSimplex, Tpic, Usl>{}, soil()), k0, 5e-4);
  check(on_triangles(Numerics<LinearSimplex, Tpic, Musl, NodalAveraging>{}, soil()), k0, 5e-4);
  check(on_triangles(Numerics<LinearSimplex, Tpic, Usl, ElementAverage>{}, soil()), k0, 5e-4);
  // FLIP smears the velocity at the faces in the first step: waves of that size run through the layer.
  check(on_triangles(Numerics<LinearSimplex, Flip, Usl>{}, soil()), k0, 0.03);
  check(on_triangles(Numerics<LinearSimplex, Flip, Musl>{}, soil()), k0, 0.03);
  check(on_triangles(Numerics<LinearSimplex, Flip, Musl, NodalAveraging>{}, soil()), k0, 0.03);
}

TEST_CASE("Oedometer on tetrahedra: elastic, and every cure of locking gives the same") {
  check(on_tetrahedra(Numerics<LinearSimplex, Tpic, Usl>{}, soil()), k0, 5e-4);
  check(on_tetrahedra(Numerics<LinearSimplex, Tpic, Musl, NodalAveraging>{}, soil()), k0, 5e-4);
  check(on_tetrahedra(Numerics<LinearSimplex, Tpic, Usl, ElementAverage>{}, soil()), k0, 5e-4);
  check(on_tetrahedra(Numerics<LinearSimplex, Flip, Musl, NodalAveraging>{}, soil()), k0, 0.05);
}

TEST_CASE(
    "Oedometer with sand: at rest it stays elastic, with a low Poisson's ratio it yields at the active "
    "ratio") {
  const MohrCoulomb rest{{.density = 1000, .young = 1e7, .poisson = 0.3, .friction = 40_deg}};
  const MohrCoulomb yields{{.density = 1000, .young = 1e7, .poisson = 0.1, .friction = 30_deg}};
  check(on_triangles(Numerics<LinearSimplex, Tpic, Usl>{}, rest), k0, 5e-4);
  check(on_triangles(Numerics<LinearSimplex, Tpic, Usl, NodalAveraging>{}, yields), 1.0 / 3, 1e-5);
  check(on_tetrahedra(Numerics<LinearSimplex, Tpic, Usl, NodalAveraging>{}, yields), 1.0 / 3, 1e-5);
}

TEST_CASE("Oedometer on B-splines: a platen given as a signed distance feels what the layer carries") {
  const double h = 0.02;
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.1, height + 0.1}, .cell = h}},
              Numerics<QuadraticBSpline, Flip>{.transfer = {.fraction = 0.98}},
              bodies(fill(Box{{0., 0.}, {0.1, height}}, soil(), {.per_cell = 4})),
              walls(left(roller), right(roller), bottom(roller)),
              rigids(rigid(DistanceSurface{[](const auto& x) { return height - x[1]; }}, pressing(),
                           Friction::frictionless()))};
  start_uniform(scene);
  run(scene, {.end = squeeze / speed, .courant = test::courant(scene, 0.5)});
  const auto& body = scene.body();
  double mean = 0, lateral = 0;
  for (const auto& s : body.points.stress) {
    mean += s[1] / static_cast<double>(body.points.size());
    lateral = std::max(lateral, std::abs(s[0] / s[1] - k0));
  }
  const double exact = body.law.wave_modulus() * std::log((height - squeeze) / height);
  CAPTURE(mean / exact, lateral);
  CHECK(lateral <= 1e-6);
  // Where the face acts is blurred: nodes within half a cell of it are stopped, so that it acts up to that
  // much early.
  CHECK(std::abs(mean / exact - 1) <= 0.1);
  CHECK(std::abs(scene.rigid().force[1] / (-mean * 0.1) - 1) <= 0.1);
}
