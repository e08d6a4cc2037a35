// A bar that is loaded at one end, on a grid and on triangles: what the tests of loads share.
#pragma once

#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>

namespace arenite::test {

/// From 0 to 1 over the interval [0, 1], its first two derivatives zero at both ends.
inline double smooth_step(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10 - 15 * s + 6 * s * s);
}

// --- the bar: x in (0, 1) m, loaded at x = 1 m; rollers on its sides leave only the axial strain

constexpr double load = 10;  // Pa
const LinearElastic steel{{.density = 1000, .young = 1e7, .poisson = 0.25}};
const double speed = std::sqrt(steel.wave_modulus() / steel.density());

constexpr Index cells = 200;
constexpr double h = 1.0 / cells;

const Numerics<QuadraticBSpline, Apic, Usl> apic{};
auto bar_on_grid(const auto& traction) {
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, h}, .cell = h}},
               apic,
               bodies(fill(Box{{0., 0.}, {1., h}}, steel, {.per_cell = 4})),
               walls(left(roller), bottom(roller), top(roller)),
               traction,
               TrackEnergy{}};
}
template <class... Parts>
auto on_triangles(const BoxMesh<2>& box, const LinearElastic& law, const Walls& held, const Parts&... parts) {
  return Scene{PlaneStrain{},
               SimplexMesh<2>(box_mesh<2>(box)),
               Numerics<LinearSimplex, Tpic, Usl>{},
               bodies(fill(Cells("all"), law, {.per_cell = 6})),
               held,
               parts...,
               Reactions{},
               TrackEnergy{}};
}
const BoxMesh<2> bar{{0, 0}, {1, h}, {cells, 1}};
const Walls guided = walls(left(roller), bottom(roller), top(roller));
inline auto bar_on_triangles(const FaceTraction& traction, VectorFunction force = {0, 0}) {
  return on_triangles(bar, steel, guided, traction, gravity({0, 0}, Ramp{.over = 1}), body_force(force));
}
template <class Region>
auto bar_on_triangles(const PointTraction<Region>& traction) {
  return on_triangles(bar, steel, guided, traction);
}
/// On the points of the last layer: half a cell, or the cells of a row.
auto on_points(double thickness, auto in_time) {
  return traction(surface(Box{{1 - thickness, 0.}, {1., 1.}}, {.normal = {1, 0}, .thickness = thickness}),
                  {-load, 0}, in_time);
}

}  // namespace arenite::test
