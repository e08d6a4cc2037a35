// Contact of a rigid body with the node fields of a scene: the body gains the momentum that the matter loses
// in a step.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/contact/hold.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/part/contact_tally.hpp>
#include <arenite/rigid/body/pose.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The nodes with matter that the body touches where it is now, with the fields' velocities before contact,
/// for a step of dt, s.
template <class Shape, class M, class R, class Fields, class Owns>
void find_touched_nodes(const M& mesh, R& body, const Fields& fields, [[maybe_unused]] typename M::scalar dt,
                        const Owns& owns) {
  using T = typename M::scalar;
  body.touched_nodes.clear();
  body.inside_nodes = 0;
  const auto has_mass = [&](Index node) {
    for (const auto& field : fields)
      if (field.mass[node] > 0) return true;
    return false;
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
          static_assert(!(R::limits_shear && R::rotates),
                        "Rigid: a surface with shear_limit needs a motion without rotation");
          if constexpr (R::limits_shear)
            body.touched_nodes.back().most_shear = dt * body.surface.shear_limit(node);
          if constexpr (R::rotates)
            body.touched_nodes.back().arm = Shape::node_position(mesh, node) - body.position();
          body.inside_nodes += inside;
        }
      });
  if constexpr (R::keeps_gaps) body.gaps.give(body.touched_nodes, fields.size(), fields[0].size(), dt);
}

/// The body's velocity at the end of the step without contact.
template <class R, class T, int D>
typename R::Velocity free_velocity(R& body, const Vec<T, D>& acceleration, T time, T dt) {
  if constexpr (R::rotates)
    return body.motion.free_velocity(body, body.whole_velocity(), acceleration, time, dt);
  else
    return body.motion.free_velocity(body.whole_velocity(), acceleration, time, dt);
}

/// The touches of a body in all scenes that share it, without their places.
template <class TouchedNode, class Communicator>
std::vector<TouchedNode> touches_of_all(const std::vector<TouchedNode>& own, const Communicator& comm) {
  std::vector<double> numbers;
  const auto with_numbers = [](auto& t, auto&& f) {
    f(t.mass);
    f(t.mass_ratio);
    f(t.closing);
    f(t.most_shear);
    for (auto* vector : {&t.start, &t.normal, &t.arm})
      for (auto& x : std::span(vector->data(), static_cast<std::size_t>(vector->size()))) f(x);
  };
  for (const TouchedNode& t : own) {
    numbers.push_back(t.inside ? 1 : 0);
    with_numbers(t, [&](const auto& x) { numbers.push_back(static_cast<double>(x)); });
  }
  std::vector<TouchedNode> all;
  const auto gathered = comm.gather(numbers);
  for (auto next = gathered.begin(); next != gathered.end();) {
    TouchedNode t{};
    t.inside = *next++ != 0;
    with_numbers(t, [&](auto& x) { x = static_cast<std::remove_reference_t<decltype(x)>>(*next++); });
    all.push_back(t);
  }
  return all;
}

/// Contact velocity of the body. On several tiles each computes it from the touched nodes of all.
template <class R, class Communicator>
typename R::Velocity velocity_in_contact(R& body, const typename R::Velocity& free,
                                         [[maybe_unused]] const Communicator& comm) {
  if constexpr (Communicator::is_serial || !R::is_free) {
    return body.motion.velocity_in_contact(body, free);
  } else {
    auto touches = touches_of_all(body.touched_nodes, comm);
    std::swap(touches, body.touched_nodes);
    const typename R::Velocity u = body.motion.velocity_in_contact(body, free);
    std::swap(touches, body.touched_nodes);
    return u;
  }
}

/// Change of a body's velocity by an impulse, against matter that resists so.
template <class R, int N>
Mat<double, N> mobility_of(const R& body, const Mat<double, N>& resistance) {
  if constexpr (R::is_free) {
    static_assert(
        requires { body.motion.mobility(resistance); },
        "Rigid: for RigidContact and PointContact a motion that impulses change must have mobility(added); "
        "see arenite/rigid/motion/free.hpp");
    return body.motion.mobility(resistance);
  } else {
    return Mat<double, N>::Zero();
  }
}

