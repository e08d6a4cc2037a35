// Rigid body in a scene: what a user writes, and its state.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/contact/coulomb.hpp>
#include <arenite/contact/hold.hpp>
#include <arenite/core/bind.hpp>
#include <arenite/core/name.hpp>
#include <arenite/core/refusals.hpp>
#include <arenite/core/state_value.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/part/contact_tally.hpp>
#include <arenite/part/part_energy.hpp>
#include <arenite/rigid/body/past_walls.hpp>
#include <arenite/rigid/body/pose.hpp>
#include <arenite/rigid/body/surface.hpp>
#include <arenite/rigid/motion/free.hpp>
#include <arenite/rigid/motion/guided.hpp>
#include <arenite/rigid/motion/motion.hpp>
#include <arenite/rigid/motion/prescribed.hpp>
#include <arenite/rigid/motion/prescribed_pose.hpp>
#include <arenite/rigid/with_matter/collide.hpp>
#include <arenite/rigid/with_matter/collide_at_points.hpp>
#include <arenite/rigid/with_matter/node_gaps.hpp>
#include <arenite/rigid/with_matter/point_contact.hpp>
#include <arenite/warnings/matter_inside.hpp>
#include <arenite/warnings/thin_walls.hpp>
#include <arenite/warnings/try_distance.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The default: contact at nodes by the body's velocity, with the gap that matter has opened at each. Matter
/// that has parted from the body there may come back by as much, whatever the masses: (v - v_body) . n >=
/// -gap / dt with gap' = max(0, gap + dt (v - v_body) . n). The body's new velocity and all impulses are
/// found together, so that a light body is as stable as a heavy one. Costs a number a touched node.
struct NodalGap {
  static constexpr bool through_centre_of_mass = false, keeps_gaps = true;
};

/// `NodalGap` without the gap: a touched node may not move into the body. It is a ratchet: gaps that
/// vibration opens do not close, and matter that rests or rubs on the body is lifted.
struct RigidVelocity {
  static constexpr bool through_centre_of_mass = false;
};

/// Contact through the centre-of-mass velocity of the soil's and the body's nodal mass (the paper's choice):
/// softer, and nodes may move into the body. Needs a `MeshSurface`, which spreads the body's mass over its
/// nodes.
struct CentreOfMass {
  static constexpr bool through_centre_of_mass = true;
};

// The fourth kind is `PointContact`: at the material points, without the gap of nodes (point_contact.hpp).

/// The recipe that `rigid` makes: surface, motion, friction and kind of contact of one rigid body.
template <class Surface, class Motion, class Coupling = NodalGap, Name name = "">
struct Rigid {
  Surface surface;
  Motion motion;
  Friction friction;

  using TypeErased = Rigid<type_erased_t<Surface>, type_erased_t<Motion>, Coupling, name>;
  template <class M>
  TypeErased type_erased() const {
    return {arenite::type_erased<M>(surface), arenite::type_erased<M>(motion), friction};
  }
};

/// A rigid body, a part of a scene; `rigid<"cone">(..)` gives it a name. `Surface`: see `rigid_surface`;
/// `Motion`: see `rigid_motion`.
template <Name name, class Surface, class Motion, class Coupling = NodalGap>
Rigid<Surface, Motion, Coupling, name> rigid(Surface surface, Motion motion, Friction friction,
                                             Coupling = {}) {
  return {std::move(surface), std::move(motion), friction};
}
template <class Surface, class Motion, class Coupling = NodalGap>
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
/// In the place of a body that the compiler has refused.
struct NoRigidBody {
  static constexpr bool separates_bodies = false;
};
}  // namespace detail

