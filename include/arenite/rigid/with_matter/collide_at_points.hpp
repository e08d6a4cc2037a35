// Contact of a rigid body with the material points of a scene (`PointContact`): the body gains the momentum
// that the matter loses in a step.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <optional>

#include <arenite/part/contact_tally.hpp>
#include <arenite/rigid/with_matter/collide.hpp>
#include <arenite/rigid/with_matter/point_contact.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The points of all bodies that the rigid body touches, or may within a step, where it is now.
template <class Scene, class R>
void find_touched_points(Scene& scene, R& body) {
  using Cell = typename Scene::Shape::template Cell<typename Scene::Mesh>;
  using V = Vec<double, Scene::D>;
  auto& found = body.at_points;
  found.clear(scene.fields.size(), scene.fields[0].size());
  std::size_t number = 0;
  scene.for_each_body([&](const auto& matter, const auto& field) {
    std::optional<Cell> cell;
    Index of = none;  // `cell`
    body.surface.visit_points(
        scene.mesh, body.place(), matter, PointContact::margin, [&](Index p, const auto& normal, double gap) {
          if (normal.squaredNorm() == 0) return;  // no way out
          if (const Index c = matter.points.cell[p]; c != of) cell.emplace(scene.mesh, of = c);
          const auto x = matter.points.position[p];
          V arm = V::Zero();
          if constexpr (R::rotates) arm = (x - body.position()).template cast<double>();
          found.add({number, p, gap, normal}, Scene::field_of(number), field, *cell, cell->weights(x), arm);
        });
    ++number;
  });
}

/// Gives the fields the impulses that were found, with which the body moves at velocity `contact_velocity`.
template <class R, class Fields>
ContactImpulses<R> apply_point_impulses(R& body, Fields& fields) {
  using T = typename R::V::Scalar;
  ContactImpulses<R> impulses;
  body.touched_nodes.clear();
  body.contact_nodes = body.inside_nodes = 0;
  for (const auto& n : body.at_points.nodes()) {
    if (n.impulse.squaredNorm() == 0) continue;
    auto& field = fields[n.field];
    auto& v = field.velocity[n.node];
    const typename R::V j = n.impulse.template cast<T>(), before = v;
    v += j / field.mass[n.node];
    // Constraints that then remove a part of it do no work.
    const typename R::V after = n.velocity.template cast<T>();
    impulses.gained += j.dot(field.start[n.node] + after) / 2;
    body.touched_nodes.push_back(
        {n.field, n.node, false, field.mass[n.node], 1, before, R::V::Zero(), false, j, after});
    ++body.contact_nodes;
  }
  for (std::size_t k = 0; k < body.at_points.points.size(); ++k) {
    impulses.add(body.at_points.points[k].impulse, body.at_points.arm(k).template cast<T>());
  }
  return impulses;
}

/// Advances the body by dt, s, and lets it exchange impulses with the points of a scene. Returns what contact
/// dissipated.
template <class Scene, class R>
ContactTally collide_at_points(Scene& scene, R& body, double dt) {
  using T = typename R::V::Scalar;
  using Velocity = typename R::Velocity;
  constexpr int N = Velocity::RowsAtCompileTime;
  find_touched_points(scene, body);
  const Velocity free =
      free_velocity(body, scene.acceleration(), static_cast<T>(scene.time + dt), static_cast<T>(dt));
  const Mat<double, N> mobility = mobility_of(body, Mat<double, N>(Mat<double, N>::Zero()));
  const Velocity contact_velocity =
      body.at_points.solve(free.template cast<double>(), mobility, scene.constraints, body.friction, dt)
          .template cast<T>();
  const auto impulses = apply_point_impulses(body, scene.fields);
  const double dissipation = finish_step(body, free, free, Velocity(Velocity::Zero()), contact_velocity,
                                         impulses, static_cast<T>(dt))
                                 .first;
  return {.dissipation = dissipation, .nodes = body.contact_nodes};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
