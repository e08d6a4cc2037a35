// The distance at which contact acts: between the surface of a block that falls and that of a rigid body or
// of another block, when the first node exchanges an impulse. It follows from where nodes lie and how far
// from a point they carry mass.
#include <algorithm>
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

constexpr double h = 0.025, speed = 2;

template <class Shape, int D>
struct Kind;
template <int D>
struct Kind<QuadraticBSpline, D> {
  static constexpr int per_cell = D == 2 ? 4 : 8;
  static constexpr double carries = 1.5 * h;  ///< how far from a point nodes carry mass
  /// The highest node at or below a height: they lie in the middle of cells.
  static double node_below(double y) { return h * (std::floor(y / h - 0.5 + 1e-9) + 0.5); }
  static auto mesh() {
    std::array<double, D> lower{}, upper;
    upper.fill(3 * h);
    upper[1] = 20 * h;
    return CartesianGrid<D>{{.lower = lower, .upper = upper, .cell = h}};
  }
};
template <int D>
struct Kind<LinearSimplex, D> {
  static constexpr int per_cell = D == 2 ? 6 : 10;
  static constexpr double carries = h;
  static double node_below(double y) { return h * std::floor(y / h + 1e-9); }
  static auto mesh() {
    if constexpr (D == 2)
      return SimplexMesh<2>(test::triangles({0, 0}, {3 * h, 20 * h}, 3, 20));
    else
      return SimplexMesh<3>(test::tetrahedra({0, 0, 0}, {3 * h, 20 * h, 3 * h}, {3, 20, 3}));
  }
};

template <std::size_t D>
Box<D> layer(double from, double to) {
  Box<D> box;
  box.lower.fill(0);
  box.upper.fill(3 * h);
  box.lower[1] = from;
  box.upper[1] = to;
  return box;
}

/// One block falls towards another, with the upper face of a rigid body at `rigid`.
template <class Shape, int D>
auto two_blocks(double other, double rigid_at, double reach) {
  using K = std::conditional_t<D == 2, PlaneStrain, ThreeDimensional>;
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.2}};
  constexpr int per_cell = Kind<Shape, D>::per_cell;
  return Scene{
      K{},
      Kind<Shape, D>::mesh(),
      Numerics<Shape, Flip, Usl>{},
      bodies(fill(layer<D>(11 * h, 13 * h), rubber, {.per_cell = per_cell, .velocity = {0, -speed, 0}}),
             fill(layer<D>(other - 2 * h, other), rubber, {.per_cell = per_cell})),
      walls(left(roller), right(roller)),
      Coulomb{Friction::frictionless()},
      rigid(DistanceSurface{[=](const auto& x) { return x[1] - rigid_at; }, reach},
            Prescribed{[](double) { return std::array<double, 3>{}; }}, Friction::frictionless())};
}

template <class Body>
std::array<double, 2> extent(const Body& body) {
  double low = 1e9, high = -1e9;
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    low = std::min(low, double(body.points.position[p][1]));
    high = std::max(high, double(body.points.position[p][1]));
  }
  return {low, high};
}

/// Steps until a node exchanges an impulse; returns the distance of the surfaces, in cells, and the exact
/// one.
template <class Scene>
double first_contact(Scene& scene, double surface, double inset) {
  double distance = 0;
  while (scene.contact_tally.nodes == 0) {
    distance = extent(scene.template body<0>())[0] - inset - surface;
    REQUIRE(distance > -h);
    step(scene, 0.01 * h / speed);
  }
  return distance / h;
}

template <class Shape, int D>
void measure(const std::string& name, test::Validation& table) {
  using Of = Kind<Shape, D>;
  std::array<std::vector<double>, 3> all, all_exact;
  for (const double part : {0.01, 0.12, 0.24, 0.49, 0.51, 0.76, 0.99}) {
    const double surface = (6 + part) * h;
    for (std::size_t which = 0; which < 3; ++which) {
      const double reach = which == 0 ? 0.5 : 0;
      // The surface that is not measured is out of the way; bodies fill whole cells.
      const bool is_rigid = which < 2;
      auto scene = two_blocks<Shape, D>(is_rigid ? 2 * h : 6 * h, is_rigid ? surface : -9 * h, reach);
      const double inset = extent(scene.template body<0>())[0] - 11 * h;
      double node = Of::node_below(surface + reach * scene.mesh.node_size(0)), at = surface;
      if (!is_rigid) {  // points that lie higher than those of whole cells
        auto& position = scene.template body<1>().points.position;
        for (std::size_t p = 0; p < position.size(); ++p)
          position.set(p, position[p] + part * h * Vec<double, D>::Unit(1));
        const double top = extent(scene.template body<1>())[1];
        node = Of::node_below(top + Of::carries);
        at = top + inset;
      }
      const double exact = (node + Of::carries - inset - at) / h;
      const double found = first_contact(scene, at, inset);
      CAPTURE(name, part, which, found, exact);
      CHECK(found <= exact + 1e-9);
      CHECK(found >= exact - 0.05);
      all[which].push_back(found);
      all_exact[which].push_back(exact);
    }
  }
  const std::array<std::string, 3> what{"rigid body; reach 0.5", "rigid body; reach 0", "Coulomb"};
  for (std::size_t k = 0; k < 3; ++k) {
    table.value(name + "; " + what[k], "least", "cells", std::ranges::min(all[k]),
                std::ranges::min(all_exact[k]));
    table.value(name + "; " + what[k], "greatest", "cells", std::ranges::max(all[k]),
                std::ranges::max(all_exact[k]));
  }
}

}  // namespace

TEST_CASE(
    "Contact acts as far from a surface as nodes carry mass: B-splines and simplices, plane and space") {
  test::Validation table("acting_distance");
  measure<QuadraticBSpline, 2>("B-splines; plane", table);
  measure<LinearSimplex, 2>("triangles", table);
  measure<QuadraticBSpline, 3>("B-splines; space", table);
  measure<LinearSimplex, 3>("tetrahedra", table);
}
