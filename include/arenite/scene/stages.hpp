// Stages of a step: each of the method's loops applied to what a scene has. A stage that a scene does not
// need compiles to nothing.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <arenite/scene/ghost_sums.hpp>
#include <arenite/scene/relocate.hpp>
#include <arenite/scene/scene.hpp>
#include <arenite/transfer/face_nodes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// P2G: clears the fields and collects mass, momentum and internal force of all bodies; where nothing reads
/// them apart the momentum with the impulse of the force over the step dt, s.
template <class Scene>
void p2g(Scene& scene, double dt) {
  for (auto& field : scene.fields) field.clear();
  scene.for_each_body([&](auto& body, auto& field) {
    p2g<typename Scene::Kinematics>(scene.numerics, scene.mesh, scene.blocks, body, field,
                                    static_cast<typename Scene::T>(dt));
  });
  for (auto& field : scene.fields) {
    detail::sum_nodes(scene, field.sums);
    if constexpr (Scene::Field::has_mass_gradient) detail::sum_nodes(scene, field.mass_gradient);
  }
}

/// Forces of parts (`add_force`), after the parts that read the nodes as P2G left them (`after_p2g`).
/// dt: s.
template <class Scene>
void add_forces(Scene& scene, double dt) {
  scene.for_each_part([&](auto& part) {
    if constexpr (acts_after_p2g<std::remove_reference_t<decltype(part)>, Scene>) part.after_p2g(scene, dt);
  });
  scene.for_each_part([&](auto& part) {
    if constexpr (adds_force<std::remove_reference_t<decltype(part)>, Scene>) part.add_force(scene, dt);
  });
}

namespace detail {

/// Constrains velocities of a field to what the parts allow, and drive to at the end of the step. Returns the
/// impulse, N s, and the work of the drives, J; `take(node, impulse)` gets the impulse on each node.
template <class Scene, class Field, class Velocities, class Take = NoSink>
std::pair<typename Scene::V, double> apply_constraints(Scene& scene, const Field& field, Velocities& velocity,
                                                       [[maybe_unused]] double dt, const Take& take = {}) {
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
    return constrain(scene.constraints, scene.drives, field.mass, velocity, scene.node_owner(), take);
  } else {
    return {constrain(scene.constraints, field.mass, velocity, scene.node_owner(), take), 0};
  }
}

/// A callable that passes the impulse of constraints on a node of a field to the parts that ask for it
/// (`take_wall_impulse`). `OfResidual`: they act on the residual of `correct_nodes`.
template <bool OfResidual = false, class Scene, class Field>
auto wall_impulse_sink([[maybe_unused]] Scene& scene, [[maybe_unused]] const Field& field) {
  if constexpr (Scene::Needs::wall_impulses)
    return [&scene, &field](Index node, const typename Scene::V& impulse) {
      scene.for_each_part([&](auto& part) {
        using P = std::remove_reference_t<decltype(part)>;
        if constexpr (takes_wall_impulse_of_field<P, Scene>) {
          if (!OfResidual)
            part.take_wall_impulse(static_cast<std::size_t>(&field - scene.fields.data()), node, impulse);
        } else if constexpr (takes_wall_impulse<P, Scene>) {
          part.take_wall_impulse(node, impulse);
        }
      });
    };
  else
    return NoSink{};
}

/// A callable that passes the momentum that constraints add to mapped velocities to parts that ask for it.
template <class Scene, class Field>
auto mapped_momentum_sink([[maybe_unused]] Scene& scene, [[maybe_unused]] const Field& field,
                          [[maybe_unused]] double dt) {
  if constexpr (Scene::Needs::mapped_momenta)
    return [&scene, &field, dt](Index node, const typename Scene::V& momentum) {
      scene.for_each_part([&](auto& part) {
        if constexpr (takes_mapped_momentum<std::remove_reference_t<decltype(part)>, Scene>)
          part.take_mapped_momentum(scene, dt, static_cast<std::size_t>(&field - scene.fields.data()), node,
                                    momentum);
      });
    };
  else
    return NoSink{};
}

/// Calls `f(part)` for the parts that exchange impulses, of the contact orders from `first` to `last`.
template <class Scene, class F>
void for_each_contact(Scene& scene, int first, int last, F&& f) {
  for (int order = first; order <= last; ++order)
    scene.for_each_part([&](auto& part) {
      using P = std::remove_reference_t<decltype(part)>;
      if constexpr (applies_impulses<P, Scene> || constrains_mapped<P, Scene>)
        if (contact_order<P> == order) f(part);
    });
}

}  // namespace detail

