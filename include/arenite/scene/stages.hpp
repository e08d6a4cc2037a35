// Stages of a step: each of the method's loops applied to what a scene has. A stage that a scene does not
// need compiles to nothing.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include <arenite/scene/scene.hpp>
#include <arenite/transfer/face_nodes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Finds the cell of each point and removes those that left the mesh. Throws `run_error` if none is left;
/// warns when one body of several has lost its last.
template <class Scene>
void relocate(Scene& scene) {
  constexpr int width = Scene::NumericsType::template width<typename Scene::T>;
  const bool had_any = scene.point_count() > 0;
  bool regrouped = false;
  std::array<bool, Scene::body_count> emptied{};
  std::size_t number = 0;
  scene.for_each_body([&](auto& body, auto&) {
    const bool had_points = body.points.size() > 0;
    regrouped = relocate<width>(body, scene.mesh, scene.blocks) || regrouped;
    emptied[number++] = had_points && body.points.size() == 0;
  });
  if (regrouped) scene.balance_threads();
  if (had_any && scene.point_count() == 0)
    throw run_error(shared_detail::join("t = ", scene.time, " s: all ", scene.lost_points(),
                                        " points of the scene have left the mesh"));
  for (std::size_t b = 0; b < emptied.size(); ++b)
    if (emptied[b])
      warn(shared_detail::join("t = ", scene.time, " s: all points of body ", Scene::body_name(b),
                               " have left the mesh; the run goes on without it"));
}

/// P2G: clears the fields and collects mass, momentum and internal force of all bodies.
template <class Scene>
void p2g(Scene& scene) {
  for (auto& field : scene.fields) field.clear();
  scene.for_each_body([&](auto& body, auto& field) {
    p2g<typename Scene::Kinematics>(scene.numerics, scene.mesh, scene.blocks, body, field);
  });
}

/// Forces of parts (`add_force`). dt: s.
template <class Scene>
void add_forces(Scene& scene, double dt) {
  scene.for_each_part([&](auto& part) {
    if constexpr (adds_force<std::remove_reference_t<decltype(part)>, Scene>) part.add_force(scene, dt);
  });
}

namespace detail {

/// Takes velocities of a field to what the parts allow, and drive to at the end of the step. Returns the
/// impulse, N s, and the work of the drives, J.
template <class Scene, class Field, class Velocities>
std::pair<typename Scene::V, double> allow(Scene& scene, const Field& field, Velocities& velocity,
                                           [[maybe_unused]] double dt) {
  if constexpr (Scene::Needs::drives) {
    std::size_t number = 0;
    scene.for_each_part([&](const auto& part) {
      if constexpr (drives_nodes<std::remove_cvref_t<decltype(part)>, Scene>)
        for (auto& drive : scene.drives)
          if (drive.part == number)
            drive.target =
                drive.lift *
                part.driven_velocity(Scene::Shape::node_position(scene.mesh, drive.node), scene.time + dt);
      ++number;
    });
    return constrain(scene.constraints, scene.drives, field.mass, velocity);
  } else {
    return {constrain(scene.constraints, field.mass, velocity), 0};
  }
}

/// Calls `f(part)` for the parts that exchange impulses, of the ranks from `first` to `last`.
template <class Scene, class F>
void for_each_exchange(Scene& scene, int first, int last, F&& f) {
  for (int rank = first; rank <= last; ++rank)
    scene.for_each_part([&](auto& part) {
      using P = std::remove_reference_t<decltype(part)>;
      if constexpr (exchanges_impulses<P, Scene> || holds_mapped<P, Scene>)
        if (exchange_rank<P> == rank) f(part);
    });
}

}  // namespace detail

/// Below it mass and momentum are no longer known to round-off, kg.
template <class T>
inline constexpr T least_mass = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();

/// Forces from the stresses at the middle of the step, for elastic bodies with MUSL on simplices
/// (`add_half_step`). dt: s.
template <class Scene>
void centre_stress(Scene& scene, [[maybe_unused]] double dt) {
  if constexpr (Scene::centres_stress) {
    using T = typename Scene::T;
    for (auto& field : scene.fields) {
      start_velocities(field, least_mass<T>);
      detail::allow(scene, field, field.velocity, 0);
    }
    scene.for_each_body([&](const auto& body, auto& field) {
      add_half_step<typename Scene::Kinematics, typename Scene::Shape>(scene.mesh, scene.blocks, body, field,
                                                                       static_cast<T>(dt / 2));
    });
  }
}

/// Grid update: v = v^old + dt (f / m + a), with the parts' accelerations. dt: s.
template <class Scene>
void update_grid(Scene& scene, double dt) {
  using T = typename Scene::T;
  const auto acceleration = scene.acceleration();
  for (auto& field : scene.fields) {
    update_grid(field, acceleration, static_cast<T>(dt), least_mass<T>);
    if constexpr (has_light_nodes<typename Scene::Shape>)
      exchange_with_neighbours<typename Scene::Shape>(scene.mesh, field, static_cast<T>(dt));
  }
}

/// Takes velocities to what the parts' constraints allow; books impulse and work. dt: s.
template <class Scene>
void constrain(Scene& scene, double dt) {
  for (auto& field : scene.fields) {
    const auto [impulse, work] = detail::allow(scene, field, field.velocity, dt);
    scene.wall_impulse += impulse;
    scene.driving_work += work;
  }
}

