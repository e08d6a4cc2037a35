// The drop in space: a penetrometer that moves and turns as it will, on a grid that goes down with it.
#pragma once

#include "model_grid.hpp"

namespace arenite::ffp {

/// One half of penetrometer and chamber: the tilt is about z, and z = 0 a plane of symmetry. The chamber is a
/// square of the experiment's width.
struct SpaceModel {
  using Kinematics = ThreeDimensional;
  static constexpr double whole = 2;

  static RectilinearGrid<3> mesh(const DropOptions& o) {
    const auto section = grid_lines(o.body(), o.chamber(), o.mesh_sizes());
    RectilinearGrid<3>::Parameters lines{.x = {}, .y = section.y, .z = section.x};
    for (std::size_t k = section.x.size(); k-- > 1;) lines.x.push_back(-section.x[k]);
    lines.x.insert(lines.x.end(), section.x.begin(), section.x.end());
    return RectilinearGrid<3>{lines};
  }
  static Box<3> sand(const DropOptions& o) {
    const Chamber chamber = o.chamber();
    return {{-chamber.radius, -chamber.soil_depth, 0}, {chamber.radius, 0, chamber.radius}};
  }
};

/// The penetrometer of one half, free in the plane of symmetry.
inline Free free_device(const DropOptions& o) {
  const DeviceStart start = o.start();
  const Vec<double, 3> centre = start.tip + o.centre_height() * start.axis();
  const double mass = o.device_mass() / SpaceModel::whole;
  return {.mass = mass,
          .inertia = mass * o.gyration_radius() * o.gyration_radius(),  // only that about z counts
          .centre = {centre[0], centre[1], 0},
          .velocity = {0, -o.velocity, 0},
          .symmetry = 2};
}

/// A rigid penetrometer on quadratic B-splines, in the whole grid or a part of it; `more` are parts before the last.
template <class Mesh, class... More>
auto space_scene_in(Mesh mesh, const DropOptions& o, const More&... more) {
  return Scene{
      SpaceModel::Kinematics{},
      std::move(mesh),
      Numerics<QuadraticBSpline, Flip, Usl>{.transfer = transfer_of(o)},
      bodies(soil_of<3>(o, SpaceModel::sand(o), sand_on_grid(o))),
      walls(bottom(fixed), left(free_along(1)), right(free_along(1)), back(free_along(1)), front(roller)),
      gravity({0, -standard_gravity, 0}),
      rigids(rigid<"device">(
          DistanceSurface{placed(TurnedSection{whole_section(o.body())}, o.start().placement()), 0.5},
          free_device(o), friction_of(o), RigidVelocity{})),
      motion_of_grid(o),
      more...,
      TrackEnergy{}};
}

}  // namespace arenite::ffp
