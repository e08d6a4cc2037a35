// RigidContact: rigid bodies that touch each other, with friction and without rebound, in one solution with
// their contact with the matter.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <arenite/boundary/wall_sides.hpp>
#include <arenite/boundary/walls.hpp>
#include <arenite/contact/coulomb.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/linear_solve.hpp>
#include <arenite/core/refusals.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/part/contact_tally.hpp>
#include <arenite/part/part_energy.hpp>
#include <arenite/rigid/between_bodies/touching_bodies.hpp>
#include <arenite/rigid/with_matter/collide.hpp>
#include <arenite/rigid/with_matter/contact_balance.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A part of a scene: all of its rigid bodies touch one another, as `DistanceSurface`s. No rebound.
struct RigidContact {
  Friction friction;
  std::vector<RigidPair> pairs{};  ///< exceptions
  /// If given, the walls stop bodies with a mass, too: those at a side of the box around the mesh that stops
  /// the matter everywhere, as infinite planes that stay where they were at the start. In `pairs`, too, they
  /// have the names of the sides, `left`, `right`, `bottom`, .. A smooth one does not stop a body that
  /// crosses it at the start, as at a plane of symmetry.
  std::optional<Friction> walls{};
};

namespace detail {

/// How the impulses of the matter on a body oppose its velocity, as an inertia [N x N]; `coupling`: see
/// `coulomb_slope`.
template <class R, class Communicator>
auto resistance_of_matter(const R& body, const typename R::Velocity& contact_velocity, bool coupling,
                          const Communicator& comm) {
  constexpr int D = R::V::RowsAtCompileTime, N = R::Velocity::RowsAtCompileTime;
  Mat<double, N> sum = resistance_of<D, N>(resisting_nodes(body), contact_velocity.template cast<double>(),
                                           body.friction, coupling);
  sum_over(comm, sum);
  return sum;
}

/// Change of a body's velocity by an impulse in matter that resists. Friction that grows with the normal
/// impulse can make an impulse gain energy (a wedge that jams): impulses of contacts need not exist then,
/// and the growth is left to the next round.
template <class R, class Communicator>
auto mobility_in_matter(const R& body, const typename R::Velocity& contact_velocity,
                        const Communicator& comm) {
  constexpr int N = R::Velocity::RowsAtCompileTime;
  Mat<double, N> mobility = mobility_of(body, resistance_of_matter(body, contact_velocity, true, comm));
  if constexpr (R::is_free) {
    Mat<double, N> twice = mobility + mobility.transpose();
    // Components that cannot move have rows of zeros.
    for (int k = 0; k < N; ++k)
      if (twice(k, k) == 0) twice(k, k) = 1;
    if (!is_positive_definite<N>(twice))
      mobility = mobility_of(body, resistance_of_matter(body, contact_velocity, false, comm));
  }
  return mobility;
}

}  // namespace detail

namespace detail {

/// The half-space outside a side of a mesh, as a signed distance, m.
template <int D>
struct BehindSide {
  int axis;
  bool upper;
  double at;  // m

  double operator()(const Vec<double, D>& x) const { return upper ? at - x[axis] : x[axis] - at; }
};

}  // namespace detail

/// The contact of rigid bodies in D dimensions over scalar T. Read `touches()` after any step.
///
/// In a step, contact of each body with the matter is solved first. Impulses between the bodies are then
/// found that keep the gap of each point from becoming negative by the end of the step; the matter's
/// resistance to the bodies' velocities is linearised for this. The two are solved in turn until velocities
/// no longer change.
template <class T, int D>
class BoundRigidContact {
 public:
  using V = Vec<double, D>;
  static constexpr int N = D + rotations<D>;
  static constexpr int contact_order = 1;
  static constexpr bool is_shared = true, moves_rigid_bodies = true;
  using OnlyOne = RigidContact;

  double dissipated = 0;  ///< between rigid bodies, since the start, J
  int rounds = 0;         ///< solutions of the contact with the matter in the last step

  explicit BoundRigidContact(RigidContact recipe) : recipe_{std::move(recipe)} {}

  /// Where bodies touched, or could have, in the last step.
  const std::vector<RigidTouch<D>>& touches() const { return touching_.touches; }
  /// Greatest overlap at the start of a step since the start, m.
  double deepest() const { return touching_.deepest; }

