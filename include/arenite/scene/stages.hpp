// Stages of a step: each of the method's loops applied to what a scene has. A stage that a scene does not
// need compiles to nothing.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include <arenite/scene/scene.hpp>
#include <arenite/transfer/face_nodes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Throws `run_error` if no point is left in the mesh; warns when one body of several has lost its last.
template <class Scene>
void relocate(Scene& scene) {
  constexpr int width = Scene::NumericsType::template width<typename Scene::T>;
  bool regrouped = false;
  std::array<bool, Scene::body_count> emptied{};
  std::size_t number = 0;
  scene.for_each_body([&](auto& body, auto&) {
    const bool had_points = body.points.size() > 0;
    regrouped = relocate<width>(body, scene.mesh, scene.blocks) || regrouped;
    emptied[number++] = had_points && body.points.size() == 0;
  });
  if (regrouped) scene.share_out();
  if (scene.point_count() == 0)
    throw run_error(shared_detail::join("t = ", scene.time, " s: all ", scene.lost_points(),
                                        " points of the scene have left the mesh"));
  for (std::size_t b = 0; b < emptied.size(); ++b)
    if (emptied[b])
      warn(shared_detail::join("t = ", scene.time, " s: all points of body ", b,
                               " have left the mesh; the run goes on without it"));
}

template <class Scene>
void scatter(Scene& scene) {
  for (auto& field : scene.fields) field.clear();
  scene.for_each_body([&](auto& body, auto& field) {
    scatter<typename Scene::Kinematics>(scene.numerics, scene.mesh, scene.blocks, body, field);
  });
}

/// Below it mass and momentum are no longer known to round-off, kg.
template <class T>
inline constexpr T least_mass = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();

template <class Scene>
void centre_stress(Scene& scene, [[maybe_unused]] double dt) {
  if constexpr (Scene::centres_stress) {
    using T = typename Scene::T;
    for (auto& field : scene.fields) {
      const Vec<T, Scene::D> none = Vec<T, Scene::D>::Zero();
      advance(field, none, T(0), least_mass<T>);
      constrain(scene.constraints, field.mass, field.velocity);
    }
    scene.for_each_body([&](const auto& body, auto& field) {
      add_half_step<typename Scene::Kinematics, typename Scene::Shape>(scene.mesh, scene.blocks, body, field,
                                                                       static_cast<T>(dt / 2));
    });
  }
}

template <class Scene>
void advance(Scene& scene, double dt) {
  using T = typename Scene::T;
  for (auto& field : scene.fields) {
    advance(field, scene.gravity, static_cast<T>(dt), least_mass<T>);
    if constexpr (Scene::Shape::constant_gradient) hand_to_neighbours(scene.mesh, field, static_cast<T>(dt));
  }
}

template <class Scene>
void constrain(Scene& scene) {
  for (auto& field : scene.fields)
    scene.wall_impulse += constrain(scene.constraints, field.mass, field.velocity);
}

template <class Scene>
void collide(Scene& scene, double dt) {
  using T = typename Scene::T;
  using M = typename Scene::Mesh;
  ContactTally tally;
  if constexpr (Scene::Contact::separate)
    tally += exchange(scene.contact, scene.fields, scene.normals, scene.contact_impulse, scene.contact_pairs,
                      static_cast<T>(dt), [&](Index node) {
                        if constexpr (is_simplex_mesh<M>)
                          return scene.mesh.node_size(node);
                        else
                          return scene.mesh.edge();
                      });
  scene.for_each_rigid([&](auto& body) {
    tally += collide<typename Scene::Shape>(scene.mesh, body, scene.fields, scene.gravity,
                                            static_cast<T>(scene.time + dt), static_cast<T>(dt));
  });
  if constexpr (Scene::Contact::separate || Scene::rigid_count > 0) constrain(scene);
  scene.contact_tally = tally;
  scene.limited += tally.limited;
  scene.limited_momentum += tally.limited_momentum;
  if constexpr (Scene::tracks_energy) {
    scene.ledger.contact_dissipation += tally.dissipation;
    for (const auto& field : scene.fields) {
      scene.ledger.gravity_work += parallel_reduce(
          field.size(), 0.0,
          [&](std::size_t begin, std::size_t end) {
            double work = 0;
            for (std::size_t i = begin; i < end; ++i)
              work += dt * static_cast<double>(field.mass[i] * scene.gravity.dot(field.velocity[i]));
            return work;
          },
          std::plus<>{});
    }
  }
}

