// Stresses of a cell of linear simplices: summed over its points, and averaged where it is filled.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/mesh/full_volume.hpp>
#include <arenite/particles/body.hpp>
#include <arenite/transfer/channels.hpp>
#include <arenite/transfer/point_pack.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace simplex {

/// Sums over the points of a cell that belong to its stress.
template <class T, int D>
struct StressSums {
  std::array<T, Sym<T, D>::size> stress;  ///< V times stress by component, N m
  T volume;                               ///< V, m3
  T closed;                               ///< V of the points that are not open, m3
  T dilation;                             ///< V times dilation, m3; 0 if the points have none
  T volume_factor = 1;                    ///< volume over which the cell carries its stress, over V, -
};

/// Internal forces of a cell: -(sum V sigma) grad w_i. The columns of the sum as packs, of which a node's
/// force is a sum, each times a component of its gradient.
template <class T, int D>
class CellForce {
 public:
  /// stress: by component, N m
  template <class Stress>
  explicit CellForce(const Stress& stress) {
    repeat<D>([&](std::size_t a) {
      const auto of = [&](std::size_t d) { return d < D ? -stress[Sym<T, D>::index(d, a)] : T(0); };
      column_[a] = pack4(of(0), of(1), of(2), T(0));
    });
  }
  template <class Gradient>
  Pack<T, 4> at(const Gradient& gradient) const {
    Pack<T, 4> force(0);
    repeat<D>([&](std::size_t a) { force += column_[a] * Pack<T, 4>(gradient[static_cast<int>(a)]); });
    return force;
  }

 private:
  std::array<Pack<T, 4>, D> column_;
};

/// Of the points of cell c of a body.
template <int Width, class L, class T, int D, ExtraColumns Extra>
StressSums<T, D> sum_stresses(const Body<L, T, D, Extra>& body, Index c) {
  using B = Body<L, T, D, Extra>;
  using P = lanes_of<T, Width>;
  using Sums =
      PointSums<P, 0, ChannelList<>,
                ChannelList<Channel<node_channel::Stress, Sym<T, D>::size>, Channel<node_channel::Volume, 1>,
                            Channel<node_channel::Open, B::knows_opening>,
                            Channel<node_channel::Dilation, B::has_dilation>>>;
  Sums sums;
  for_each_pack<Width>(body.cells, c, body.points, [&](const auto& p) {
    p.prefetch(body.points.stress, body.points.volume);
    const auto stress = p.stress();
    const P volume = p.volume();
    repeat<Sym<T, D>::size>(
        [&](std::size_t k) { sums.add_to_cell(node_channel::stress, k, volume * stress[k]); });
    sums.add_to_cell(node_channel::volume, 0, volume);
    sums.add_to_cell(node_channel::open, 0, select(p.is_open(body.law), volume, P(0)));
    if constexpr (B::has_dilation) p.prefetch(body.points.dilation);
    sums.add_to_cell(node_channel::dilation, 0, volume * p.dilation());
  });
  const typename Sums::Total total(sums);
  const T volume = total.cell(node_channel::volume);
  StressSums<T, D> of_cell{
      {}, volume, volume - total.cell(node_channel::open), total.cell(node_channel::dilation)};
  total.copy(node_channel::stress, of_cell.stress);
  return of_cell;
}

/// `ElementAverage`: gives the points of a filled cell their mean stress, which it carries over its whole
/// volume; open points carry none. Updates the sums accordingly.
template <class K, class N, class M, class B, class T, int D>
void average_stress(const N& numerics, const M& mesh, B& body, Index c, StressSums<T, D>& sums) {
  if constexpr (N::AntiLocking::averages_stress) {
    constexpr int width = N::template width<T>;
    using P = lanes_of<T, width>;
    const T of_cell = full_volume<K>(mesh, c);
    if (!(sums.volume >= static_cast<T>(numerics.anti_locking.fill) * of_cell)) return;
    const T closed = sums.closed > 0 ? sums.closed : sums.volume;
    std::array<P, Sym<T, D>::size> mean;
    repeat<mean.size()>([&](std::size_t k) { mean[k] = P(sums.stress[k] / closed); });
    for_each_pack<width>(body.cells, c, body.points, [&](const auto& p) {
      const auto open = p.is_open(body.law);
      auto stress = mean;
      repeat<mean.size()>([&](std::size_t k) { stress[k] = select(open, P(0), mean[k]); });
      p.set_stress(stress);
    });
    sums.volume_factor = of_cell / sums.volume;
    for (T& component : sums.stress) component *= sums.volume_factor;
  }
}

}  // namespace simplex
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
