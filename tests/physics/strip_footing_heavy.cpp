// Strip footing on weightless Tresca soil: the bearing pressure (2 + pi) c (Prandtl 1920), smooth and rough,
// on three meshes.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>

#include "catch.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

constexpr double half_width = 0.5, strength = 20e3, width = 3, depth = 2;

/// Pushes the footing 4 mm into the soil, a fifteenth of the smallest cell; returns the mean pressure below
/// it over c. `carries`: width that carries the load, m.
template <class Numerics, class Mesh>
double bearing_pressure(const Mesh& mesh, bool is_rough, double carries) {
  const MohrCoulomb clay{
      {.density = 2000, .young = 1e4 * strength, .poisson = 0.3, .friction = 0, .cohesion = strength}};
  const auto below = [](const auto& x) { return x[0] <= half_width * (1 + 1e-9) && x[1] > depth - 1e-9; };
  const double speed = 0.01, end = 0.45;
  Scene scene{PlaneStrain{},
              Mesh(mesh),
              Numerics{},
              bodies(fill(Box{{0., 0.}, {width, depth}}, clay, {.per_cell = 4})),
              walls(left(roller), right(roller), bottom(fixed)),
              driven(named("footing", where(below, is_rough ? fixed : symmetry({0, 1, 0}))), {0, -speed, 0},
                     Ramp{.over = 0.2 * end}),
              LocalDamping{},
              Reactions{},
              TrackEnergy{}};
  run(scene, {.end = 0.9 * end, .courant = 0.9});
  const double before = reaction(scene, "footing").impulse[1];
  run(scene, {.end = end, .courant = 0.9});
  CHECK(std::abs(energies(scene).residual) < 0.01 * energies(scene).external);
  const double impulse = reaction(scene, "footing").impulse[1] - before;
  return -impulse / (0.1 * end) / carries / strength;
}

}  // namespace

TEST_CASE("Strip footing: the pressure goes to (2 + pi) c with the mesh") {
  const double exact = 2 + pi;
  test::Validation validation("strip_footing");
  const auto compare = [&](const std::string& composition, bool is_rough, double cell, double pressure) {
    validation.value(composition + (is_rough ? "; rough" : "; smooth"),
                     "pressure over c; cells of " + joined_text({cell}) + " m", "-", pressure, exact);
    return pressure / exact - 1;
  };
  for (const bool is_rough : {false, true}) {
    double triangles = 1, splines = 1;
    for (const Index n : {2u, 4u, 8u}) {  // cells below half of the footing
      const double cell = half_width / n;
      CAPTURE(is_rough, cell);
      const SimplexMesh<2> mesh(box_mesh<2>({{0, 0}, {width, depth}, {6 * n, 4 * n}}));
      // Of the last element half of the pressure acts beyond the last node.
      const double off = compare("triangles", is_rough, cell,
                                 bearing_pressure<Numerics<LinearSimplex, Flip, Musl, NodalAveraging>>(
                                     mesh, is_rough, half_width + cell / 2));
      CHECK(off > 0);
      CHECK(off < (is_rough ? 0.08 : 0.02));
      CHECK(off < 0.85 * triangles);
      triangles = off;
      const CartesianGrid<2> grid{{.lower = {0, 0}, .upper = {width, depth}, .cell = cell}};
      const double off_splines =
          compare("B-splines", is_rough, cell,
                  bearing_pressure<Numerics<QuadraticBSpline, Flip, Musl>>(grid, is_rough, half_width));
      CHECK(std::abs(off_splines) < 0.05);
      CHECK(std::abs(off_splines) < splines + 0.005);
      splines = std::abs(off_splines);
    }
  }
}
