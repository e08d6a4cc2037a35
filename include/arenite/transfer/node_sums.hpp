// Node sums: what a node collects from the points in one pass, side by side: one register with AVX-512.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <limits>

#include <arenite/core/tensor.hpp>
#include <arenite/transfer/channels.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A vector of a node as one pack: two lanes in the plane, four in space, of which the last is spare. Loops over nodes
/// compute with it: expressions of Eigen would cost each unit a class a term.
template <class T, int D>
using NodePack = Pack<T, D == 2 ? 2 : 4>;

template <int D, class T>
Vec<T, D> first_lanes(const T* lanes) {
  Vec<T, D> v;
  for (int k = 0; k < D; ++k) v[k] = lanes[k];
  return v;
}

/// Momentum, mass, internal force and, where functions have light nodes, the mass within reach of a node.
template <class T, int D>
struct alignas(8 * sizeof(T)) NodeSums {
  struct Spare {};
  using Lanes = NodeLanes<ChannelList<Channel<node_channel::Momentum, D>, Channel<node_channel::Mass, 1>>,
                          ChannelList<Channel<node_channel::Force, D>, Channel<Spare, 3 - D>,
                                      Channel<node_channel::ReachMass, 1>>>;
  static constexpr std::size_t mass_lane = Lanes::first(node_channel::mass),
                               force_lane = Lanes::first(node_channel::force),
                               reach_lane = Lanes::first(node_channel::reach_mass);
  std::array<T, Lanes::size> lane{};

  Vec<T, D> momentum() const { return first_lanes<D>(lane.data()); }            ///< kg m/s
  T mass() const { return lane[mass_lane]; }                                    ///< kg
  Vec<T, D> force() const { return first_lanes<D>(lane.data() + force_lane); }  ///< N
  NodePack<T, D> momentum_pack() const { return NodePack<T, D>::load(lane.data()); }
  NodePack<T, D> force_pack() const { return NodePack<T, D>::load(lane.data() + force_lane); }
  /// Sum of m_c (h_c |grad N|)^2, kg: see `LightNodes`. Of m_c where none is light; 0 where none can be.
  T reach() const { return lane[reach_lane]; }

  /// Adds a force, N.
  void add_force(const Vec<T, D>& force) {
    for (std::size_t k = 0; k < D; ++k) lane[force_lane + k] += force[static_cast<int>(k)];
  }

  /// Adds to momentum and mass, and to force and mass within reach.
  void add_values(const Pack<T, 4>& a) { (Pack<T, 4>::load(lane.data()) + a).store(lane.data()); }
  void add_slopes(const Pack<T, 4>& a) {
    (Pack<T, 4>::load(lane.data() + force_lane) + a).store(lane.data() + force_lane);
  }

  friend bool operator==(const NodeSums&, const NodeSums&) = default;
};

/// A node is light below this share of the mass within its reach: see `LightNodes`.
inline constexpr double least_light_share = 1.0 / 12;

/// Mass below which a node counts as one without, where functions fall to zero with a slope that does not,
/// kg: as a share of a light node's it is the least error, between what is left out and the round-off of a
/// velocity that its force would drive.
template <class T, int D>
T negligible_mass(const NodeSums<T, D>& sums) {
  constexpr auto root_of_epsilon = 1.0 / (std::int64_t{1} << std::numeric_limits<T>::digits / 2);
  return static_cast<T>(least_light_share * root_of_epsilon) * sums.reach();
}

/// Impulse of the forces over a step dt, s, on a node without mass, N s.
template <class T, int D>
NodePack<T, D> impulse_of_forces(const NodeSums<T, D>& sums, T dt) {
  return dt * sums.force_pack();
}

/// Only momentum and mass: where nothing reads the velocity at the start of the step nor the force
/// (`reads_start_state`), the impulse of the internal force over the step is part of the momentum.
template <class T, int D>
struct alignas(4 * sizeof(T)) NodeMomentum {
  std::array<T, 4> lane{};

  Vec<T, D> momentum() const { return first_lanes<D>(lane.data()); }  ///< kg m/s
  T mass() const { return lane[D]; }                                  ///< kg
  NodePack<T, D> momentum_pack() const { return NodePack<T, D>::load(lane.data()); }

  friend bool operator==(const NodeMomentum&, const NodeMomentum&) = default;
};

/// Impulse of the summed forces over dt, N s (zero if dt = 0).
template <class T, int D>
NodePack<T, D> impulse_of_forces(const NodeMomentum<T, D>& sums, T dt) {
  return dt > 0 ? sums.momentum_pack() : NodePack<T, D>(0);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
