// Roles of a part: members that the stages of a step detect and call. A part is any
// value of a class that is not `final`; it plays at least one role. See examples/extend/spring_bed.cpp.
//
// A recipe is turned into the part once, when the scene is made, by `bind_part(recipe, traits)` (`SceneTraits`), found
// by argument-dependent lookup; without one the recipe is the part. Parts are called in the order of the
// scene, unless a role states another one.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <arenite/core/role_names.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/part/contact_tally.hpp>
#include <arenite/part/part_energy.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// When the scene is made, after all parts are bound, bodies filled and `scene.constraints` known: what a
/// part wants to know of the others.
template <class P, class S>
concept connects = requires(P& part, S& scene) {
  { part.connect(scene) } -> std::same_as<void>;
};

/// When the scene is made, before `connect`: calls `nodes.block(node, direction)` for what it blocks
/// (`NodeConstraints`). What all parts block at a node becomes one projector.
template <class P, class S>
concept constrains = requires(const P& part, typename S::Nodes& nodes) {
  { part.constrain(nodes) } -> std::same_as<void>;
};

/// With `constrain`, wherever velocities are constrained: the velocity [D], m/s, at a position [D], m, and
/// the end of the step, s, along the directions that it blocks; without it they are blocked to zero. Where
/// parts disagree at a node the first one of the scene wins.
template <class P, class S>
concept drives_nodes = requires(const P& part, const typename S::V& position) {
  { part.driven_velocity(position, 0.0) } -> std::convertible_to<typename S::V>;
};

/// After P2G: adds forces, N, by `field.sums[node].add_force(f)`; `scene.fields` have mass (`sums`)
/// and force of this step, and the velocities at the end of the previous one. dt: s. In a scene over a
/// portion of a mesh nodes have the sums over all portions, and the added force must be the same in all: a
/// part whose forces follow from its own points sums them with `scene.communicator()`.
template <class P, class S>
concept adds_force = requires(P& part, S& scene) {
  { part.add_force(scene, 0.0) } -> std::same_as<void>;
};

/// In the grid update: an acceleration [D] of all matter, m/s2, at a time, s; all parts' are added.
template <class P, class S>
concept accelerates = requires(const P& part) {
  { part.acceleration(0.0) } -> std::convertible_to<typename S::V>;
};

/// After the grid update: gives the fields' velocities impulses, takes its own motion through the step, and
/// returns what it did. `static constexpr int contact_order` orders these parts: 0 bodies with each
/// other, 1 rigid bodies, 2 (without one) all else. Velocities are constrained again afterwards.
///
/// In a scene over a portion of a mesh it treats all nodes alike and counts those that it owns
/// (`scene.node_owner()`); sums over all nodes are those of `scene.communicator()`. `is_shared`: its numbers are
/// those of all portions together.
template <class P, class S>
concept applies_impulses = requires(P& part, S& scene) {
  { part.apply_impulses(scene, 0.0) } -> std::same_as<ContactTally>;
};

/// MUSL: constrains `field.mapped`, the velocities from which strains follow, to what its impulses enforced.
/// Returns the energy that this dissipates, J. In the same order; walls act after order 0.
template <class P, class S>
concept constrains_mapped = requires(P& part, S& scene) {
  { part.constrain_mapped(scene, 0.0) } -> std::same_as<double>;
};

/// After G2P, for each body: the work of its stresses in this step, J, and, if a part asks for it, its value with
/// only the stresses of the end of the step.
template <class P>
concept takes_both_works = requires(P& part) {
  { part.take_stress_work(0.0, 0.0) } -> std::same_as<void>;
};
template <class P, class S>
concept takes_stress_work = takes_both_works<P> || requires(P& part) {
  { part.take_stress_work(0.0) } -> std::same_as<void>;
};

/// Wherever velocities at the end of the step are constrained, up to three times a step: the impulse that the
/// constraints gave to a node, N s, for each node that they changed and the scene owns. With the number of
/// the field as first argument: of each field, and not what constraints take of a node correction's residual.
template <class P, class S>
concept takes_wall_impulse_of_field = requires(P& part, const typename S::V& impulse) {
  { part.take_wall_impulse(std::size_t{}, Index{}, impulse) } -> std::same_as<void>;
};
template <class P, class S>
concept takes_wall_impulse = takes_wall_impulse_of_field<P, S> ||
    requires(P& part, const typename S::V& impulse) {
  { part.take_wall_impulse(Index{}, impulse) } -> std::same_as<void>;
};

/// After P2G, before `add_force`: reads the nodes' sums over the points.
template <class P, class S>
concept acts_after_p2g = requires(P& part, const S& scene) {
  { part.after_p2g(scene, 0.0) } -> std::same_as<void>;
};

