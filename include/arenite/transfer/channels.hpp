// Channels: named quantities that P2G sums. A channel has as many scalars as a composition needs; with none,
// loops over it are empty. The compiler packs them into lanes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <concepts>
#include <cstddef>

#include <arenite/simd/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace node_channel {

// Of a node, with the weights w of the points.
struct Momentum {};
struct Mass {};
struct Force {};
struct ReachMass {};
struct MassGradient {};
struct HoopForce {};
inline constexpr Momentum momentum{};     ///< sum m w v, kg m/s
inline constexpr Mass mass{};             ///< sum m w, kg
inline constexpr Force force{};           ///< internal: -sum V sigma grad w, N
inline constexpr ReachMass reach_mass{};  ///< sum of m_c (h_c |grad w|)^2 over cells, kg: see `LightNodes`
inline constexpr MassGradient mass_gradient{};  ///< sum m grad w, kg/m
inline constexpr HoopForce hoop_force{};        ///< sum V sigma_hoop w / r in axisymmetry, N

// Of a cell.
struct Stress {};
struct Volume {};
struct Open {};
struct Dilation {};
struct EdgeMass {};
struct HoopMean {};
inline constexpr Stress stress{};       ///< sum V sigma, N m
inline constexpr Volume volume{};       ///< sum V, m3
inline constexpr Open open{};           ///< sum V of the points that are open, m3
inline constexpr Dilation dilation{};   ///< sum V times plastic volumetric strain of the previous step, m3
inline constexpr EdgeMass edge_mass{};  ///< sum m w_i w_j, kg
inline constexpr HoopMean hoop_mean{};  ///< sum V w_i / r in axisymmetry, m2

}  // namespace node_channel

/// Four scalars as a pack. (`Pack::set` would take it through memory.)
template <class T>
Pack<T, 4> pack4(T a, T b, T c, T d) {
  return Pack<T, 4>::from(typename Pack<T, 4>::vector{a, b, c, d});
}

/// `Count` scalars of a name.
template <class Name_, std::size_t Count_>
struct Channel {
  using Name = Name_;
  static constexpr std::size_t count = Count_;
};

/// Channels side by side.
template <class... C>
struct ChannelList {
  static constexpr std::size_t size = (C::count + ... + 0);
  /// Scalars of a channel; 0 if it is not in the list.
  template <class Name>
  static constexpr std::size_t count(Name) {
    return ((std::same_as<Name, typename C::Name> ? C::count : 0) + ... + 0);
  }
  /// Place of its first scalar.
  template <class Name>
  static constexpr std::size_t first(Name) {
    std::size_t place = 0;
    bool found = false;
    ((found = found || std::same_as<Name, typename C::Name>, place += found ? 0 : C::count), ...);
    return place;
  }
};

/// Lanes of the sums at a node: `Values`, quantities of points times the value w_i of a node's function (and
/// w_i (x_i - x_p), where they are linear around the point), in the first fours; then `Slopes`, quantities
/// times grad w_i. The other lanes are padding.
template <class Values, class Slopes>
struct NodeLanes {
  static constexpr std::size_t slopes = (Values::size + 3) / 4 * 4,
                               size =
                                   Slopes::size == 0 && slopes == 4 ? 4 : (slopes + Slopes::size + 7) / 8 * 8;
  template <class Name>
  static constexpr std::size_t count(Name name) {
    return Values::count(name) + Slopes::count(name);
  }
  template <class Name>
  static constexpr std::size_t first(Name name) {
    return Values::count(name) > 0 ? Values::first(name) : slopes + Slopes::first(name);
  }
};

/// Sums over the points of a cell in packs P: `OfNode` for each of its nodes, `OfCell` once. A node's sums
/// are padded to four, so that one load reads what one store wrote (store forwarding).
template <class P, std::size_t Nodes, class OfNode, class OfCell>
class PointSums {
  static constexpr std::size_t stride = (OfNode::size + 3) / 4 * 4, cell = Nodes * stride,
                               size = cell + OfCell::size;

 public:
  PointSums() {
    repeat<size>([&](std::size_t k) { lane_[k] = P(0); });
  }

  /// Adds to a channel of node i: `factor` times the values [count], or one value.
  template <class Name, class Values>
  void add(std::size_t i, Name name, const P& factor, const Values& value) {
    repeat<OfNode::count(Name{})>(
        [&](std::size_t k) { lane_[i * stride + OfNode::first(name) + k] += factor * value[k]; });
  }
  template <class Name>
  void add(std::size_t i, Name name, const P& value) {
    repeat<OfNode::count(Name{})>(
        [&](std::size_t k) { lane_[i * stride + OfNode::first(name) + k] += value; });
  }
  /// Adds to scalar k of a channel of the cell.
  template <class Name>
  void add_to_cell(Name name, std::size_t k, const P& value) {
    repeat<OfCell::count(Name{}) != 0>([&](std::size_t) { lane_[cell + OfCell::first(name) + k] += value; });
  }

  /// The sums over the lanes.
  class Total {
   public:
    using T = std::remove_cvref_t<decltype(lane_sums(std::declval<std::array<P, size>>())[0])>;
    // Where they stay: g++ 12 copies an array that is returned out of a nested block.
    explicit Total(const PointSums& sums) : lane_{lane_sums(sums.lane_)} {}

    /// The channels of node i, in their order.
    Pack<T, 4> node(std::size_t i) const { return Pack<T, 4>::load(&lane_[i * stride]); }
    /// A scalar of a channel; 0 if it is absent.
    template <class Name>
    T node(std::size_t i, Name name) const {
      return OfNode::count(Name{}) == 0 ? T(0) : lane_[i * stride + OfNode::first(name)];
    }
    template <class Name>
    T cell(Name name, std::size_t k = 0) const {
      return OfCell::count(Name{}) == 0 ? T(0) : lane_[PointSums::cell + OfCell::first(name) + k];
    }
    /// Copies a channel, unless it is absent.
    template <class Name, class To>
    void copy(Name name, To& to) const {
      repeat<OfCell::count(Name{})>([&](std::size_t k) { to[k] = cell(name, k); });
    }

   private:
    decltype(lane_sums(std::declval<std::array<P, size>>())) lane_;
  };

 private:
  std::array<P, size> lane_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