template <class Scene>
void smooth_light_nodes(Scene& scene) {
  if constexpr (Scene::NumericsType::smooths_light_nodes) {
    for (auto& field : scene.fields) scene.light_nodes.exchange(scene.mesh, field);
    constrain(scene);
  } else if constexpr (!Scene::Shape::constant_gradient) {
    for (auto& field : scene.fields) exchange_at_faces(scene.mesh, field.mass, field.velocity);
    constrain(scene);
  }
}

template <class Scene>
void remap(Scene& scene, [[maybe_unused]] double dt) {
  if constexpr (Scene::NumericsType::remaps) {
    scene.for_each_body(
        [&](auto& body, auto& field) { remap(scene.numerics, scene.mesh, scene.blocks, body, field); });
    for (auto& field : scene.fields) {
      finish_remap<Scene::centres_stress>(scene.numerics, field);
      if constexpr (!Scene::Shape::constant_gradient) exchange_at_faces(scene.mesh, field.mass, field.mapped);
    }
    using T = typename Scene::T;
    double dissipation = 0;
    if constexpr (Scene::Contact::separate)
      dissipation +=
          hold_together<Scene::centres_stress>(scene.contact_pairs, scene.fields, static_cast<T>(dt));
    for (auto& field : scene.fields) constrain(scene.constraints, field.mass, field.mapped);
    scene.for_each_rigid([&](const auto& body) {
      dissipation += hold_to<Scene::centres_stress>(body, scene.fields, static_cast<T>(dt));
    });
    scene.contact_tally.dissipation += dissipation;
    if constexpr (Scene::tracks_energy) scene.ledger.contact_dissipation += dissipation;
  }
}

template <class Scene>
void deform(Scene& scene, double dt) {
  scene.finite = true;
  scene.for_each_body([&](auto& body, const auto& field) {
    const DeformSums sums = deform<typename Scene::Kinematics, Scene::tracks_energy>(
        scene.numerics, scene.mesh, scene.blocks, body, field, static_cast<typename Scene::T>(dt),
        scene.average);
    body.opened_volume += sums.opened_volume;
    body.finite = std::isfinite(sums.check);
    scene.finite = scene.finite && body.finite;
    if constexpr (Scene::tracks_energy) scene.ledger.stress_work += sums.work;
  });
}

template <class Scene>
void move(Scene& scene, [[maybe_unused]] double dt) {
  if constexpr (Scene::moves) {
    using Leader = typename Scene::Motion::Leader;
    using T = typename Scene::T;
    auto& motion = scene.motion;
    T travel;
    if constexpr (Leader::rigid) {
      travel = std::get<Leader::index>(scene.rigids).displacement[motion.axis()];
    } else {
      const auto& body = std::get<Leader::index>(scene.bodies);
      if (body.points.size() == 0)
        throw run_error(shared_detail::join("t = ", scene.time, " s: body ", Leader::index,
                                            ", which leads the mesh, has lost all of its points"));
      travel = motion.travel() + static_cast<T>(dt * momentum(body)[motion.axis()] / mass(body));
    }
    try {
      motion.move(scene.mesh, travel);
    } catch (const run_error& e) {
      throw run_error(shared_detail::join("t = ", scene.time + dt, " s: ", e.what()));
    }
  }
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
          "t = ", scene.time, " s, step ", scene.steps, ": point ", first_bad, " of body ", number, " at (",
          points.position[first_bad].transpose(), ") m has velocity (",
          points.velocity[first_bad].transpose(), ") m/s, pressure ", -trace(points.stress[first_bad]) / 3,
          " Pa, volume ", points.volume[first_bad], " m3: no longer finite"));
    if (!body.finite) bodies += shared_detail::join(bodies.empty() ? "" : ", ", number);
    ++number;
  });
  throw run_error(
      shared_detail::join("t = ", scene.time, " s, step ", scene.steps,
                          ": the sums of stress and volume over the points of body ", bodies,
                          " are not finite, though every number of every point is: they overflow"));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