/// A rigid body in a scene: a part that exchanges impulses with all fields. Read `displacement`, `velocity`
/// and `force` after any step; of one that rotates also `position()`, `orientation`, `spin` and `torque`. The
/// velocity of a body that rotates is that of its centre; spins and moments have one component in the plane.
template <class T, int D, class Surface, class Motion, class Coupling = NodalGap, Name name_ = "">
struct RigidBody {
  using V = Vec<T, D>;
  static constexpr auto name = name_;
  static constexpr int contact_order = 1;
  static constexpr bool is_rigid_body = true, is_shared = true;
  static constexpr bool is_free = Motion::has_mass, rotates = arenite::rotates<Motion>;
  /// Velocity, or velocity and spin of a body that rotates; impulse, or impulse and its moment.
  using Velocity = std::conditional_t<rotates, Twist<T, D>, V>;
  static constexpr bool coupling_through_centre = Coupling::through_centre_of_mass;
  static constexpr bool keeps_gaps = requires { Coupling::keeps_gaps; };
  static_assert(!coupling_through_centre || (Surface::has_volume_fractions && is_free),
                ARENITE_SAYS_CENTRE_OF_MASS);
  /// Whether it touches material points (`PointContact`), not nodes.
  static constexpr bool touches_points = requires { Coupling::at_points; };
  static_assert(
      !touches_points || requires(const Surface s) { s.distance(); }, ARENITE_SAYS_POINT_CONTACT_SURFACE);
  static constexpr bool limits_shear = requires(const Surface s) { s.shear_limit(Index{}); };
  Surface surface;
  Motion motion;
  Friction friction;
  V velocity = linear_part<D>(Velocity(motion.start()));  ///< m/s
  V displacement = V::Zero();                             ///< since the start, m
  V force = V::Zero();            ///< mean contact force on the body during the last step, N
  V impulse = V::Zero();          ///< contact impulse on the body since the start, N s
  double driving_work = 0;        ///< work of gravity, load or the prescribed motion's drive, J
  double dissipated = 0;          ///< by contact, since the start, J
  std::size_t contact_nodes = 0;  ///< nodes that pushed on the body in the last step
  /// Nodes inside the body that carried mass in the last step; `PointContact` does not count them.
  std::size_t inside_nodes = 0;
  Spin<T, D> spin = angular_part<D>(Velocity(motion.start()));  ///< angular velocity, rad/s
  Orientation<D> orientation{};                                 ///< against the start
  Spin<T, D> torque = Spin<T, D>::Zero();           ///< mean moment of contact about the centre, N m
  Spin<T, D> angular_impulse = Spin<T, D>::Zero();  ///< of contact since the start, N m s

  /// One touched node of one field.
  struct TouchedNode {
    std::size_t field;
    Index node;
    bool inside;
    T mass;        ///< of the field at the node, kg
    T mass_ratio;  ///< mass that an impulse moves, as a share of `mass`: 1, or m_rigid / (m_rigid + mass)
    V start;       ///< velocity of the field before contact, m/s
    V normal;      ///< out of the body
    bool sticks = false;    ///< to the body: no relative motion at all
    V impulse = V::Zero();  ///< on the field, N s
    V after = V::Zero();    ///< velocity of the field with the impulse
    V arm = V::Zero();      ///< from the centre of a body that rotates, m
    T closing = 0;          ///< with `NodalGap`: with which it may close its gap, m/s
    T most_shear = std::numeric_limits<T>::infinity();  ///< greatest tangential impulse, N s

    /// Velocity of the field before contact, m/s, minus the velocity that closes the gap.
    V before_contact() const {
      if constexpr (keeps_gaps)
        return start + closing * normal;
      else
        return start;
    }
  };
  /// Of the last step; with `PointContact` those that took an impulse, without normals.
  std::vector<TouchedNode> touched_nodes{};
  [[no_unique_address]] std::conditional_t<keeps_gaps, NodeGaps<T>, Nothing> gaps{};
  /// The touched points and their impulses, with `PointContact`.
  [[no_unique_address]] std::conditional_t<touches_points, PointImpulses<T, D, Velocity::RowsAtCompileTime>,
                                           Nothing>
      at_points{};

  double kinetic_energy() const { return motion.kinetic_energy(whole_velocity()); }

  /// Of the centre of a body that rotates, m.
  V position() const requires(rotates) { return motion.centre().template cast<T>() + displacement; }
  Pose<D> pose() const {
    if constexpr (rotates)
      return {motion.centre(), displacement.template cast<double>(), orientation.matrix()};
    else
      return {Vec<double, D>::Zero(), displacement.template cast<double>(), Mat<double, D>::Identity()};
  }
  /// Where a surface finds the body: its displacement, or its pose.
  auto place() const {
    if constexpr (rotates)
      return pose();
    else
      return displacement;
  }
  Velocity whole_velocity() const {
    if constexpr (rotates)
      return twist<T, D>(velocity, spin);
    else
      return velocity;
  }