/// Below it mass and momentum are no longer known to round-off, kg.
template <class T>
inline constexpr T least_mass = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();

namespace detail {

/// Nodes without mass that points touch follow the nodes around them (`list_massless`), in these velocities
/// of the field, and are then constrained by `hold()`.
template <class Scene, class Velocities, class Hold>
void move_massless([[maybe_unused]] Scene& scene, [[maybe_unused]] typename Scene::Field& field,
                   [[maybe_unused]] Velocities& velocity, [[maybe_unused]] const Hold& hold) {
  if constexpr (has_light_nodes<typename Scene::Shape>) {
    if (!Scene::is_portion && field.massless.empty()) return;
    change_velocities(scene, velocity, [&](auto to) {
      average_neighbours<typename Scene::Shape>(scene.mesh, field, velocity, to);
    });
    hold();
  }
}

/// Masses and velocities of the nodes that P2G gives at the start of the step, constrained.
template <class Scene>
void find_start_velocities(Scene& scene, typename Scene::Field& field) {
  using T = typename Scene::T;
  const auto hold = [&] { apply_constraints(scene, field, field.velocity, 0); };
  start_velocities(field, least_mass<T>);
  if constexpr (has_light_nodes<typename Scene::Shape>)
    list_massless(field, scene.node_owner());
  else
    redistribute_at_faces<typename Scene::Shape>(scene.mesh, field, field.velocity, T(0));
  hold();
  move_massless(scene, field, field.velocity, hold);
}

}  // namespace detail

/// Forces from the stresses at the middle of the step, for elastic bodies with MUSL on simplices
/// (`add_half_step`). dt: s.
template <class Scene>
void centre_stress(Scene& scene, [[maybe_unused]] double dt) {
  if constexpr (Scene::centres_any_stress) {
    using T = typename Scene::T;
    for (auto& field : scene.fields) {
      if (!field.centred) continue;
      detail::find_start_velocities(scene, field);
      detail::zero_ghosts(scene, field.sums);
    }
    scene.for_each_body([&](const auto& body, auto& field) {
      if constexpr (Scene::NumericsType::template centres_stress<std::remove_cvref_t<decltype(body.law)>>)
        if (field.centred)
          add_half_step<typename Scene::Kinematics, typename Scene::Shape>(scene.mesh, scene.blocks, body,
                                                                           field, static_cast<T>(dt / 2));
    });
    for (auto& field : scene.fields)
      if (field.centred) detail::sum_nodes(scene, field.sums);
  }
}

namespace detail {

/// The average of the volumetric strain of a body, where the numerics have one.
template <class Scene, class B, class Field>
void average_strains([[maybe_unused]] Scene& scene, [[maybe_unused]] B& body,
                     [[maybe_unused]] const Field& field, [[maybe_unused]] double dt) {
  using N = typename Scene::NumericsType;
  if constexpr (N::averages_strain) {
    scene.average.template sum<typename Scene::Kinematics, N>(scene.mesh, scene.blocks, body, field,
                                                              static_cast<typename Scene::T>(dt));
    if constexpr (Scene::is_portion && N::template StrainAverage<double>::numbers_per_node > 0)
      scene.communicator().sum_nodes(scene.average.numbers(), scene.average.numbers_per_node);
    scene.average.finish(scene.mesh, scene.blocks, body);
  }
}

/// Records the sums of a pass over the points of a body. `was_finite`: whether the body was finite before.
template <class Scene, class B>
void record_sums(Scene& scene, B& body, const G2pSums& sums, bool was_finite = true) {
  body.opened_volume += sums.opened_volume;
  body.finite = was_finite && std::isfinite(sums.check);
  scene.finite = scene.finite && body.finite;
  scene.for_each_part([&](auto& part) {
    using P = std::remove_reference_t<decltype(part)>;
    if constexpr (takes_both_works<P>)
      part.take_stress_work(sums.work, sums.ending_work);
    else if constexpr (takes_stress_work<P, Scene>)
      part.take_stress_work(sums.work);
  });
}

}  // namespace detail

/// USF: stresses before the forces, from the nodal velocities of P2G; then P2G again with the new stresses.
/// dt: s.
template <class Scene>
void update_stress_first(Scene& scene, [[maybe_unused]] double dt) {
  if constexpr (Scene::NumericsType::strains_first) {
    using T = typename Scene::T;
    for (auto& field : scene.fields) detail::find_start_velocities(scene, field);
    scene.finite = true;
    scene.for_each_body([&](auto& body, const auto& field) {
      detail::average_strains(scene, body, field, dt);
      detail::record_sums(scene, body,
                          update_stress<typename Scene::Kinematics, Scene::Needs::stress_work>(
                              scene.numerics, scene.mesh, body, field, static_cast<T>(dt), scene.average));
    });
    p2g(scene, dt);
  }
}

