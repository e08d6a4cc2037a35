// Energy of a scene, balanced: what was put in, where it is, and what the numerics lost.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/parallel/communicator.hpp>
#include <arenite/part/part_energy.hpp>
#include <arenite/part/roles.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A part that keeps the energy balance of a scene: the work of stresses and accelerations, and the energy
/// that transfer and walls take, are summed at each step. Without it they are not computed. Energies in J.
///
/// The transfer takes the energy that the nodes gained and the points did not. Over a step the nodes gain
/// sum m (v - v_old) . (v_old + u) / 2, with the velocities v_old at its start, v at its end, and u that
/// gives the strain (MUSL: mapped back from the points, before walls and contact; else v). With u of the
/// points FLIP takes nothing, as it should. If u is v, the nodes begin the next step with another velocity
/// than the one that gave the strain: the work of its forces f over that half step,
/// dt f . (v_old - v_before) / 2, belongs to the transfer too, except at nodes that matter has just reached.
/// Walls take -J . (v_old + u) / 2 by their impulses J, and dt f . (u_c - u) if they constrain u to u_c.
struct TrackEnergy {
  using OnlyOne = TrackEnergy;
  static constexpr std::string_view state_name = "energy";
  double initial_kinetic = 0;  ///< of bodies and parts
  double initial_points = 0;   ///< of bodies
  double initial_strain = 0;   ///< recoverable, from initial stresses
  double initial_stored = 0;   ///< recoverable, in parts
  double initial_shared = 0;   ///< of both, in parts that several scenes share
  double stress_work = 0;      ///< work of the stresses: stored or used up plastically
  double gravity_work = 0;     ///< of the accelerations on the bodies
  double grid_gain = 0;        ///< kinetic energy that the nodes gained, see above
  double walls = 0;            ///< that walls took
  /// Velocities belong to the middle of a step, positions and stresses to its end: the effect of that half
  /// step on kinetic energy and works. It oscillates with the motion, and does not accumulate.
  double lag = 0;

