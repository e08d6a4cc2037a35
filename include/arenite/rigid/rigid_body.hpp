// Rigid body in a scene: its state, and its contact with the node fields. The body gains the momentum that
// the soil loses in a step.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <arenite/contact/coulomb.hpp>
#include <arenite/contact/hold.hpp>
#include <arenite/core/alone.hpp>
#include <arenite/core/bind.hpp>
#include <arenite/core/contact_tally.hpp>
#include <arenite/core/name.hpp>
#include <arenite/core/part_energy.hpp>
#include <arenite/core/state_value.hpp>
#include <arenite/rigid/guided.hpp>
#include <arenite/rigid/motion.hpp>
#include <arenite/rigid/prescribed.hpp>
#include <arenite/rigid/surface.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Contact by rigid nodal velocity: a touched node may not move into the body, whatever the masses. The
/// body's new velocity and all impulses are found together, so that a light body is as stable as a heavy one.
struct RigidVelocity {
  static constexpr bool through_centre_of_mass = false;
};

/// Contact through the centre-of-mass velocity of the soil's and the body's nodal mass (the paper's choice):
/// softer, and nodes may move into the body. Needs a `MeshSurface`, which spreads the body's mass over its
/// nodes.
struct CentreOfMass {
  static constexpr bool through_centre_of_mass = true;
};

/// The recipe that `rigid` makes: surface, motion, friction and kind of contact of one rigid body.
template <class Surface, class Motion, class Coupling = RigidVelocity, Name name = "">
struct Rigid {
  Surface surface;
  Motion motion;
  Friction friction;

  using Erased = Rigid<erased_t<Surface>, erased_t<Motion>, Coupling, name>;
  template <class M>
  Erased erased() const {
    return {arenite::erased<M>(surface), arenite::erased<M>(motion), friction};
  }
};

/// A rigid body, a part of a scene; `rigid<"cone">(..)` gives it a name. `Surface`: see `rigid_surface`;
/// `Motion`: see `rigid_motion`.
template <Name name, class Surface, class Motion, class Coupling = RigidVelocity>
Rigid<Surface, Motion, Coupling, name> rigid(Surface surface, Motion motion, Friction friction,
                                             Coupling = {}) {
  return {std::move(surface), std::move(motion), friction};
}
template <class Surface, class Motion, class Coupling = RigidVelocity>
Rigid<Surface, Motion, Coupling> rigid(Surface surface, Motion motion, Friction friction, Coupling = {}) {
  return {std::move(surface), std::move(motion), friction};
}
/// Refused by the compiler: a number may be an angle or a coefficient.
template <Name name = "", class Surface, class Motion, class Number, class... Coupling>
requires std::is_arithmetic_v<Number>
auto rigid(Surface surface, Motion motion, Number, Coupling... coupling) {
  static_assert(!std::is_arithmetic_v<Number>,
                "rigid: the friction is Friction(angle): say Friction(20_deg)");
  return rigid<name>(std::move(surface), std::move(motion), Friction(0.0), coupling...);
}

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
      mesh, body.displacement, has_mass,
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
  const Vec<T, D> before = body.velocity,
                  free_velocity = body.motion.free_velocity(before, acceleration, time, dt);
  if constexpr (requires { body.motion.velocity_in_contact(body, free_velocity, others); }) {
    body.velocity = body.motion.velocity_in_contact(body, free_velocity, others);
  } else {
    static_assert(Others::alone || !R::is_free,
                  "Rigid: meet of this motion must take the others to sum with");
    body.velocity = body.motion.velocity_in_contact(body, free_velocity);
  }
  Vec<T, D> total = Vec<T, D>::Zero();  // on the fields
  T gained = 0;                         // by the fields: impulses times their mean velocities over the step
  T exchanged = 0;                      // magnitudes of the impulses
  body.contact_nodes = 0;
  for (auto& t : body.touched_nodes) {
    const auto given = body.contact_at(t, body.velocity);
    const Vec<T, D>& j = given.impulse;
    if (j.squaredNorm() == 0) continue;
    t.impulse = j;
    t.sticks = given.sticks;
    Vec<T, D>& v = fields[t.field].velocity[t.node];
    v += j / t.mass;
    total += j;
    exchanged += j.norm();
    gained += j.dot(fields[t.field].start[t.node] + v) / 2;
    ++body.contact_nodes;
  }
  sum_over(others, total, gained, exchanged, body.contact_nodes, body.inside_nodes);
  body.force = -total / dt;
  body.impulse -= total;
  body.velocity = body.motion.after(body.velocity, free_velocity, total, exchanged);
  const Vec<T, D> mean = body.motion.mean(before, body.velocity);
  const double dissipation = static_cast<double>(total.dot(mean) - gained);
  body.dissipated += dissipation;
  body.driving_work += body.motion.drive(before, free_velocity, mean, total);
  body.displacement += dt * body.velocity;
  return {.dissipation = dissipation, .nodes = body.contact_nodes};
}

namespace detail {
/// In the place of a body that the compiler has refused.
struct NoRigidBody {
  static constexpr bool separates_bodies = false;
};
}  // namespace detail