  template <class Scene>
  void connect(Scene& scene) {
    touching_ = {};
    scene.for_each_rigid([&](auto& body) {
      using R = std::remove_cvref_t<decltype(body)>;
      static_assert(
          requires { body.surface.distance(); }, ARENITE_SAYS_RIGID_CONTACT_SURFACE);
      static_assert(!R::coupling_through_centre, ARENITE_SAYS_RIGID_CONTACT_CENTRE);
      static_assert(!R::touches_points, ARENITE_SAYS_RIGID_CONTACT_POINTS);
      TouchingBody<D> b;
      b.name = R::name.word().empty() ? std::to_string(touching_.bodies.size()) : std::string(R::name.word());
      b.size = std::numeric_limits<double>::infinity();
      const AnyDistance& distance = body.surface.distance();
      for (std::size_t k = 0; k < D; ++k)
        b.size = std::min(b.size, distance.upper()[k] - distance.lower()[k]);
      b.kind = R::is_free ? Kind::with_mass : Kind::driven;
      touching_.segments.push_back(distance.contact_segments());
      touching_.bodies.push_back(std::move(b));
    });
    is_ready_ = false;
    // Portions ask each other for walls, and are made one after the other.
    if constexpr (!Scene::is_portion) get_ready(scene);
  }

  template <class Scene>
  ContactTally apply_impulses(Scene& scene, double dt) {
    const auto& comm = scene.communicator();
    if (!is_ready_) get_ready(scene);
    auto steps = steps_of(scene, std::make_index_sequence<std::tuple_size_v<typename Scene::Parts>>{});
    look_at(scene);
    const auto acceleration = scene.acceleration();
    each(scene, steps, [&](auto& body, auto& s, std::size_t) {
      find_touched_nodes<typename Scene::Shape>(scene.mesh, body, scene.fields, static_cast<T>(dt),
                                                scene.node_owner());
      sum_over(comm, body.inside_nodes);
      s.free = free_velocity(body, acceleration, static_cast<T>(scene.time + dt), static_cast<T>(dt));
    });
    for (auto& b : touching_.bodies) b.impulse.setZero();
    solve_with_material(scene, steps, comm);
    predict_poses(scene, dt);
    touching_.find(dt);
    rounds = 1;
    while (rounds < most_rounds && !touching_.is_solved(dt, precision)) {
      touching_.solve(dt);
      undo_material(scene, steps);
      solve_with_material(scene, steps, comm);
      predict_poses(scene, dt);
      ++rounds;
    }
    return finish(scene, steps, dt);
  }

  PartEnergy count_energy() const { return {.dissipated = dissipated}; }
  template <class A>
  bool holds_against(const A&) const {
    return false;
  }
  template <class F>
  void visit_state(F&& f) {
    f("dissipated", dissipated);
    f("deepest", touching_.deepest);
  }

 private:
  using Kind = typename TouchingBody<D>::Kind;
  static constexpr int most_rounds = 12;
  /// Of velocities and of gaps over the way of a step.
  static constexpr double precision =
      std::max(1e-9, 64 * static_cast<double>(std::numeric_limits<T>::epsilon()));