  /// On a field in the last step, N s.
  V contact_impulse(std::size_t field) const {
    V sum = V::Zero();
    for (const auto& t : touched_nodes)
      if (t.field == field) sum += t.impulse;
    return sum;
  }

  /// Impulse on the field at a touched node if the body moves with velocity v, m/s.
  CoulombImpulse<T, D> contact_at(const TouchedNode& t, const Velocity& v) const {
    const V approach = t.before_contact() - velocity_at<T, D>(v, t.arm);
    if (t.inside) return stick<T, D>(approach, t.mass_ratio * t.mass);
    return coulomb<T, D>(approach, t.normal, t.mass_ratio * t.mass, friction, t.most_shear);
  }
  V impulse_at(const TouchedNode& t, const Velocity& v) const { return contact_at(t, v).impulse; }
  /// Records the impulse of a step on the fields.
  void take_impulse(const Velocity& total, T dt) {
    const V linear = linear_part<D>(total);
    const Spin<T, D> angular = angular_part<D>(total);
    for (int k = 0; k < D; ++k) {
      force[k] = -linear[k] / dt;
      impulse[k] -= linear[k];
    }
    for (int k = 0; k < rotations<D>; ++k) {
      torque[k] = -angular[k] / dt;
      angular_impulse[k] -= angular[k];
    }
  }
  /// Moves through a step with the velocity of its end.
  void move(const Velocity& v, T dt) {
    velocity = linear_part<D>(v);
    displacement += dt * velocity;
    if constexpr (rotates) {
      const Velocity turned = motion.turn(orientation, v, dt);
      velocity = linear_part<D>(turned);
      spin = angular_part<D>(turned);
    }
  }