/// A rigid body in a scene: a part that exchanges impulses with all fields. Read `displacement`, `velocity`
/// and `force` after any step.
template <class T, int D, class Surface, class Motion, class Coupling = RigidVelocity, Name name_ = "">
struct RigidBody {
  using V = Vec<T, D>;
  static constexpr auto name = name_;
  static constexpr int exchange_rank = 1;
  static constexpr bool is_rigid_body = true, is_shared = true;
  static constexpr bool is_free = Motion::has_mass;
  static constexpr bool coupling_through_centre = Coupling::through_centre_of_mass;
  static_assert(!coupling_through_centre || (Surface::has_volume_fractions && is_free),
                "Rigid: CentreOfMass needs a MeshSurface and a Guided motion, which give the body's nodes "
                "their masses");
  Surface surface;
  Motion motion;
  Friction friction;
  V velocity = motion.start();    ///< m/s
  V displacement = V::Zero();     ///< since the start, m
  V force = V::Zero();            ///< mean contact force on the body during the last step, N
  V impulse = V::Zero();          ///< contact impulse on the body since the start, N s
  double driving_work = 0;        ///< work of gravity, load or the prescribed motion's drive, J
  double dissipated = 0;          ///< by contact, since the start, J
  std::size_t contact_nodes = 0;  ///< nodes that pushed on the body in the last step
  std::size_t inside_nodes = 0;   ///< nodes inside the body that carried mass in the last step

  /// One touched node of one field.
  struct TouchedNode {
    std::size_t field;
    Index node;
    bool inside;
    T mass;        ///< of the field at the node, kg
    T mass_ratio;  ///< what an impulse has to move, as a share of `mass`: 1, or m_rigid / (m_rigid + mass)
    V start;       ///< velocity of the field before contact, m/s
    V normal;      ///< out of the body
    bool sticks = false;    ///< to the body: no relative motion at all
    V impulse = V::Zero();  ///< on the field, N s
  };
  std::vector<TouchedNode> touched_nodes{};  ///< of the last step

  double kinetic_energy() const { return motion.kinetic_energy(velocity); }

  /// On a field in the last step, N s.
  V contact_impulse(std::size_t field) const {
    V sum = V::Zero();
    for (const auto& t : touched_nodes)
      if (t.field == field) sum += t.impulse;
    return sum;
  }

  /// Impulse on the field at a touched node if the body moves with velocity v, m/s.
  CoulombImpulse<T, D> contact_at(const TouchedNode& t, const V& v) const {
    if (t.inside) return stick<T, D>(t.start - v, t.mass_ratio * t.mass);
    return coulomb<T, D>(t.start - v, t.normal, t.mass_ratio * t.mass, friction);
  }
  V impulse_at(const TouchedNode& t, const V& v) const { return contact_at(t, v).impulse; }

  template <class Scene>
  void connect(const Scene& scene) {
    static_assert(
        !(Scene::is_portion && coupling_through_centre),
        "Rigid: CentreOfMass spreads the body's mass over all of its nodes, and a portion of the mesh "
        "knows some of them; use RigidVelocity");
    if constexpr (requires { surface.connect(scene); }) surface.connect(scene);
  }
  template <class Scene, class Others = const Alone>
  ContactTally exchange_impulses(Scene& scene, double dt, Others& others = no_others) {
    return collide<typename Scene::Shape>(scene.mesh, *this, scene.fields, scene.acceleration(),
                                          static_cast<T>(scene.time + dt), static_cast<T>(dt),
                                          scene.node_owner(), others);
  }
  template <class Scene, class Others = const Alone>
  double hold_mapped(Scene& scene, double dt, Others& others = no_others) {
    double dissipation = hold_touched<Scene::centres_stress>(touched_nodes, scene.fields, static_cast<T>(dt));
    sum_over(others, dissipation);
    dissipated += dissipation;
    return dissipation;
  }
  PartEnergy count_energy() const {
    return {.kinetic = kinetic_energy(), .dissipated = dissipated, .external = driving_work};
  }
  template <class F>
  void visit_state(F&& f) {
    f("velocity", velocity);
    f("displacement", displacement);
    f("force", force);
    f("impulse", impulse);
    f("driving_work", driving_work);
    f("dissipated", dissipated);
    f("contact_nodes", contact_nodes);
    f("inside_nodes", inside_nodes);
    if constexpr (requires { motion.visit_state(f); }) motion.visit_state(StateUnder(f, "motion"));
    if constexpr (requires { surface.visit_state(f); }) surface.visit_state(StateUnder(f, "surface"));
  }
  bool holds_against(const V& acceleration) const { return motion.holds(acceleration); }
};

template <class S, class M, class C, Name name, class Site>
auto bind_part(const Rigid<S, M, C, name>& recipe, const Site& site) {
  auto surface = bound(recipe.surface, site);
  auto motion = bound(recipe.motion, site);
  constexpr bool has_surface = rigid_surface<decltype(surface), typename Site::Shape, typename Site::Mesh>;
  constexpr bool has_motion = rigid_motion<decltype(motion), Vec<typename Site::T, Site::D>>;
  static_assert(has_surface, "Rigid: the surface lacks a member; see arenite/rigid/surface.hpp");
  static_assert(has_motion, "Rigid: the motion lacks a member; see arenite/rigid/motion.hpp");
  if constexpr (has_surface && has_motion)
    return RigidBody<typename Site::T, Site::D, decltype(surface), decltype(motion), C, name>{
        std::move(surface), std::move(motion), recipe.friction};
  else
    return detail::NoRigidBody{};  // one sentence is enough
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