  /// Of one body in a step; of other parts nothing.
  template <class R>
  struct Step {
    typename R::Velocity free, pushed, push, contact_velocity;
    ContactImpulses<R> impulses;
  };
  struct NoStep {};
  template <class P>
  static auto step_of_part(const P&) {
    if constexpr (requires { P::is_rigid_body; })
      return Step<P>{};
    else
      return NoStep{};
  }
  template <class Scene, std::size_t... At>
  static auto steps_of(Scene& scene, std::index_sequence<At...>) {
    return std::make_tuple(step_of_part(std::get<At>(scene.parts))...);
  }
  /// Calls `f(body, its step, number)` for each rigid body.
  template <class Scene, class Steps, class F, std::size_t... At>
  static void each_of(Scene& scene, Steps& steps, F& f, std::index_sequence<At...>) {
    std::size_t number = 0;
    const auto call = [&](auto& part, auto& s) {
      if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(s)>, NoStep>) f(part, s, number++);
    };
    (call(std::get<At>(scene.parts), std::get<At>(steps)), ...);
  }
  template <class Scene, class Steps, class F>
  static void each(Scene& scene, Steps& steps, F&& f) {
    each_of(scene, steps, f, std::make_index_sequence<std::tuple_size_v<Steps>>{});
  }

  /// A twist; where the body does not rotate, with no spin.
  template <int size>
  static Vec<double, N> as_twist(const Vec<T, size>& v) {
    return resized<N>(Vec<double, size>(v.template cast<double>()));
  }

  /// Where the bodies are.
  template <class Scene>
  void look_at(Scene& scene) {
    std::size_t k = 0;
    scene.for_each_rigid([&](auto& body) {
      auto& b = touching_.bodies[k];
      b.distance = &body.surface.distance();
      b.segments = &touching_.segments[k++];
      b.begin = body.pose();
    });
    for (const AnyDistance& wall : walls_) {
      touching_.bodies[k].distance = &wall;
      touching_.bodies[k].segments = &touching_.segments[k];
      ++k;
    }
  }
  /// Finds walls and pairs. Throws `error` if two bodies overlap.
  template <class Scene>
  void get_ready(Scene& scene) {
    if (recipe_.walls) add_walls(wall_sides(scene));
    look_at(scene);
    touching_.set_pairs(recipe_.friction, recipe_.walls, recipe_.pairs);
    touching_.check_start();
    is_ready_ = true;
  }
  void add_walls(const std::array<WallSide, 2 * D>& sides) {
    walls_.clear();
    for (std::size_t s = 0; s < sides.size(); ++s) {
      if (!sides[s].holds) continue;
      const int axis = static_cast<int>(s) / 2;
      const bool upper = s % 2 == 1;
      walls_.push_back(AnyDistance::of<D>(detail::BehindSide<D>{axis, upper, sides[s].at}));
      TouchingBody<D> b;
      b.name = place_name(axis, upper, "");
      b.size = std::numeric_limits<double>::infinity();
      b.kind = sides[s].is_smooth ? Kind::smooth_wall : Kind::wall;
      b.begin = b.end = {V::Zero(), V::Zero(), Mat<double, D>::Identity()};
      touching_.segments.emplace_back();
      touching_.bodies.push_back(std::move(b));
    }
  }

  /// Each body in turn: its velocity in contact with the matter, and the impulses that it gives.
  template <class Scene, class Steps, class Communicator>
  void solve_with_material(Scene& scene, Steps& steps, const Communicator& comm) {
    each(scene, steps, [&](auto& body, auto& s, std::size_t k) {
      using R = std::remove_cvref_t<decltype(body)>;
      constexpr int size = R::Velocity::RowsAtCompileTime;
      auto& b = touching_.bodies[k];
      for (auto& t : body.touched_nodes) t.start = scene.fields[t.field].velocity[t.node];
      const Vec<double, size> push = resized<size>(b.impulse);
      const Mat<double, size> alone = mobility_of(body, Mat<double, size>(Mat<double, size>::Zero()));
      s.push = push.template cast<T>();
      s.pushed = s.free + (alone * push).template cast<T>();
      s.contact_velocity = velocity_in_contact(body, s.pushed, comm);
      b.mobility.setZero();
      b.mobility.template topLeftCorner<size, size>() =
          detail::mobility_in_matter(body, s.contact_velocity, comm);
      s.impulses = apply_contact_impulses(body, scene.fields, s.contact_velocity, comm);
      b.twist = as_twist(s.contact_velocity);
    });
  }
  /// Undoes the impulses of the bodies on the matter, the last body first.
  template <class Scene, class Steps>
  void undo_material(Scene& scene, Steps& steps) {
    for (std::size_t n = touching_.bodies.size(); n-- > 0;)
      each(scene, steps, [&](auto& body, auto&, std::size_t k) {
        if (k != n) return;
        for (auto& t : body.touched_nodes) {
          scene.fields[t.field].velocity[t.node] = t.start;
          t.impulse.setZero();
          t.sticks = false;
        }
      });
  }
  template <class Scene>
  void predict_poses(Scene& scene, double dt) {
    std::size_t k = 0;
    scene.for_each_rigid([&](auto& body) {
      using R = std::remove_cvref_t<decltype(body)>;
      auto& b = touching_.bodies[k++];
      b.end = b.begin;
      b.end.displacement += dt * linear_part<D>(b.twist);
      if constexpr (R::rotates) {
        auto orientation = body.orientation;
        if constexpr (requires { body.motion.turned(orientation, b.twist, dt); })
          orientation = body.motion.turned(orientation, b.twist, dt);
        else
          body.motion.turn(orientation, typename R::Velocity(b.twist.template cast<T>()), static_cast<T>(dt));
        b.end.rotation = orientation.matrix();
      }
    });
    touching_.set_end_gaps();
  }

  template <class Scene, class Steps>
  ContactTally finish(Scene& scene, Steps& steps, double dt) {
    ContactTally tally;
    each(scene, steps, [&](auto& body, auto& s, std::size_t k) {
      if constexpr (requires { body.motion.push(touching_.bodies[k].impulse); })
        body.motion.push(touching_.bodies[k].impulse);
      const auto [lost, mean] =
          finish_step(body, s.free, s.pushed, s.push, s.contact_velocity, s.impulses, static_cast<T>(dt));
      const double between = -touching_.bodies[k].impulse.dot(as_twist(mean));
      dissipated += between;
      tally += {.dissipation = lost + between, .nodes = body.contact_nodes};
    });
    if (is_reporter(scene))
      for (const auto& b : touching_.bodies)
        if (b.is_wall()) scene.wall_impulse -= linear_part<D>(b.impulse).template cast<T>();
    return tally;
  }

  RigidContact recipe_;
  std::vector<AnyDistance> walls_{};
  TouchingBodies<D> touching_{};
  bool is_ready_ = false;
};

template <class Traits>
auto bind_part(const RigidContact& recipe, const Traits&) {
  return BoundRigidContact<typename Traits::T, Traits::D>(recipe);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
