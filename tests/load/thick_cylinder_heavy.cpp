// Thick-walled cylinder under inner pressure, axisymmetric, at rest: Lame's stresses and displacements, and
// the order in which the error falls with the mesh.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>

#include "catch.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

constexpr double inner = 1, outer = 2, pressed = 10;
LinearElastic metal() { return LinearElastic{{.density = 2000, .young = 1e8, .poisson = 0.25}}; }

/// Radial and hoop stress, Pa, and radial displacement, m, at a radius, without strain along the axis (Lame
/// 1852).
struct Lame {
  double radial, hoop, moved;
};
Lame lame(double r) {
  const double a2 = inner * inner, b2 = outer * outer, scale = pressed * a2 / (b2 - a2);
  const auto e = metal().elasticity();
  return {scale * (1 - b2 / (r * r)), scale * (1 + b2 / (r * r)),
          scale / (2 * e.shear()) * ((1 - 2 * e.poisson()) * r + b2 / r)};
}

struct Errors {
  double stress, displacement;  // root mean squares over the pressure, and over the displacement of the bore
};

template <class Numerics, class Mesh>
Errors errors(const Mesh& mesh, double cell, test::Validation* validation, const std::string& name) {
  Scene scene{Axisymmetric{},
              Mesh(mesh),
              Numerics{},
              bodies(fill(Box{{inner, 0.}, {outer, 2 * cell}}, metal(), {.per_cell = 4})),
              walls(bottom(roller), top(roller)),
              pressure(left(), pressed),
              LocalDamping{}};
  const auto start = scene.body().points.position;
  settle(scene, {.ratio = 1e-7, .end = 2});
  const auto& points = scene.body().points;
  Errors sum{0, 0};
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Lame exact = lame(start[p][0]);
    const auto& s = points.stress[p];
    const double moved = points.position[p][0] - start[p][0];
    sum.stress += (std::pow(s[0] - exact.radial, 2) + std::pow(s[2] - exact.hoop, 2)) / 2;
    sum.displacement += std::pow(moved - exact.moved, 2);
    if (validation) {
      validation->point(name + "; radial stress", "radius (m)", start[p][0], "stress (Pa)", s[0],
                        exact.radial);
      validation->point(name + "; hoop stress", "radius (m)", start[p][0], "stress (Pa)", s[2], exact.hoop);
    }
  }
  const auto n = static_cast<double>(points.size());
  return {std::sqrt(sum.stress / n) / pressed, std::sqrt(sum.displacement / n) / lame(inner).moved};
}

}  // namespace

TEST_CASE("Thick cylinder under inner pressure: Lame's stresses, with their order") {
  test::Validation validation("thick_cylinder");
  const auto study = [&](const std::string& name, double stress_order, auto&& compute) {
    Errors before{};
    for (const Index n : {8u, 16u, 32u}) {
      const Errors e = compute(n, n == 16 ? &validation : nullptr, name);
      const std::string cells = "; " + std::to_string(n) + " cells";
      validation.value(name, "error of the stresses over the pressure" + cells, "-", e.stress, 0);
      validation.value(name, "error of the displacement over that of the bore" + cells, "-", e.displacement,
                       0);
      if (n > 8) {
        const double of_stress = std::log2(before.stress / e.stress),
                     of_displacement = std::log2(before.displacement / e.displacement);
        CAPTURE(name, n, of_stress, of_displacement);
        CHECK(of_stress > stress_order - 0.2);
        CHECK(of_displacement > 1.8);
        validation.value(name, "order of the stresses" + cells, "-", of_stress, stress_order);
        validation.value(name, "order of the displacement" + cells, "-", of_displacement, 2);
      }
      before = e;
    }
  };
  study("B-splines", 1.5, [](Index n, auto* v, const std::string& name) {
    const double cell = 1.0 / n;
    return errors<Numerics<QuadraticBSpline, Flip, Musl>>(
        CartesianGrid<2>{{.lower = {inner, 0}, .upper = {outer, 2 * cell}, .cell = cell}}, cell, v, name);
  });
  study("triangles", 1, [](Index n, auto* v, const std::string& name) {
    const double cell = 1.0 / n;
    return errors<Numerics<LinearSimplex, Flip, Musl>>(
        SimplexMesh<2>(box_mesh<2>({{inner, 0}, {outer, 2 * cell}, {n, 2}})), cell, v, name);
  });
}