/// Impulses between fields and with rigid bodies (`exchange_impulses`), by rank, then constraints again. dt:
/// s.
template <class Scene>
void exchange(Scene& scene, double dt) {
  scene.contact_tally = {};
  if constexpr (Scene::Needs::exchange) {
    detail::for_each_exchange(scene, 0, 2, [&](auto& part) {
      if constexpr (exchanges_impulses<std::remove_reference_t<decltype(part)>, Scene>)
        scene.contact_tally += part.exchange_impulses(scene, dt);
    });
    constrain(scene, dt);
    scene.limited += scene.contact_tally.limited;
    scene.limited_momentum += scene.contact_tally.limited_momentum;
  }
}

/// Exchange of momentum at light nodes (`LightNodes`), or beside the faces of a grid (`exchange_at_faces`).
/// dt: s.
template <class Scene>
void smooth_light_nodes(Scene& scene, [[maybe_unused]] double dt) {
  if constexpr (Scene::NumericsType::smooths_light_nodes) {
    for (auto& field : scene.fields)
      scene.light_nodes.template exchange<typename Scene::Shape>(scene.mesh, field);
    constrain(scene, dt);
  } else if constexpr (!has_light_nodes<typename Scene::Shape>) {
    std::size_t exchanged = 0;
    for (auto& field : scene.fields)
      exchanged += exchange_at_faces<typename Scene::Shape>(scene.mesh, field, field.velocity,
                                                            static_cast<typename Scene::T>(dt));
    if (exchanged > 0) constrain(scene, dt);
  }
}

/// MUSL: velocities mapped back from the points, held to what contact and constraints enforced. dt: s.
template <class Scene>
void map_back(Scene& scene, [[maybe_unused]] double dt) {
  if constexpr (Scene::NumericsType::maps_back) {
    scene.for_each_body(
        [&](auto& body, auto& field) { map_back(scene.numerics, scene.mesh, scene.blocks, body, field); });
    for (auto& field : scene.fields) {
      finish_map_back<Scene::centres_stress>(scene.numerics, field);
      if constexpr (!has_light_nodes<typename Scene::Shape>)
        exchange_at_faces<typename Scene::Shape>(scene.mesh, field, field.mapped, typename Scene::T(0));
    }
    const auto hold = [&](auto& part) {
      if constexpr (holds_mapped<std::remove_reference_t<decltype(part)>, Scene>)
        scene.contact_tally.dissipation += part.hold_mapped(scene, dt);
    };
    detail::for_each_exchange(scene, 0, 0, hold);
    for (auto& field : scene.fields) detail::allow(scene, field, field.mapped, dt);
    detail::for_each_exchange(scene, 1, 2, hold);
  }
}

/// G2P and the law, body by body; hands the work of the stresses to the parts that ask for it. dt: s.
template <class Scene>
void g2p(Scene& scene, double dt) {
  scene.finite = true;
  scene.for_each_body([&](auto& body, const auto& field) {
    const G2pSums sums = g2p<typename Scene::Kinematics, Scene::Needs::stress_work>(
        scene.numerics, scene.mesh, scene.blocks, body, field, static_cast<typename Scene::T>(dt),
        scene.average);
    body.opened_volume += sums.opened_volume;
    body.finite = std::isfinite(sums.check);
    scene.finite = scene.finite && body.finite;
    scene.for_each_part([&](auto& part) {
      if constexpr (takes_stress_work<std::remove_reference_t<decltype(part)>, Scene>)
        part.take_stress_work(sums.work);
    });
  });
}

/// Parts that move with the matter, or move the mesh (`follow_motion`). dt: s.
template <class Scene>
void follow(Scene& scene, double dt) {
  scene.for_each_part([&](auto& part) {
    if constexpr (follows_motion<std::remove_reference_t<decltype(part)>, Scene>)
      part.follow_motion(scene, dt);
  });
}

/// Whether all numbers of a point are finite.
template <class Points>
bool is_finite(const Points& points, std::size_t p) {
  bool finite = true;
  points.for_each_column([&](const auto& column) {
    if constexpr (std::is_floating_point_v<typename std::remove_cvref_t<decltype(column)>::value_type>)
      finite = finite && std::isfinite(column[p]);
  });
  return finite;
}

/// Advances the clock. Throws `run_error` that names the first point that is not finite. dt: s.
template <class Scene>
void finish(Scene& scene, double dt) {
  scene.time += dt;
  scene.time_step = dt;
  ++scene.steps;
  if (scene.finite) return;
  std::size_t number = 0;
  std::string bodies;  // whose sums are not finite
  scene.for_each_body([&](const auto& body, const auto&) {
    const auto& points = body.points;
    const std::size_t first_bad = parallel_reduce(
        points.size(), points.size(),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t p = begin; p < end; ++p)
            if (!is_finite(points, p)) return p;
          return points.size();
        },
        [](std::size_t a, std::size_t b) { return std::min(a, b); });
    if (first_bad < points.size())
      throw run_error(shared_detail::join(
          "t = ", scene.time, " s, step ", scene.steps, ": point ", first_bad, " of body ",
          Scene::body_name(number), " at (", points.position[first_bad].transpose(), ") m has velocity (",
          points.velocity[first_bad].transpose(), ") m/s, pressure ", -trace(points.stress[first_bad]) / 3,
          " Pa, volume ", points.volume[first_bad], " m3: no longer finite"));
    if (!body.finite) bodies += shared_detail::join(bodies.empty() ? "" : ", ", Scene::body_name(number));
    ++number;
  });
  throw run_error(
      shared_detail::join("t = ", scene.time, " s, step ", scene.steps,
                          ": the sums of stress and volume over the points of body ", bodies,
                          " are not finite, though every number of every point is: they overflow"));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