  template <class Scene>
  void connect(const Scene& scene) {
    scene.for_each_body([&](const auto& body, const auto&) {
      initial_points += kinetic_energy(body);
      initial_strain += strain_energy(body);
    });
    const PartEnergy parts = energy_of_parts(scene), own = energy_of_parts(scene, false);
    initial_kinetic += initial_points + parts.kinetic;
    initial_stored += parts.stored;
    initial_shared = parts.kinetic + parts.stored - own.kinetic - own.stored;
    given_.reserve(3 * scene.fields.size() * scene.constraints.size());
    if constexpr (keeps_before<Scene>)
      before_.assign(scene.fields.size() * scene.fields[0].size() * (dim<Scene> + 1), 0);
  }
  /// Initial energy, J.
  double initial() const { return initial_kinetic + initial_strain + initial_stored; }
  void take_stress_work(double work, double ending_work) {
    stress_work += work;
    ending_ += ending_work;
  }
  template <class V>
  void take_wall_impulse(std::size_t field, Index node, const V& impulse) {
    given_.push_back({field, node, {}});
    for (int d = 0; d < V::RowsAtCompileTime; ++d)
      given_.back().impulse[static_cast<std::size_t>(d)] = static_cast<double>(impulse[d]);
  }
  template <class Scene>
  void after_p2g(const Scene& scene, double dt) {
    if constexpr (keeps_before<Scene>) {
      using V = typename Scene::V;
      constexpr bool first = Scene::NumericsType::strains_first;
      const auto acceleration = scene.acceleration();
      std::size_t at = 0;
      for (const auto& field : scene.fields) {
        const auto half_step = [&](auto&& work) {
          return dt / 2 * sum_nodes(scene, field, [&](std::size_t i) {
                   return field.sums[i].mass() > 0 ? static_cast<double>(work(i)) : 0.0;
                 });
        };
        const auto jump = [&](std::size_t i, const V& force, const V& now) {
          const double* const before = &before_[(at + i) * (dim<Scene> + 1)];
          double work = 0;
          if (!(static_cast<double>(field.sums[i].mass()) <= new_above * before[dim<Scene>])) return work;
          for (int d = 0; d < Scene::D; ++d)
            work += static_cast<double>(force[d]) * (static_cast<double>(now[d]) - before[d]);
          return work;
        };
        if constexpr (first) {  // u is known here: the velocities at the start, constrained by walls
          grid_gain +=
              half_step([&](std::size_t i) { return jump(i, field.sums[i].force(), field.velocity[i]); });
          walls -= half_step([&](std::size_t i) {
            const auto& sums = field.sums[i];
            return field.mass[i] > 0 ? sums.force().dot(sums.momentum() / sums.mass() - field.velocity[i])
                                     : 0;
          });
        } else {
          grid_gain -= half_step([&](std::size_t i) {
            const auto& sums = field.sums[i];
            return jump(i, sums.force() + sums.mass() * acceleration, sums.momentum() / sums.mass());
          });
        }
        at += field.size();
      }
    }
  }
  template <class Scene>
  void after_grid(const Scene& scene, double) {
    for (const auto& field : scene.fields)
      grid_gain += sum_nodes(scene, field, [&](std::size_t i) {
        if (!(field.mass[i] > 0)) return 0.0;
        return static_cast<double>(field.mass[i] *
                                   (field.velocity[i] - field.start[i]).dot(field.mean_velocity(i)));
      });
    for (const Given& g : given_) {
      const auto mean = scene.fields[g.field].mean_velocity(g.node);
      for (int d = 0; d < Scene::D; ++d)
        walls -= g.impulse[static_cast<std::size_t>(d)] * static_cast<double>(mean[d]);
    }
    given_.clear();
    walls += scene.driving_work - driven_;
    driven_ = scene.driving_work;
    if constexpr (keeps_before<Scene>) {
      std::size_t at = 0;
      for (const auto& field : scene.fields) {
        parallel_chunks(field.size(), [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            double* const before = &before_[(at + i) * (dim<Scene> + 1)];
            before[dim<Scene>] = static_cast<double>(field.mass[i]);
            for (std::size_t d = 0; d < dim<Scene> && field.mass[i] > 0; ++d)
              before[d] = static_cast<double>(field.velocity[i][static_cast<int>(d)]);
          }
        });
        at += field.size();
      }
    }
  }
  template <class Scene, class V>
  void take_mapped_momentum(const Scene& scene, double dt, std::size_t field, Index node, const V& momentum) {
    const auto& nodes = scene.fields[field];
    walls += dt * static_cast<double>(nodes.sums[node].force().dot(momentum) / nodes.mass[node]);
  }
  template <class Scene>
  void follow_motion(const Scene& scene, double dt) {
    const auto acceleration = scene.acceleration();
    double fallen = 0;
    for (const auto& field : scene.fields)
      fallen += sum_nodes(scene, field, [&](std::size_t i) {
        return dt * static_cast<double>(field.mass[i] * acceleration.dot(field.velocity[i]));
      });
    gravity_work += fallen;
    // With USF the stresses lag the velocities by half a step.
    constexpr double ahead = Scene::NumericsType::strains_first ? -1 : 1;
    lag = (ahead * std::exchange(ending_, 0) - fallen) / 2;
  }
  template <class F>
  void visit_state(F&& f) {
    f("initial_kinetic", initial_kinetic);
    f("initial_points", initial_points);
    f("initial_strain", initial_strain);
    f("initial_stored", initial_stored);
    f("initial_shared", initial_shared);
    f("stress_work", stress_work);
    f("gravity_work", gravity_work);
    f("grid_gain", grid_gain);
    f("walls", walls);
    f("driven", driven_);
    f("lag", lag);
    if (!before_.empty()) f("before", std::span(before_));
  }

 private:
  struct Given {
    std::size_t field;
    Index node;
    std::array<double, 3> impulse;  // N s
  };
  /// Whether the nodes begin the next step with other velocities than those that gave the strain.
  template <class Scene>
  static constexpr bool keeps_before = !Scene::NumericsType::maps_back;
  template <class Scene>
  static constexpr auto dim = static_cast<std::size_t>(Scene::D);

  /// Sum of `f(node)` over the nodes that the scene owns.
  template <class Scene, class Field, class F>
  static double sum_nodes(const Scene& scene, const Field& field, const F& f) {
    const auto owns = scene.node_owner();
    return parallel_reduce(
        field.size(), 0.0,
        [&](std::size_t begin, std::size_t end) {
          double sum = 0;
          for (std::size_t i = begin; i < end; ++i)
            if (owns(static_cast<Index>(i))) sum += f(i);
          return sum;
        },
        std::plus<>{});
  }

  std::vector<Given> given_;  // by walls in this step
  /// A node whose mass has grown by more than this factor in a step has just been reached by matter: before,
  /// it had almost no mass, and a meaningless velocity, 1e9 m/s and more.
  static constexpr double new_above = 4;

  // [fields x nodes x (D + 1)] velocity, m/s, and mass, kg, of the last step's end
  std::vector<double> before_;
  double driven_ = 0;  // work of driven walls until the last step, J
  double ending_ = 0;  // work of this step with the stresses at its end, J
};

