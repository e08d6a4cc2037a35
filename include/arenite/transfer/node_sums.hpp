// Node sums: what a node collects from the points in one pass, as eight lanes that fill one register where
// registers are that wide.
#pragma once

#include <algorithm>
#include <array>

#include <arenite/core/lanes.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Momentum, mass and internal force of a node in eight scalars: momentum [D] and mass in the lower four,
/// force [D] in the upper four, whose last holds the mass within reach where the numerics ask for it; the
/// rest means nothing.
template <class T, int D>
struct alignas(8 * sizeof(T)) NodeSums {
  static constexpr std::size_t mass_lane = D, force_lane = 4, reach_lane = 7;
  std::array<T, 8> lane{};

  /// Whether any of `count` lanes from `first` on means something.
  static constexpr bool uses(std::size_t first, std::size_t count) {
    bool used = false;
    for (std::size_t k = first; k < first + count; ++k)
      used = used || k <= mass_lane || (k >= force_lane && k < force_lane + D);
    return used;
  }

  /// Whether any of them is more than the mass, which points hand over without a gradient.
  static constexpr bool has_gradient(std::size_t first, std::size_t count) {
    bool has = false;
    for (std::size_t k = first; k < first + count; ++k) has = has || (uses(k, 1) && k != mass_lane);
    return has;
  }

  Vec<T, D> momentum() const { return Eigen::Map<const Vec<T, D>>(lane.data()); }            ///< kg m/s
  T mass() const { return lane[mass_lane]; }                                                 ///< kg
  Vec<T, D> force() const { return Eigen::Map<const Vec<T, D>>(lane.data() + force_lane); }  ///< N
  /// Adds a force, N.
  void add_force(const Vec<T, D>& force) {
    for (std::size_t k = 0; k < D; ++k) lane[force_lane + k] += force[static_cast<int>(k)];
  }
  T reach() const { return lane[reach_lane]; }  ///< sum of m_c (h_c |grad N|)^2, kg: see `LightNodes`

  /// Adds four lanes to the lower or to the upper half.
  void add_lower(const Pack<T, 4>& a) { (Pack<T, 4>::load(lane.data()) + a).store(lane.data()); }
  void add_upper(const Pack<T, 4>& a) { (Pack<T, 4>::load(lane.data() + 4) + a).store(lane.data() + 4); }

  friend bool operator==(const NodeSums&, const NodeSums&) = default;
};

/// Eight scalars as packs of at most `Width` lanes.
template <class T, int Width>
struct EightLanes {
  static constexpr std::size_t width = static_cast<std::size_t>(std::min(Width, 8)), parts = 8 / width;
  using P = lanes_of<T, static_cast<int>(width)>;

  /// Part number `part` of eight lanes with one value in the lower four and another in the upper four.
  static P half_part(std::size_t part, T lower, T upper) {
    if constexpr (parts == 1)
      return blend(P(lower), P(upper), std::make_index_sequence<8>{});
    else
      return P(part < parts / 2 ? lower : upper);
  }

 private:
  template <std::size_t... I>
  static P blend(const P& lower, const P& upper, std::index_sequence<I...>) {
    return P::from(__builtin_shufflevector(lower.lanes(), upper.lanes(), (I < 4 ? I : I + 8)...));
  }
};

/// Writes eight columns of neighbouring points as rows of eight, one a point. `P`: packs as wide as those of
/// the rows, or of four lanes.
template <class Lanes, class T, class P>
void store_rows(const std::array<P, 8>& column, T* to) {
  constexpr std::size_t width = static_cast<std::size_t>(lane_count<P>);
  if constexpr (width == 1) {
    for (std::size_t k = 0; k < 8; ++k) to[k] = column[k];
  } else if constexpr (width < Lanes::width) {
    static_assert(width == 4);
    std::array<Pack<T, 8>, 4> row;
    repeat<4>([&](std::size_t k) { row[k] = detail::joined(column[k], column[k + 4]); });
    detail::transpose<1>(row);
    repeat<4>([&](std::size_t r) { row[r].store(to + r * 8); });
  } else {
    repeat<Lanes::parts>([&](std::size_t k) {
      std::array<P, width> row;
      repeat<width>([&](std::size_t r) { row[r] = column[k * width + r]; });
      detail::transpose<1>(row);
      repeat<width>([&](std::size_t r) { row[r].store(to + r * 8 + k * width); });
    });
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