  template <class Scene>
  void connect(const Scene& scene) {
    static_assert(
        !(Scene::is_portion && coupling_through_centre),
        "Rigid: CentreOfMass spreads the body's mass over all of its nodes, and a portion of the mesh "
        "knows some of them; use RigidVelocity");
    static_assert(
        !(Scene::is_portion && touches_points),
        "Rigid: PointContact sweeps over the points of the whole body, and a portion of the mesh has "
        "some of them; use RigidVelocity");
    static_assert(!(Scene::NumericsType::maps_back && touches_points), ARENITE_SAYS_POINT_CONTACT_MUSL);
    if constexpr (requires { surface.connect(scene); }) surface.connect(scene);
  }
  /// Throws and warns of errors in a new scene; over portions of a mesh all ask at once.
  template <class Scene>
  void look_at_new(const Scene& scene) const {
    if constexpr (requires { surface.distance(); }) {
      shared_detail::try_distance(scene, surface.distance(), called_in(scene));
      shared_detail::warn_points_inside(scene, surface.distance(), called_in(scene));
      if constexpr (!touches_points && requires { surface.reach(); })
        shared_detail::warn_thin_walls(scene, surface.distance(), surface.reach(), called_in(scene));
    }
    if constexpr (requires { surface.region(); })
      shared_detail::warn_points_in_region(scene, surface.region(), called_in(scene));
  }
  /// The body's name in messages; its number if it has none.
  template <class Scene>
  std::string called_in(const Scene& scene) const {
    std::size_t number = 0, own = 0;
    scene.for_each_rigid([&](const auto& other) {
      if (static_cast<const void*>(&other) == static_cast<const void*>(this)) own = number;
      ++number;
    });
    return name.word().empty() ? std::to_string(own) : std::string(name.word());
  }
  template <class Scene>
  ContactTally apply_impulses(Scene& scene, double dt) {
    if constexpr (Scene::Needs::moves_rigid_bodies)
      return {};
    else if constexpr (touches_points)
      return collide_at_points(scene, *this, dt);
    else
      return collide<typename Scene::Shape>(scene.mesh, *this, scene.fields, scene.acceleration(),
                                            static_cast<T>(scene.time + dt), static_cast<T>(dt),
                                            scene.node_owner(), scene.communicator());
  }
  template <class Scene>
  double constrain_mapped(Scene& scene, double dt) {
    return record(hold_touched(touched_nodes, scene.fields, static_cast<T>(dt)), scene.communicator());
  }
  template <class Scene>
  double after_grid(const Scene& scene, [[maybe_unused]] double dt) {
    if constexpr (keeps_gaps)
      gaps.follow(touched_nodes, static_cast<T>(dt), [&](const TouchedNode& t) {
        const V& v = scene.fields[t.field].velocity[t.node];
        return dot<T, D>(V(v - velocity_at<T, D>(whole_velocity(), t.arm)), t.normal);
      });
    return record(rest_of_dissipation(touched_nodes, scene.fields), scene.communicator());
  }
  PartEnergy count_energy() const {
    PartEnergy e{.kinetic = kinetic_energy(), .dissipated = dissipated, .external = driving_work};
    if constexpr (requires { motion.stored_energy(*this); }) e.stored = motion.stored_energy(*this);
    if constexpr (requires { motion.damped; }) e.dissipated += motion.damped;
    return e;
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
    if constexpr (rotates) {
      f("spin", spin);
      f("torque", torque);
      f("angular_impulse", angular_impulse);
      orientation.visit_state(f);
    }
    if constexpr (touches_points) f("deepest_point", at_points.deepest);
    if constexpr (keeps_gaps) gaps.visit_state(StateUnder(f, "gaps"));
    if constexpr (requires { motion.visit_state(f); }) motion.visit_state(StateUnder(f, "motion"));
    if constexpr (requires { surface.visit_state(f); }) surface.visit_state(StateUnder(f, "surface"));
  }
  template <class Scene>
  void follow_state([[maybe_unused]] Scene& scene) {
    if constexpr (keeps_gaps) gaps.check(scene.fields.size(), scene.fields[0].size());
  }
  bool holds_against(const V& acceleration) const { return motion.holds(acceleration); }
  /// For the watch of a run, of a body with a mass and a distance.
  WatchedRigid first_look(const MeshSides<D>& mesh) const {
    return detail::first_look(surface.distance(), pose(), mesh);
  }
  std::string look_at_walls(WatchedRigid& seen, const MeshSides<D>& mesh) const {
    return detail::look_at_walls(seen, surface.distance(), pose(), mesh);
  }

 private:
  template <class Communicator>
  double record(double dissipation, const Communicator& comm) {
    sum_over(comm, dissipation);
    dissipated += dissipation;
    return dissipation;
  }
};

template <class S, class M, class C, Name name, class Traits>
auto bind_part(const Rigid<S, M, C, name>& recipe, const Traits& traits) {
  auto surface = bound(recipe.surface, traits);
  auto motion = bound(recipe.motion, traits);
  using V = Vec<typename Traits::T, Traits::D>;
  constexpr bool turns = rotates<decltype(motion)>;
  using Place = std::conditional_t<turns, Pose<Traits::D>, V>;
  constexpr bool has_surface =
      rigid_surface<decltype(surface), typename Traits::Shape, typename Traits::Mesh, V> ||
      rigid_surface<decltype(surface), typename Traits::Shape, typename Traits::Mesh, Pose<Traits::D>>;
  constexpr bool fits =
      rigid_surface<decltype(surface), typename Traits::Shape, typename Traits::Mesh, Place>;
  constexpr bool has_motion =
      rigid_motion<decltype(motion), V> || rotating_motion<decltype(motion), typename Traits::T, Traits::D>;
  static_assert(has_surface, "Rigid: the surface lacks a member; see arenite/rigid/body/surface.hpp");
  static_assert(has_motion, "Rigid: the motion lacks a member; see arenite/rigid/motion/motion.hpp");
  static_assert(!has_surface || !has_motion || fits, ARENITE_SAYS_RESTING_SURFACE);
  if constexpr (has_motion && fits)
    return RigidBody<typename Traits::T, Traits::D, decltype(surface), decltype(motion), C, name>{
        std::move(surface), std::move(motion), recipe.friction};
  else
    return detail::NoRigidBody{};  // already reported
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