/// Impulses of a body on the fields in a step.
template <class R>
struct ContactImpulses {
  using T = typename R::V::Scalar;
  typename R::Velocity total = R::Velocity::Zero();  ///< N s, with their moments
  T gained = 0;                              ///< impulses times the fields' mean velocities over the step, J
  Vec<T, 2> magnitudes = Vec<T, 2>::Zero();  ///< sums of |impulse|, N s, and |arm| |impulse|, N m s

  void add(const typename R::V& impulse, const typename R::V& arm) {
    total += with_moment<R::Velocity::RowsAtCompileTime>(impulse, arm);
    const T size = impulse.norm();
    magnitudes += Vec<T, 2>(size, size * arm.norm());
  }
};

/// Applies to the fields the impulses of a body that moves with `contact_velocity`. `more`: numbers that are
/// summed over the scenes, too.
template <class R, class Fields, class Communicator, class... More>
ContactImpulses<R> apply_contact_impulses(R& body, Fields& fields,
                                          const typename R::Velocity& contact_velocity,
                                          const Communicator& comm, More&... more) {
  ContactImpulses<R> impulses;
  body.contact_nodes = 0;
  for (auto& t : body.touched_nodes) {
    const auto contact = body.contact_at(t, contact_velocity);
    const typename R::V& j = contact.impulse;
    if (j.squaredNorm() == 0) continue;
    t.impulse = j;
    t.sticks = contact.sticks;
    typename R::V& v = fields[t.field].velocity[t.node];
    v += j / t.mass;
    t.after = v;
    impulses.add(j, t.arm);
    const typename R::V twice_mean = fields[t.field].start[t.node] + v;
    impulses.gained += j.dot(twice_mean) / 2;
    ++body.contact_nodes;
  }
  sum_over(comm, impulses.total, impulses.gained, impulses.magnitudes, body.contact_nodes, more...);
  return impulses;
}

/// Records the impulses on the fields and moves the body. `free`: its velocity without contact; `pushed`:
/// with the impulse `push`, N s, of other rigid bodies, too. Returns the energy that contact with the fields
/// dissipated, J, and the body's mean velocity.
template <class R, class T>
std::pair<double, typename R::Velocity> finish_step(R& body, const typename R::Velocity& free,
                                                    const typename R::Velocity& pushed,
                                                    const typename R::Velocity& push,
                                                    const typename R::Velocity& contact_velocity,
                                                    const ContactImpulses<R>& impulses, T dt) {
  using Velocity = typename R::Velocity;
  const Velocity before = body.whole_velocity();
  const auto& [total, gained, magnitudes] = impulses;
  body.take_impulse(total, dt);
  Velocity after;
  if constexpr (R::rotates)
    after = body.motion.after(contact_velocity, pushed, total, magnitudes);
  else
    after = body.motion.after(contact_velocity, pushed, total, magnitudes[0]);
  const Velocity mean = body.motion.mean(before, after);
  const double dissipation = static_cast<double>(total.dot(mean) - gained);
  body.dissipated += dissipation;
  body.driving_work += body.motion.work(before, free, mean, Velocity(total - push));
  body.move(after, dt);
  return {dissipation, mean};
}

/// Advances the body by dt to `time` and lets it exchange impulses with all fields: its own motion first,
/// then the impulses with its new velocity. Returns the energy that contact dissipated, J. Each tile touches
/// the nodes that it owns; `comm` sums over the tiles, so that all know the state of the whole body.
template <class Shape, class M, class R, class Fields, class T, int D, class Owns = OwnsAll,
          class Communicator = Serial>
ContactTally collide(const M& mesh, R& body, Fields& fields, const Vec<T, D>& acceleration, T time, T dt,
                     const Owns& owns = {}, const Communicator& comm = serial) {
  using Velocity = typename R::Velocity;
  find_touched_nodes<Shape>(mesh, body, fields, dt, owns);
  const Velocity free = free_velocity(body, acceleration, time, dt);
  const Velocity contact_velocity = velocity_in_contact(body, free, comm);
  const auto impulses = apply_contact_impulses(body, fields, contact_velocity, comm, body.inside_nodes);
  const double dissipation =
      finish_step(body, free, free, Velocity(Velocity::Zero()), contact_velocity, impulses, dt).first;
  return {.dissipation = dissipation, .nodes = body.contact_nodes};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