/// Once the velocities of the nodes at the end of the step are known. With MUSL: after mapping back, before
/// contact and walls constrain the mapped velocities. `take_mapped_momentum` then gets the momentum, kg m/s,
/// that walls add to them, for each node that they changed and the scene owns. Returns nothing, or the
/// energy, J, that the part's impulses dissipated beyond the amount already reported: the mean velocities of
/// the step are known here (`mean_velocity`).
template <class P, class S>
concept records_after_grid = requires(P& part, const S& scene) {
  { part.after_grid(scene, 0.0) } -> std::same_as<double>;
};
template <class P, class S>
concept acts_after_grid = records_after_grid<P, S> || requires(P& part, const S& scene) {
  { part.after_grid(scene, 0.0) } -> std::same_as<void>;
};
template <class P, class S>
concept takes_mapped_momentum = requires(P& part, const S& scene, const typename S::V& momentum) {
  { part.take_mapped_momentum(scene, 0.0, std::size_t{}, Index{}, momentum) } -> std::same_as<void>;
};

/// In `Reactions`: the impulse [D], N s, that the part gave to the nodes that the scene owns in this step, as
/// a wall of the name `wall_name()`.
template <class P, class S>
concept gives_wall_impulse = requires(const P& part) {
  { part.given_impulse() } -> std::convertible_to<typename S::V>;
  { part.wall_name() } -> std::convertible_to<std::string_view>;
};

/// After G2P: follows the matter, or moves the mesh. Velocities of fields and points are those of the end of
/// the step; `scene.time` is its begin.
template <class P, class S>
concept follows_motion = requires(P& part, S& scene) {
  { part.follow_motion(scene, 0.0) } -> std::same_as<void>;
};

/// At the end of a step, once the clock has advanced: may insert, remove and split points
/// (`insert_points`, `remove_points`, `split_points`).
template <class P, class S>
concept renews_points = requires(P& part, S& scene) {
  { part.renew_points(scene) } -> std::same_as<void>;
};

/// In `stable_step`: the largest step that the part allows, s.
template <class P, class S>
concept bounds_step = requires(const P& part, const S& scene) {
  { part.stable_step(scene) } -> std::same_as<double>;
};

/// In `energies` and `Watch`.
template <class P, class S>
concept counts_energy = requires(const P& part) {
  { part.count_energy() } -> std::same_as<PartEnergy>;
};

/// Whether the part keeps matter from falling along an acceleration [D], for the warnings about a new scene.
/// A part without this role is assumed to if it adds forces or exchanges impulses from outside.
template <class P, class S>
concept holds_against = requires(const P& part, const typename S::V& acceleration) {
  { part.holds_against(acceleration) } -> std::same_as<bool>;
};

namespace shared_detail {
struct AnyVisitor {
  template <class Value>
  void operator()(std::string_view, Value&&) const {}
};
}  // namespace shared_detail

/// In `for_each_state`: calls `f(name, value)` for each `state_value` that it carries from one step to the
/// next, and changes nothing itself. A vector whose count never changes goes as a `std::span`: a state with
/// another count is then refused. Its path there is `static constexpr std::string_view state_name`; a part
/// without one goes by its number.
template <class P, class S>
concept owns_state = requires(P& part) {
  { part.visit_state(shared_detail::AnyVisitor{}) } -> std::same_as<void>;
};

/// Once its state, and that of the bodies, was restored: renews what follows from them, or throws `error` if
/// it does not fit; the values that were there are then put back.
template <class P, class S>
concept follows_state = requires(P& part, S& scene) {
  { part.follow_state(scene) } -> std::same_as<void>;
};

/// Requirements of a part on the scene, as static constants: `separates_bodies` (a velocity field for each
/// body instead of one for all), `needs_mass_gradient` (of each field), `needs_point_ids`, `point_columns`
/// (how many numbers it keeps with each point, zero at first: `points.part_columns[k]`, k from
/// `first_point_column(scene, *this)` on); a type `OnlyOne` names a kind of which a scene has one at most.
template <class P>
inline constexpr bool separates_bodies = [] {
  if constexpr (requires { P::separates_bodies; })
    return P::separates_bodies;
  else
    return false;
}();
template <class P>
inline constexpr bool needs_mass_gradient = [] {
  if constexpr (requires { P::needs_mass_gradient; })
    return P::needs_mass_gradient;
  else
    return false;
}();
template <class P>
inline constexpr bool needs_point_ids = [] {
  if constexpr (requires { P::needs_point_ids; })
    return P::needs_point_ids;
  else
    return false;
}();
template <class P>
inline constexpr int point_columns = [] {
  if constexpr (requires { P::point_columns; })
    return P::point_columns;
  else
    return 0;
}();
/// The first of the columns of a part of this scene. Call it in `connect`.
template <class Scene, class Part>
std::size_t first_point_column(const Scene& scene, const Part& part) {
  int before = 0;
  bool found = false;
  scene.for_each_part([&](const auto& other) {
    found = found || static_cast<const void*>(&other) == static_cast<const void*>(&part);
    if (!found) before += point_columns<std::remove_cvref_t<decltype(other)>>;
  });
  return static_cast<std::size_t>(before);
}
/// A part that says `static constexpr bool moves_rigid_bodies = true` takes the rigid bodies of its scene
/// through the step in its own `apply_impulses`; theirs then does nothing.
template <class P>
inline constexpr bool moves_rigid_bodies = [] {
  if constexpr (requires { P::moves_rigid_bodies; })
    return P::moves_rigid_bodies;
  else
    return false;
}();
template <class P>
inline constexpr int contact_order = [] {
  if constexpr (requires { P::contact_order; })
    return P::contact_order;
  else
    return 2;
}();