/// Grid update: v = v^old + dt (f / m + a), with the parts' accelerations. dt: s.
template <class Scene>
void update_grid(Scene& scene, double dt) {
  using T = typename Scene::T;
  const auto acceleration = scene.acceleration();
  for (auto& field : scene.fields) {
    update_grid(field, acceleration, static_cast<T>(dt), least_mass<T>);
    if constexpr (has_light_nodes<typename Scene::Shape>) {
      list_massless(field, scene.node_owner());
      if (Scene::is_portion || !field.massless.empty())
        detail::change_velocities(scene, field.velocity, [&](auto to) {
          redistribute_forces<typename Scene::Shape>(scene.mesh, field, static_cast<T>(dt), to);
        });
    }
  }
}

/// Constrains velocities of a field as the parts demand; records impulse and work. dt: s.
template <class Scene>
void constrain(Scene& scene, typename Scene::Field& field, double dt) {
  // The negligible mass of massless nodes is mass of points, too: its change of momentum counts.
  const auto momentum_of_massless = [&] {
    typename Scene::V sum = zeros<typename Scene::V>();
    for (const Index i : field.massless)
      for (int k = 0; k < Scene::D; ++k) sum[k] += field.sums[i].mass() * field.velocity[i][k];
    return sum;
  };
  const typename Scene::V before = momentum_of_massless();
  const auto [impulse, work] =
      detail::apply_constraints(scene, field, field.velocity, dt, detail::wall_impulse_sink(scene, field));
  const typename Scene::V after = momentum_of_massless();
  for (int k = 0; k < Scene::D; ++k) scene.wall_impulse[k] += impulse[k] + (after[k] - before[k]);
  scene.driving_work += work;
}

/// Applies the constraints to all fields.
template <class Scene>
void constrain(Scene& scene, double dt) {
  for (auto& field : scene.fields) constrain(scene, field, dt);
}

/// Impulses between fields and with rigid bodies (`apply_impulses`), by contact order, then constraints again. The
/// first step also checks whether geostatic ground is at rest. dt: s.
template <class Scene>
void contact_impulses(Scene& scene, double dt) {
  scene.contact_tally = {};
  const auto without_contact = shared_detail::forces_from_rest(scene, dt);
  if constexpr (Scene::Needs::contact) {
    detail::for_each_contact(scene, 0, 2, [&](auto& part) {
      using P = std::remove_reference_t<decltype(part)>;
      if constexpr (applies_impulses<P, Scene>) {
        scene.contact_tally += detail::count_on_owner<P>(scene, part.apply_impulses(scene, dt));
        detail::share_nodes(
            scene, [](auto& field) -> auto& { return field.velocity; });
      }
    });
    constrain(scene, dt);
    scene.limited += scene.contact_tally.limited;
    scene.limited_momentum += scene.contact_tally.limited_momentum;
  }
  shared_detail::check_rest(scene, dt, without_contact);
}

/// Exchange of momentum at light nodes (`LightNodes`), or beside the faces of a grid (`redistribute_at_faces`);
/// nodes without mass follow those around them. dt: s.
template <class Scene>
void smooth_light_nodes(Scene& scene, [[maybe_unused]] double dt) {
  if constexpr (Scene::NumericsType::smooths_light_nodes) {
    for (auto& field : scene.fields)
      detail::change_velocities(scene, field.velocity, [&](auto to) {
        scene.light_nodes.template redistribute<typename Scene::Shape>(scene.mesh, field, scene.node_owner(),
                                                                       to);
      });
    constrain(scene, dt);
  } else if constexpr (!has_light_nodes<typename Scene::Shape>) {
    std::size_t exchanged = 0;
    for (auto& field : scene.fields)
      exchanged += redistribute_at_faces<typename Scene::Shape>(scene.mesh, field, field.velocity,
                                                                static_cast<typename Scene::T>(dt));
    if (exchanged > 0) constrain(scene, dt);
  }
  for (auto& field : scene.fields)
    detail::move_massless(scene, field, field.velocity, [&] { constrain(scene, field, dt); });
}

