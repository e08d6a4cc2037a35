// Total forces of loads on faces and on points, in all kinematics, against the areas of boxes and cylinders.
// Each scene makes one step, so short that nothing moves: a load acts where nodes have matter.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>

#include "catch.hpp"

using namespace arenite;

namespace {

const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
constexpr double inner = 0.5, outer = 1.5, high = 1;  // m
constexpr double circle = 2 * pi;

/// Force of the load, N, its number among the parts being `K`.
template <std::size_t K = 0, class Scene>
auto force(Scene scene) {
  step(scene, 1e-12);
  return std::get<K>(scene.parts).force();
}
auto ring(const MeshFaces& where, const ScalarFunction& p) {
  return Scene{Axisymmetric{}, SimplexMesh<2>(box_mesh<2>({{inner, 0}, {outer, high}, {3, 2}})),
               Numerics<LinearSimplex, Tpic, Usl>{}, bodies(fill(Cells("all"), rubber)), pressure(where, p)};
}
auto ring_on_grid(const MeshFaces& where, const ScalarFunction& p) {
  return Scene{Axisymmetric{}, CartesianGrid<2>{{.lower = {inner, 0}, .upper = {outer, high}, .cell = 0.1}},
               Numerics<QuadraticBSpline, Apic, Usl>{}, bodies(fill(Box{{inner, 0.}, {outer, high}}, rubber)),
               pressure(where, p)};
}
auto brick(const MeshFaces& where, const VectorFunction& t) {
  return Scene{ThreeDimensional{}, SimplexMesh<3>(box_mesh<3>({{0, 0, 0}, {1, 2, 3}, {2, 1, 2}})),
               Numerics<LinearSimplex, Tpic, Usl>{}, bodies(fill(Cells("all"), rubber)), traction(where, t)};
}
auto brick_on_grid(const MeshFaces& where, const VectorFunction& t) {
  return Scene{ThreeDimensional{},
               CartesianGrid<3, float>{{.lower = {0, 0, 0}, .upper = {1, 2, 3}, .cell = 0.5}},
               Numerics<QuadraticBSpline, Apic, Usl>{},
               bodies(fill<"low">(Box{{0., 0., 0.}, {1., 2., 1.5}}, rubber, {.per_cell = 8}),
                      fill<"high">(Box{{0., 0., 1.5}, {1., 2., 3.}}, rubber, {.per_cell = 8})),
               traction(where, t),
               Coulomb{Friction(0.1)}};
}

}  // namespace

TEST_CASE("Pressure on a hollow cylinder: areas of the full circle, outward normals") {
  const auto check = [](auto make, double exact) {
    const double ends = pi * (outer * outer - inner * inner);
    CHECK((force(make(top(), 2)) - Vec<double, 2>(0, -2 * ends)).norm() <= exact);
    CHECK((force(make(bottom(), 2)) - Vec<double, 2>(0, 2 * ends)).norm() <= exact);
    CHECK((force(make(right(), 3)) - Vec<double, 2>(-3 * circle * outer * high, 0)).norm() <= exact);
    CHECK((force(make(left(), 3)) - Vec<double, 2>(3 * circle * inner * high, 0)).norm() <= exact);
  };
  check(ring, 1e-12);
  check(ring_on_grid, 1e-12);
  // A pressure that grows with r: the integral of 2 pi r r.
  const auto grows = [](const Triple& x, double) { return x[0]; };
  const double exact = -circle * (std::pow(outer, 3) - std::pow(inner, 3)) / 3;
  CHECK(std::abs(force(ring(top(), grows))[1] - exact) <= 1e-12);
  CHECK(std::abs(force(ring_on_grid(top(), grows))[1] / exact - 1) <= 1e-3);  // where the points are
  // Part of a side: faces whose corners pass a test.
  const auto upper_half = where([](const Triple& x) { return x[0] == outer && x[1] >= 0.5; });
  CHECK(std::abs(force(ring(upper_half, 3))[0] + 3 * circle * outer * high / 2) <= 1e-12);
  CHECK(std::abs(force(ring(on("right"), 3))[0] + 3 * circle * outer * high) <= 1e-12);
}

TEST_CASE("Traction on a brick, uniform and linear in the position; float; a field for each of two bodies") {
  const Vec<double, 3> t(1, -2, 3);
  CHECK((force(brick(front(), {1, -2, 3})) - 2 * t).norm() <= 1e-12);
  CHECK((force(brick(right(), {1, -2, 3})) - 6 * t).norm() <= 1e-12);
  const auto linear = [](const Triple& x, double) { return Triple{x[1], x[2], 1}; };
  CHECK((force(brick(left(), linear)) - Vec<double, 3>(6, 9, 6)).norm() <= 1e-12);
  CHECK((force(brick_on_grid(right(), {1, -2, 3})).cast<double>() - 6 * t).norm() <= 1e-5);
  CHECK((force(brick_on_grid(left(), linear)).cast<double>() - Vec<double, 3>(6, 9, 6)).norm() <= 1e-5);
}

TEST_CASE("Areas of a layer of points sum to that of the surface; a point load is whole") {
  const double layer = 0.05;
  Scene scene{Axisymmetric{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {2, 2}, .cell = 0.1}},
              Numerics<QuadraticBSpline, Apic, Usl>{},
              bodies(fill(Box{{inner, 0.}, {outer, high}}, rubber, {.per_cell = 4})),
              pressure(surface(Box{{0., high - layer}, {2., 2.}}, {.normal = {0, 3}, .thickness = layer}), 2),
              point_load({1, 0.5}, {3, -4})};
  const Vec<double, 2> exact(0, -2 * pi * (outer * outer - inner * inner));
  CHECK((force(scene) - exact).norm() <= 1e-12);
  CHECK((force<1>(scene) - Vec<double, 2>(3, -4)).norm() <= 1e-12);
}