namespace shared_detail {

template <class P>
inline constexpr bool plays_a_role =
    names_constrain<P> || names_add_force<P> || names_acceleration<P> || names_apply_impulses<P> ||
    names_constrain_mapped<P> || names_take_stress_work<P> || names_take_wall_impulse<P> ||
    names_follow_motion<P> || names_renew_points<P> || names_stable_step<P> || names_after_p2g<P> ||
    names_after_grid<P> || requires {
  P::separates_bodies;
}
|| requires { P::needs_point_ids; }
|| requires { P::is_on_portion; };

/// Stops the compiler with the cure for a part that a scene would else leave out in silence.
template <class P, class S>
constexpr bool check_part() {
  static_assert(plays_a_role<P>,
                "Scene: a part plays no role; a part is bodies(..), or a class that is not final with one of "
                "add_force, acceleration, constrain, apply_impulses, constrain_mapped, follow_motion, "
                "renew_points, stable_step, take_stress_work, take_wall_impulse; see arenite/part/roles.hpp");
  static_assert(!names_connect<P> || connects<P, S>, "part: connect must be void connect(Scene& scene)");
  static_assert(!names_constrain<P> || constrains<P, S>,
                "part: constrain must be void constrain(Nodes& nodes) const");
  static_assert(!names_driven_velocity<P> || (drives_nodes<P, S> && names_constrain<P>),
                "part: driven_velocity must be Vec<T, D> driven_velocity(const Vec<T, D>& position, double "
                "time) const, beside constrain");
  static_assert(!names_add_force<P> || adds_force<P, S>,
                "part: add_force must be void add_force(Scene& scene, double dt)");
  static_assert(!names_add_force<P> || reads_start_state<P>,
                "part: one that adds forces must not say reads_start_state = false");
  static_assert(!names_acceleration<P> || accelerates<P, S>,
                "part: acceleration must be Vec<T, D> acceleration(double time) const");
  static_assert(!names_apply_impulses<P> || applies_impulses<P, S>,
                "part: apply_impulses must be ContactTally apply_impulses(Scene& scene, double dt)");
  static_assert(!names_constrain_mapped<P> || constrains_mapped<P, S>,
                "part: constrain_mapped must be double constrain_mapped(Scene& scene, double dt)");
  static_assert(!names_take_stress_work<P> || takes_stress_work<P, S>,
                "part: take_stress_work must be void take_stress_work(double joules)");
  static_assert(
      !names_take_wall_impulse<P> || takes_wall_impulse<P, S>,
      "part: take_wall_impulse must be void take_wall_impulse(Index node, const Vec<T, D>& impulse)");
  static_assert(!names_after_p2g<P> || acts_after_p2g<P, S>,
                "part: after_p2g must be void after_p2g(const Scene& scene, double dt)");
  static_assert(
      !names_after_grid<P> || acts_after_grid<P, S>,
      "part: after_grid must be void after_grid(const Scene& scene, double dt), or return joules as double");
  static_assert(!names_take_mapped_momentum<P> || takes_mapped_momentum<P, S>,
                "part: take_mapped_momentum must be void take_mapped_momentum(const Scene& scene, double dt, "
                "std::size_t field, Index node, const Vec<T, D>& momentum)");
  static_assert(!names_given_impulse<P> || gives_wall_impulse<P, S>,
                "part: given_impulse must be Vec<T, D> given_impulse() const, beside std::string wall_name() "
                "const");
  static_assert(!names_follow_motion<P> || follows_motion<P, S>,
                "part: follow_motion must be void follow_motion(Scene& scene, double dt)");
  static_assert(!names_renew_points<P> || renews_points<P, S>,
                "part: renew_points must be void renew_points(Scene& scene)");
  static_assert(!names_stable_step<P> || bounds_step<P, S>,
                "part: stable_step must be double stable_step(const Scene& scene) const");
  static_assert(!names_count_energy<P> || counts_energy<P, S>,
                "part: count_energy must be PartEnergy count_energy() const");
  static_assert(!names_holds_against<P> || holds_against<P, S>,
                "part: holds_against must be bool holds_against(const Vec<T, D>& acceleration) const");
  static_assert(!names_visit_state<P> || owns_state<P, S>,
                "part: visit_state must be template <class F> void visit_state(F&& f)");
  static_assert(!names_follow_state<P> || follows_state<P, S>,
                "part: follow_state must be void follow_state(Scene& scene)");
  return true;
}

template <class S, class... P>
constexpr bool check_all_roles(std::type_identity<std::tuple<P...>>) {
  return (check_part<P, S>() && ...);
}

}  // namespace shared_detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
