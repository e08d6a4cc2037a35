// Contact of a rigid body with the node fields of a scene: the body gains the momentum that the matter loses
// in a step.
#pragma once

#include <algorithm>
#include <type_traits>

#include <arenite/contact/hold.hpp>
#include <arenite/core/alone.hpp>
#include <arenite/core/contact_tally.hpp>
#include <arenite/rigid/pose.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

template <class Shape, class M, class R, class Fields, class Owns>
void find_touched_nodes(const M& mesh, R& body, const Fields& fields, const Owns& owns) {
  using T = typename M::scalar;
  body.touched_nodes.clear();
  body.inside_nodes = 0;
  const auto has_mass = [&](Index node) {
    return std::ranges::any_of(fields, [&](const auto& field) { return field.mass[node] > 0; });
  };
  body.surface.template visit<Shape>(
      mesh, body.place(), has_mass,
      [&](Index node, const auto& normal, bool inside, [[maybe_unused]] T fraction) {
        if (!owns(node)) return;
        for (std::size_t f = 0; f < fields.size(); ++f) {
          const T mass = fields[f].mass[node];
          if (!(mass > 0)) continue;
          T moved = 1;
          if constexpr (R::coupling_through_centre) {
            const T rigid_mass = fraction * static_cast<T>(body.motion.mass);
            if (!inside) moved = rigid_mass / (rigid_mass + mass);
          }
          body.touched_nodes.push_back({f, node, inside, mass, moved, fields[f].velocity[node], normal});
          if constexpr (R::rotates)
            body.touched_nodes.back().arm = Shape::node_position(mesh, node) - body.position();
          body.inside_nodes += inside;
        }
      });
}

}  // namespace detail

/// Advances the body by dt to `time` and lets it exchange impulses with all fields: its own motion first,
/// then the impulses with its new velocity. Returns what contact dissipated. Each scene that shares the body
/// touches the nodes that it owns; sums are taken through `others`, and all know of the whole body.
template <class Shape, class M, class R, class Fields, class T, int D, class Owns = OwnsAll,
          class Others = const Alone>
ContactTally collide(const M& mesh, R& body, Fields& fields, const Vec<T, D>& acceleration, T time, T dt,
                     const Owns& owns = {}, Others& others = no_others) {
  detail::find_touched_nodes<Shape>(mesh, body, fields, owns);
  using Velocity = typename R::Velocity;
  const Velocity before = body.whole_velocity(), free_velocity = [&]() -> Velocity {
    if constexpr (R::rotates)
      return body.motion.free_velocity(body, before, acceleration, time, dt);
    else
      return body.motion.free_velocity(before, acceleration, time, dt);
  }();
  Velocity met;  // with which impulses are found
  if constexpr (requires { body.motion.velocity_in_contact(body, free_velocity, others); }) {
    met = body.motion.velocity_in_contact(body, free_velocity, others);
  } else {
    static_assert(Others::alone || !R::is_free,
                  "Rigid: meet of this motion must take the others to sum with");
    met = body.motion.velocity_in_contact(body, free_velocity);
  }
  Velocity total = Velocity::Zero();  // on the fields
  T gained = 0;                       // by the fields: impulses times their mean velocities over the step
  auto exchanged = R::no_size();      // magnitudes of the impulses
  body.contact_nodes = 0;
  for (auto& t : body.touched_nodes) {
    const auto given = body.contact_at(t, met);
    const Vec<T, D>& j = given.impulse;
    if (j.squaredNorm() == 0) continue;
    t.impulse = j;
    t.sticks = given.sticks;
    Vec<T, D>& v = fields[t.field].velocity[t.node];
    v += j / t.mass;
    total += body.with_moment(t, j);
    exchanged += body.size_of(t, j);
    gained += j.dot(fields[t.field].start[t.node] + v) / 2;
    ++body.contact_nodes;
  }
  sum_over(others, total, gained, exchanged, body.contact_nodes, body.inside_nodes);
  body.take_impulse(total, dt);
  const Velocity after = body.motion.after(met, free_velocity, total, exchanged);
  const Velocity mean = body.motion.mean(before, after);
  const double dissipation = static_cast<double>(total.dot(mean) - gained);
  body.dissipated += dissipation;
  body.driving_work += body.motion.drive(before, free_velocity, mean, total);
  body.move(after, dt);
  return {.dissipation = dissipation, .nodes = body.contact_nodes};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
