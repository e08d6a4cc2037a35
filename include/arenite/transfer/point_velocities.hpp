// Point velocities: what the points of a cell take from its nodes.
#pragma once

#include <arenite/transfer/affine.hpp>
#include <arenite/transfer/node_field.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/tensor_product.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The node velocities of one cell as its points take them: PIC and FLIP are both linear in them, so that a
/// blend needs one sum over the nodes, and a share of the point's own.
template <class N, class Cell>
struct PointVelocities {
  using Transfer = typename N::Transfer;
  using T = typename Cell::T;
  static constexpr std::size_t D = Cell::D, size = Cell::size;
  T kept = 0;                              ///< share of its own velocity that a point keeps
  NodeRows<T, Cell::D, Cell::size> taken;  ///< new node velocities, less `kept` times the old, m/s

  template <class Field>
  PointVelocities([[maybe_unused]] const N& numerics, const Cell& cell, const Field& nodes) {
    if constexpr (!Transfer::affine) kept = static_cast<T>(numerics.transfer.share);
    using V = NodePack<T, Cell::D>;
    repeat<size>([&](std::size_t i) {
      V value = nodes.velocity.pack(cell.nodes[i]);
      if constexpr (!Transfer::affine) value -= V(kept) * nodes.start.pack(cell.nodes[i]);
      taken.set(i, value);
    });
  }

  /// New velocities of a pack of points with weights w, stored.
  template <class P, class Points>
  std::array<P, D> take(const Cell& cell, Points& points, std::size_t first, int count,
                        const std::array<P, size>& w) const {
    std::array<P, D> sum;
    repeat<D>([&](std::size_t d) { sum[d] = P(0); });
    repeat<size>([&](std::size_t i) { repeat<D>([&](std::size_t d) { sum[d] += w[i] * P(taken[i][d]); }); });
    if constexpr (std::same_as<Transfer, Tpic>)
      points.motion.template store<P>(first, count, taken_gradient<P, D>(cell, taken));
    return store(points, first, count, sum);
  }

  /// The same for points at x where sums over the nodes are at hand: of the velocities, and (for APIC) with
  /// arms.
  template <class P, class Points>
  std::array<P, D> take([[maybe_unused]] const Cell& cell, Points& points, std::size_t first, int count,
                        [[maybe_unused]] const std::array<P, D>& x, const std::array<P, D>& sum,
                        [[maybe_unused]] const std::array<std::array<P, D>, D>& arms) const {
    if constexpr (Transfer::affine)
      points.motion.template store<P>(first, count, apic_gradient(cell, arms, x));
    return store(points, first, count, sum);
  }

 private:
  template <class P, class Points>
  std::array<P, D> store(Points& points, std::size_t first, int count, std::array<P, D> v) const {
    if constexpr (!Transfer::affine) {
      const auto own = points.velocity.template load<P>(first, count);
      repeat<D>([&](std::size_t d) { v[d] += P(kept) * own[d]; });
    }
    points.velocity.template store<P>(first, count, v);
    return v;
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
