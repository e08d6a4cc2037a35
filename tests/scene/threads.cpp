// The same input gives the same bits on any number of threads, for each family of compositions.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "state_buffer.hpp"

using namespace arenite;

namespace {

LinearElastic rubber() { return LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.3}}; }
MohrCoulomb<> sand(double dilatancy = 0) {
  return MohrCoulomb<>{
      {.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg, .dilatancy = dilatancy}};
}

template <class Make>
test::StateBuffer state_after(Make&& make, int threads) {
  set_threads(threads);
  auto scene = make();
  for (int k = 0; k < 20; ++k) step(scene, 0.4 * stable_step(scene));
  return test::StateBuffer(scene);
}

template <class Make>
void check(Make&& make) {
  const int before = threads();
  const auto one = state_after(make, 1);
  for (const int n : {2, 3, 7}) {
    CAPTURE(n);
    CHECK(test::StateBuffer::first_difference(state_after(make, n), one) == "");
  }
  set_threads(before);
}

const FillOptions falls{.per_cell = 4, .velocity = {0.5, -3, 0}};
CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {2, 1}, .cell = 0.05}}; }

}  // namespace

TEST_CASE("Same bits: B-splines, APIC, sand, energy") {
  check([] {
    return Scene{PlaneStrain{},
                 grid(),
                 Numerics<QuadraticBSpline, Apic>{},
                 bodies(fill(Box{{0., 0.}, {1., 0.8}}, sand(), falls)),
                 walls(bottom(fixed), left(roller)),
                 gravity({0, -9.81}),
                 TrackEnergy{}};
  });
}

TEMPLATE_TEST_CASE("Same bits: linear functions and cubic B-splines, whose blocks have one layer and three",
                   "", LinearGrid, CubicBSpline) {
  check([] {
    return Scene{PlaneStrain{},
                 grid(),
                 Numerics<TestType, Flip, Usl>{},
                 bodies(fill(Box{{0., 0.}, {1., 0.8}}, sand(), falls)),
                 walls(bottom(fixed), left(roller)),
                 gravity({0, -9.81})};
  });
}

TEST_CASE("Same bits: B-splines, FLIP, two bodies in contact, a rigid body") {
  check([] {
    return Scene{
        PlaneStrain{},
        grid(),
        Numerics<QuadraticBSpline, Flip, Usl>{},
        bodies(fill(Box{{0.5, 0.5}, {1., 0.8}}, rubber(), falls), fill(Box{{0., 0.}, {2., 0.5}}, rubber())),
        walls(bottom(fixed)),
        gravity({0, -9.81}),
        Coulomb{Friction(10_deg)},
        rigids(rigid(DistanceSurface{[](const auto& x) { return std::hypot(x[0] - 1.5, x[1] - 0.7) - 0.2; }},
                     Guided{.mass = 50, .velocity = -2}, Friction(20_deg)))};
  });
}

TEST_CASE("Same bits: triangles, FLIP, MUSL, both averages, dilatancy, a moving mesh, a rigid body") {
  check([] {
    auto data = test::triangles({0, 0}, {1, 1}, 30, 30);
    test::name_region(data, "block", [](const auto& x) { return x[0] < 0.3 && x[1] > 0.5; });
    test::name_region(data, "soil", [](const auto& x) { return x[1] < 0.5; });
    return Scene{Axisymmetric{},
                 SimplexMesh<2>(data),
                 Numerics<LinearSimplex, Flip, Musl, NodalAndElementAverage>{},
                 bodies(fill(Cells("soil"), sand(15_deg),
                             {.per_cell = 3, .stress = Geostatic{.surface = 0.5, .k0 = 0.5}})),
                 walls(on("bottom", fixed), on("right", symmetry({1, 0, 0}))),
                 gravity({0, -9.81}),
                 rigids(rigid(MeshSurface{"block"}, Guided{.mass = 100, .velocity = -5}, Friction(20_deg))),
                 MovingMesh<>{.fixed_below = 0.1, .moving_from = 0.5},
                 TrackEnergy{}};
  });
}

TEST_CASE("Same bits: tetrahedra, TPIC, element average") {
  check([] {
    return Scene{
        ThreeDimensional{}, SimplexMesh<3>(test::tetrahedra({0, 0, 0}, {1, 1, 1}, {6, 6, 6})),
        Numerics<LinearSimplex, Tpic, Usl, ElementAverage>{},
        bodies(fill(Box{{0., 0., 0.}, {1., 1., 0.5}}, rubber(), {.per_cell = 4, .velocity = {0, -0.5, 0.1}})),
        walls(bottom(fixed))};
  });
}

TEST_CASE("Same bits: triangles, FLIP, MUSL, elastic bodies in contact, energy") {
  check([] {
    return Scene{
        PlaneStrain{},
        SimplexMesh<2>(test::triangles({0, 0}, {1, 1}, 30, 30)),
        Numerics<LinearSimplex, Flip, Musl>{},
        bodies(fill(Box{{0.2, 0.42}, {0.8, 0.8}}, rubber(), {.per_cell = 3, .velocity = {0.5, -3, 0}}),
               fill(Box{{0., 0.}, {1., 0.4}}, rubber(), {.per_cell = 3})),
        walls(bottom(fixed)),
        gravity({0, -9.81}),
        Coulomb{Friction(10_deg)},
        TrackEnergy{}};
  });
}
