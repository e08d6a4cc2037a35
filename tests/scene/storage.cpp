// A scene neither stores nor computes what it does not use.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

LinearElastic rubber() { return LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.3}}; }
MohrCoulomb<> sand() {
  return MohrCoulomb<>{{.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg}};
}
CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}}; }
SimplexMesh<2> triangles() { return SimplexMesh<2>(test::triangles({0, 0}, {1, 1}, 4, 4)); }

const Box lower_half{{0., 0.}, {1., 0.5}};
const FillOptions three{.per_cell = 3};
const Box upper_half{{0., 0.5}, {1., 1.}};

template <class Scene>
std::size_t stored_bytes_per_point(const Scene& scene) {
  std::size_t bytes = 0;
  const auto& points = scene.body().points;
  points.for_each_column([&](const auto& column) {
    REQUIRE(column.size() == points.size());
    bytes += sizeof(column[0]);
  });
  return bytes;
}

}  // namespace

TEST_CASE(
    "One body without contact has one node field; bodies that stick share it; contact gives each its own") {
  const Scene one{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Apic, Usl>{},
                  bodies(fill(lower_half, sand()))};
  CHECK(one.fields.size() == 1);
  const Scene stick{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Apic, Usl>{},
                    bodies(fill(lower_half, sand()), fill(upper_half, rubber()))};
  CHECK(stick.fields.size() == 1);
  const Scene touch{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Apic, Usl>{},
                    bodies(fill(lower_half, sand()), fill(upper_half, rubber())), Coulomb{Friction(0.1)}};
  CHECK(touch.fields.size() == 2);
  CHECK(touch.fields[0].mass_gradient.size() == touch.fields[0].size());
  CHECK(one.fields[0].mass_gradient.empty());
}

TEST_CASE("USL stores no mapped velocities, MUSL one a node; TPIC on simplices has none to map") {
  Scene usl{PlaneStrain{}, triangles(), Numerics<LinearSimplex, Flip, Usl>{},
            bodies(fill(lower_half, sand(), {.per_cell = 3}))};
  Scene musl{PlaneStrain{}, triangles(), Numerics<LinearSimplex, Flip, Musl>{},
             bodies(fill(lower_half, sand(), {.per_cell = 3}))};
  const Scene tpic{PlaneStrain{}, triangles(), Numerics<LinearSimplex, Tpic, Musl>{},
                   bodies(fill(lower_half, sand(), {.per_cell = 3}))};
  CHECK(tpic.fields[0].mapped.empty());
  step(usl, 1e-6);
  step(musl, 1e-6);
  CHECK(usl.body().cell_sums.empty());
  CHECK(musl.body().cell_sums.size() == musl.mesh.cell_count());
  CHECK(usl.fields[0].mapped.empty());
  CHECK(musl.fields[0].mapped.size() == musl.mesh.node_count());
  const std::size_t node = (8 + 1 + 2 * 2) * sizeof(double);  // collected; mass; start, velocity
  CHECK(usl.fields[0].bytes() == usl.mesh.node_count() * node);
  CHECK(musl.fields[0].bytes() == usl.fields[0].bytes() + musl.mesh.node_count() * 2 * sizeof(double));
}

TEST_CASE("Bytes a point: no history without memory, no affine motion with FLIP") {
  // Position, velocity, mass, volume, stress (4), cell.
  const std::size_t plain = (2 + 2 + 1 + 1 + 4) * sizeof(double) + sizeof(Index);
  const Scene elastic{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Flip>{},
                      bodies(fill(lower_half, rubber()))};
  CHECK(stored_bytes_per_point(elastic) == plain);
  const Scene affine{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Apic>{},
                     bodies(fill(lower_half, rubber()))};
  CHECK(stored_bytes_per_point(affine) == plain + 4 * sizeof(double));
  const Scene remembers{
      PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Flip>{},
      bodies(fill(lower_half, WithDeviatoricStrain{MohrCoulomb<RemembersOpening>{
                                  {.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg}}}))};
  // The opening, and the deviator of the strain.
  CHECK(stored_bytes_per_point(remembers) == plain + 6 * sizeof(double));
  const Scene solid{ThreeDimensional{}, SimplexMesh<3>(test::tetrahedra({0, 0, 0}, {1, 1, 1}, {1, 1, 1})),
                    Numerics<LinearSimplex, Flip>{}, bodies(fill(Cells("all"), rubber(), {.per_cell = 1}))};
  CHECK(stored_bytes_per_point(solid) == (3 + 3 + 1 + 1 + 6) * sizeof(double) + sizeof(Index));
}

TEST_CASE(
    "Energy balance, contact impulses, normals, averages and motion take no room where they are not used") {
  const Scene plain{PlaneStrain{}, triangles(), Numerics<LinearSimplex, Flip, Usl>{},
                    bodies(fill(lower_half, sand(), three))};
  const Scene tracked{PlaneStrain{}, triangles(), Numerics<LinearSimplex, Flip, Usl>{},
                      bodies(fill(lower_half, sand(), three)), TrackEnergy{}};
  const Scene averaged{PlaneStrain{}, triangles(), Numerics<LinearSimplex, Flip, Usl, NodalAveraging>{},
                       bodies(fill(lower_half, sand(), three))};
  const Scene moving{PlaneStrain{}, triangles(), Numerics<LinearSimplex, Flip, Usl>{},
                     bodies(fill(lower_half, sand(), three)),
                     MovingMesh<LedByBody<0>>{.fixed_below = 0, .moving_from = 0.8}};
  using Plain = std::remove_const_t<decltype(plain)>;
  STATIC_REQUIRE(Plain::part_count == 0);
  STATIC_REQUIRE(std::is_empty_v<decltype(Plain::drives)>);
  STATIC_REQUIRE(std::is_empty_v<decltype(Plain::average)>);
  STATIC_REQUIRE(sizeof(tracked) >= sizeof(plain) + sizeof(TrackEnergy));
  STATIC_REQUIRE(sizeof(averaged) >= sizeof(plain) + 2 * sizeof(std::vector<double>));
  STATIC_REQUIRE(sizeof(moving) > sizeof(plain));
}