/// The correction of the nodes' velocities by a transfer that asks for it (XPIC, FMPM). What constraints
/// remove of it is an impulse of the walls. dt: s.
template <class Scene>
void correct_nodes(Scene& scene, [[maybe_unused]] double dt) {
  if constexpr (Scene::NumericsType::corrects_nodes) {
    const auto numerics = scene.numerics.in_step(dt);
    for (auto& field : scene.fields) start_correction(numerics, field);
    for (int k = 0; k < numerics.transfer.iterations(); ++k) {
      scene.for_each_body([&](const auto& body, auto& field) {
        map_residual(numerics, scene.mesh, scene.blocks, body, field);
      });
      for (auto& field : scene.fields) {
        detail::sum_nodes(scene, field.mapped_residual);
        finish_residual(numerics, field);
        scene.wall_impulse += constrain(scene.constraints, field.mass, field.residual, scene.node_owner(),
                                        detail::wall_impulse_sink<true>(scene, field));
        add_residual(field);
      }
    }
  }
}

/// MUSL: velocities mapped back from the points, constrained to what contact and constraints enforced. Before
/// they are constrained, the parts that read the final nodal velocities (`after_grid`) are called. dt: s.
template <class Scene>
void map_back(Scene& scene, [[maybe_unused]] double dt) {
  if constexpr (Scene::NumericsType::maps_back) {
    const auto numerics = scene.numerics.in_step(dt);
    scene.for_each_body(
        [&](auto& body, auto& field) { map_back(numerics, scene.mesh, scene.blocks, body, field); });
    for (auto& field : scene.fields) {
      detail::sum_nodes(scene, field.mapped);
      finish_map_back(numerics, field);
      if constexpr (!has_light_nodes<typename Scene::Shape>)
        redistribute_at_faces<typename Scene::Shape>(scene.mesh, field, field.mapped, typename Scene::T(0));
    }
  }
  scene.for_each_part([&](auto& part) {
    using P = std::remove_reference_t<decltype(part)>;
    if constexpr (records_after_grid<P, Scene>) {
      const double dissipation = part.after_grid(scene, dt);
      scene.contact_tally += detail::count_on_owner<P>(scene, ContactTally{.dissipation = dissipation});
    } else if constexpr (acts_after_grid<P, Scene>) {
      part.after_grid(scene, dt);
    }
  });
  if constexpr (Scene::NumericsType::maps_back) {
    const auto hold = [&](auto& part) {
      using P = std::remove_reference_t<decltype(part)>;
      if constexpr (constrains_mapped<P, Scene>) {
        const double dissipation = part.constrain_mapped(scene, dt);
        scene.contact_tally += detail::count_on_owner<P>(scene, ContactTally{.dissipation = dissipation});
        detail::share_nodes(
            scene, [](auto& field) -> auto& { return field.mapped; });
      }
    };
    detail::for_each_contact(scene, 0, 0, hold);
    for (auto& field : scene.fields)
      detail::apply_constraints(scene, field, field.mapped, dt,
                                detail::mapped_momentum_sink(scene, field, dt));
    detail::for_each_contact(scene, 1, 2, hold);
    for (auto& field : scene.fields)
      detail::move_massless(scene, field, field.mapped,
                            [&] { detail::apply_constraints(scene, field, field.mapped, dt); });
  }
}

/// G2P and the law, body by body; passes the work of the stresses to the parts that ask for it. dt: s.
template <class Scene>
void g2p(Scene& scene, double dt) {
  using N = typename Scene::NumericsType;
  const auto numerics = scene.numerics.in_step(dt);
  if constexpr (!N::strains_first) scene.finite = true;
  scene.for_each_body([&](auto& body, const auto& field) {
    if constexpr (!N::strains_first) detail::average_strains(scene, body, field, dt);
    G2pSums sums = g2p<typename Scene::Kinematics, Scene::Needs::stress_work>(
        numerics, scene.mesh, body, field, static_cast<typename Scene::T>(dt), scene.average);
    if (field.centred) sums.ending_work = 0;  // the stresses do not lead the velocities in time
    if constexpr (N::strains_first)
      detail::record_sums(scene, body, sums, body.finite);
    else
      detail::record_sums(scene, body, sums);
  });
}

/// Parts that move with the matter, or move the mesh (`follow_motion`). dt: s.
template <class Scene>
void follow(Scene& scene, double dt) {
  scene.for_each_part([&](auto& part) {
    if constexpr (follows_motion<std::remove_reference_t<decltype(part)>, Scene>) {
      part.follow_motion(scene, dt);
    }
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
