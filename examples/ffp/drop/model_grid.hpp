// The drop on a grid that moves with the penetrometer: a second discretisation, beside the fitted mesh.
#pragma once

#include "../geometry/mesh_grid.hpp"
#include "../geometry/tilted.hpp"
#include "model.hpp"

namespace arenite::ffp {

/// The half-section on a grid.
struct GridModel {
  using Kinematics = Axisymmetric;
  static constexpr double whole = 1;
};

/// The sand, by one type for all laws: Mohr-Coulomb is the law with a rate term of 0 s.
inline auto sand_on_grid(DropOptions o) {
  if (o.law.kind == LawKind::mohr_coulomb) {
    o.law.kind = LawKind::linear_rate;
    o.law.rate_time = o.law.rate_smoothing = 0;
  }
  return sand_with_law(o);
}

/// The grid goes down with the penetrometer.
inline MovingMesh<LedByRigid<"device">> motion_of_grid(const DropOptions& o) {
  return {.leader = {}, .fixed_below = -o.chamber().soil_depth, .moving_from = -o.moving_zone()};
}

/// A rigid penetrometer on quadratic B-splines; `Coupling`: its contact with the sand. USL: with pure FLIP
/// and velocities that are mapped back, grid and points drift apart.
template <class Coupling>
auto grid_scene(const DropOptions& o) {
  const Chamber chamber = o.chamber();
  return Scene{GridModel::Kinematics{},
               RectilinearGrid<2>{grid_lines(o.body(), chamber, o.mesh_sizes())},
               Numerics<QuadraticBSpline, Flip, Usl>{.transfer = transfer_of(o)},
               bodies(soil_of<2>(o, Box{{0., -chamber.soil_depth}, {chamber.radius, 0.}}, sand_on_grid(o))),
               walls(bottom(fixed), right(free_along(1))),
               gravity({0, -standard_gravity}),
               rigids(rigid<"device">(DistanceSurface{whole_section(o.body()), 0.5},
                                      Guided{.mass = o.device_mass(), .velocity = -o.velocity},
                                      friction_of(o), Coupling{})),
               motion_of_grid(o),
               splitting_of(o),
               TrackEnergy{}};
}

}  // namespace arenite::ffp
