// A row of the history, read off a scene of the drop.
#pragma once

#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>
#include <vector>

#include <arenite/observe/contact_force.hpp>
#include <arenite/observe/energy.hpp>
#include <arenite/observe/fill_ratio.hpp>

#include "../geometry/tilted.hpp"
#include "history.hpp"

namespace arenite::ffp {

/// The device at one step as the history needs it and as the scene has it (a slice's share).
struct DeviceState {
  double penetration, velocity;  ///< of the tip and of the centre of mass, positive down, m, m/s
  double reaction;               ///< contact force up, N
  std::size_t contact_nodes;
  std::vector<Index> touched;  ///< nodes at which the sand pushes
  double tilt = 0, aside = 0, aside_velocity = 0, aside_reaction = 0, spin = 0,
         moment = 0;  ///< see `HistoryRow`
};

template <class Scene>
DeviceState device_state(const Scene& scene, const DeviceStart& start) {
  DeviceState state{};
  state.reaction = contact_force<"device">(scene)[1];
  if constexpr (Scene::rigid_count > 0) {
    const auto& body = scene.template rigid<"device">();
    if constexpr (std::remove_cvref_t<decltype(body)>::rotates) {
      const Mat<double, 3> turned = body.orientation.matrix();
      const Vec<double, 3> centre = body.motion.centre(), axis = turned * start.axis();
      const Vec<double, 3> tip = centre + body.displacement + turned * (start.tip - centre);
      state.penetration = 0 - tip[1];
      state.aside = tip[0] - start.tip[0];
      state.tilt = std::atan2(-axis[0], axis[1]) * 180 / pi;
      state.aside_velocity = body.velocity[0];
      state.aside_reaction = body.force[0];
      state.spin = body.spin[2];
      state.moment = body.torque[2];
    } else {
      state.penetration = 0 - (start.tip[1] + body.displacement[1]);
    }
    state.velocity = -body.velocity[1];
    state.contact_nodes = body.contact_nodes;
    if constexpr (is_simplex_mesh<typename Scene::Mesh>)
      for (const auto& touch : body.touched_nodes)
        if (!touch.inside && body.impulse_at(touch, body.velocity).squaredNorm() > 0)
          state.touched.push_back(touch.node);
  } else {
    const auto& device = scene.template body<"device">();
    const auto& contact = scene.template part<Coulomb>();
    state.penetration = 0 - (start.tip[1] + scene.template part<MovingMesh>().travel());
    state.velocity = -momentum(device)[1] / mass(device);
    state.contact_nodes = scene.contact_tally.nodes;
    const auto& normals = contact.normals.out;
    const auto& soil = scene.fields[1 - contact.normals.body];
    for (Index i = 0; i < normals.size(); ++i)
      if (normals[i].squaredNorm() > 0 && soil.mass[i] > 0) state.touched.push_back(i);
  }
  return state;
}

/// A row of the history, of the scene as it stands; `before`: the row of the step before, null at the start.
template <class Scene>
HistoryRow history_row(const Scene& scene, const HistoryRow* before, const DeviceStart& start, double whole) {
  const DeviceState device = device_state(scene, start);
  const Energies e = energies(scene);
  const auto& soil = scene.template body<"soil">();
  HistoryRow row;
  row.time_s = scene.time;
  row.penetration_m = device.penetration;
  row.velocity_m_s = device.velocity;
  row.tilt_deg = device.tilt;
  row.aside_m = device.aside;
  row.aside_velocity_m_s = device.aside_velocity;
  row.aside_reaction_N = whole * device.aside_reaction;
  row.spin_rad_s = device.spin;
  row.moment_N_m = whole * device.moment;
  row.acceleration_m_s2 = before ? (before->velocity_m_s - device.velocity) / scene.time_step
                                 : -standard_gravity;  // it still falls freely
  row.reaction_N = whole * device.reaction;
  row.time_step_s = scene.time_step;
  row.kinetic_energy_J = whole * e.kinetic;
  row.strain_energy_J = whole * e.strain;
  row.plastic_work_J = whole * e.plastic;
  row.contact_dissipation_J = whole * e.contact;
  row.external_work_J = whole * e.external;
  row.transfer_loss_J = whole * e.transfer;
  row.wall_loss_J = whole * e.walls;
  row.energy_residual_J = whole * e.residual;
  row.lost_points = static_cast<double>(scene.lost_points());
  row.contact_nodes = static_cast<double>(device.contact_nodes);
  if constexpr (Scene::is_portion) {  // of the whole: only what sums over portions
    sum_over(scene.communicator(), row.lost_points);
    row.contact_nodes = row.fill_ratio = row.mean_volume_ratio = std::numeric_limits<double>::quiet_NaN();
    return row;
  }
  if constexpr (is_simplex_mesh<typename Scene::Mesh>)
    row.fill_ratio = fill_ratio(scene, soil, device.touched, scene.mesh.region_number("device"));
  else  // the penetrometer cuts the cells at it
    row.fill_ratio = std::numeric_limits<double>::quiet_NaN();
  row.mean_volume_ratio = mean_volume_ratio(soil);
  return row;
}

}  // namespace arenite::ffp