/// Energies that the parts of a scene count. `shared`: also of parts that several scenes share.
template <class Scene>
PartEnergy energy_of_parts(const Scene& scene, bool shared = true) {
  PartEnergy sum{.external = scene.driving_work};
  scene.for_each_part([&](const auto& part) {
    using P = std::remove_cvref_t<decltype(part)>;
    if constexpr (counts_energy<P, Scene>)
      if (shared || !requires { P::is_shared; }) sum += part.count_energy();
  });
  return sum;
}

/// Whether a scene keeps the balance.
template <class Scene>
inline constexpr bool tracks_energy = Scene::template has_part<TrackEnergy>;

/// J. `residual` = kinetic + strain + stored + plastic + contact + transfer + walls - (initial + external +
/// inserted): only errors, of the time step, of contact and of laws; negative: energy lost.
struct Energies {
  double kinetic = 0;   ///< bodies and parts
  double strain = 0;    ///< recoverable
  double stored = 0;    ///< recoverable, in parts
  double plastic = 0;   ///< work of the stresses that is not recoverable
  double contact = 0;   ///< dissipated by friction, by inelastic contact and by other parts
  double external = 0;  ///< work of gravity, loads and prescribed motions
  double inserted = 0;  ///< of points inserted, minus that of points removed or lost
  double transfer = 0;  ///< taken by the transfer: positive if points have less than the nodes gave
  double walls = 0;     ///< taken by walls that stop matter
  double residual = 0;
  double lag = 0;  ///< of the residual: the effect of half a step (`TrackEnergy::lag`)
};

/// Needs a scene with `TrackEnergy`. Of a scene over a portion of a mesh: of all portions, which must all ask.
template <class Scene>
Energies energies(const Scene& scene) {
  static_assert(tracks_energy<Scene>, "energies: name TrackEnergy{} among the scene's parts");
  const auto& balance = scene.template part<TrackEnergy>();
  const bool shared = is_reporter(scene);
  const PartEnergy parts = energy_of_parts(scene, shared);
  Energies e;
  double inserted_strain = 0;
  scene.for_each_body([&](const auto& body, const auto&) {
    inserted_strain += body.inserted.strain_energy - body.removed.strain_energy - body.lost_strain;
    e.inserted += body.inserted.kinetic_energy - body.removed.kinetic_energy - body.lost_kinetic;
    e.kinetic += kinetic_energy(body);
    e.strain += strain_energy(body);
  });
  e.transfer = balance.initial_points + balance.grid_gain + e.inserted - e.kinetic;
  e.walls = balance.walls;
  e.inserted += inserted_strain;
  e.kinetic += parts.kinetic;
  e.stored = parts.stored;
  e.external = balance.gravity_work + parts.external;
  e.plastic = balance.stress_work - (e.strain - balance.initial_strain - inserted_strain);
  e.contact = parts.dissipated;
  e.residual = e.kinetic + e.strain + e.stored + e.plastic + e.contact + e.transfer + e.walls -
               balance.initial() - e.external - e.inserted;
  if (!shared) e.residual += balance.initial_shared;
  e.lag = balance.lag;
  sum_over(scene.communicator(), e.kinetic, e.strain, e.stored, e.plastic, e.contact, e.external, e.inserted,
           e.transfer, e.walls, e.residual, e.lag);
  return e;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
