// Point pack: a run of neighbours seen as one point whose quantities are packs, so that a kernel reads as the
// formula of one point.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/particles/points.hpp>
#include <arenite/simd/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// `count` <= `Width` points of one cell, from number `first` on. `Points_`: const where they are only read.
/// Lanes after the last point are 0; their positions repeat a point, so that they are valid.
template <class Points_, int Width>
struct PointPack {
  using Points = std::remove_const_t<Points_>;
  using T = typename Points::scalar;
  using P = lanes_of<T, Width>;
  static constexpr std::size_t D = Points::dimension;
  static constexpr int width = Width;

  Points_& points;
  std::size_t first;
  int count;

  auto position() const { return points.position.template load_repeated<P>(first, count); }  ///< [D], m
  auto velocity() const { return points.velocity.template load<P>(first, count); }           ///< [D], m/s
  P mass() const { return one(points.mass); }                                                ///< kg
  P volume() const { return one(points.volume); }                                            ///< m3
  auto stress() const { return points.stress.template load<P>(first, count); }               ///< `Sym`, Pa
  P stress(std::size_t k) const { return one(points.stress.column(k)); }  ///< one component, Pa
  /// Velocity gradient that the point carries (APIC, TPIC), [D x D] column by column, 1/s.
  auto velocity_gradient() const { return points.velocity_gradient.template load<P>(first, count); }
  /// Plastic volumetric strain of the previous step, -.
  P dilation() const {
    if constexpr (Points::has_dilation) return one(points.dilation);
    return P(0);
  }
  /// Mask of the points that are open and carry no stress.
  template <class L>
  auto is_open(const L& law) const {
    if constexpr (knows_opening<L, T>)
      return law.is_open(points.template load_history<P>(first, count));
    else
      return false;
  }

  void set_position(const std::array<P, D>& x) const { points.position.template store<P>(first, count, x); }
  void set_velocity(const std::array<P, D>& v) const { points.velocity.template store<P>(first, count, v); }
  void set_velocity_gradient(const std::array<P, D * D>& gradient) const {
    points.velocity_gradient.template store<P>(first, count, gradient);
  }
  void set_stress(const std::array<P, Sym<T, static_cast<int>(D)>::size>& s) const {
    points.stress.template store<P>(first, count, s);
  }

  /// Prefetches the columns of packs to come.
  template <class... Columns>
  void prefetch(const Columns&... columns) const {
    (prefetch_column(columns), ...);
  }

 private:
  P one(const Column<T>& column) const { return load_lanes<P>(column.data() + first, count); }
  void prefetch_column(const Column<T>& column) const { prefetch_ahead<Width>(column, first); }
  template <class Value, std::size_t N>
  void prefetch_column(const Columns<Value, T, N>& columns) const {
    columns.template prefetch_ahead<Width>(first);
  }
};

/// Calls `f(pack)` for the points of a cell.
template <int Width, class Points, class F>
ARENITE_INLINE void for_each_pack(const CellList& cells, Index cell, Points& points, F&& f) {
  cells.template for_packs<Width>(cell, [&](Index first, int count) {
    f(PointPack<Points, Width>{points, first, count});
  });
}

/// Calls `f(pack)` for the neighbours [begin, end).
template <int Width, class Points, class F>
ARENITE_INLINE void for_each_pack(Points& points, std::size_t begin, std::size_t end, F&& f) {
  for (std::size_t p = begin; p < end; p += Width)
    f(PointPack<Points, Width>{points, p, static_cast<int>(std::min<std::size_t>(Width, end - p))});
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
