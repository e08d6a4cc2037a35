// Relocation: finds the cell of each point; a point that stayed in its cell costs one test.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <cstring>

#include <arenite/mesh/blocks.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/particles/body.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// Whether each of a pack's positions lies in the cell whose number stands in `cell` [lanes of P], as `walk` finds it. Of positions on the upper faces
/// of the mesh it says no.
template <class P, class M, std::size_t D>
bool all_in_cells(const M& grid, const std::array<P, D>& x, const Index* cell) {
  using T = typename M::scalar;
  using Mask = typename P::mask;
  typedef std::int32_t Numbers __attribute__((vector_size(sizeof(std::int32_t) * lane_count<P>)));
  Mask inside(true);
  Numbers number{};
  for (std::size_t axis = D; axis-- > 0;) {
    const auto k = static_cast<int>(axis);
    const auto first = static_cast<std::int32_t>(first_cell(grid, k)),
               count = static_cast<std::int32_t>(grid.cells(k));
    const P s = (x[axis] - P(grid.lower()[k])) * P(grid.inverse_edge());
    const auto in_mesh = s >= P(static_cast<T>(first)) && s < P(static_cast<T>(first + count));
    inside = inside && in_mesh;
    number = number * count +
             (__builtin_convertvector(select(in_mesh, s, P(static_cast<T>(first))).lanes(), Numbers) - first);
  }
  Numbers here;
  std::memcpy(&here, cell, sizeof here);
  return all_of(inside && Mask(__builtin_convertvector(number == here, typename Mask::vector)));
}

/// Lists the points of a block's cells that have left their cells, from `moves` on, those of a cell in the order of memory; returns the
/// number. Those that left a periodic mesh are wrapped into its box. Where cells are equal, points are visited in the order of memory,
/// whatever their cells: an unsorted point belongs to the block whose memory it is in, and all points after the runs to the last.
template <int Width, class B, class M>
Index find_moves(B& body, const M& mesh, Index begin, Index end, CellList::Move* moves) {
  using T = typename M::scalar;
  using P = lanes_of<T, Width>;
  auto& points = body.points;
  Index count = 0;
  const auto test = [&](Index p) {
    const Index here = points.cell[p];
    if constexpr (requires { mesh.wrapped(points.position[p]); })
      points.position.set(p, mesh.wrapped(points.position[p]));
    const Index cell = mesh.walk(points.position[p], here);
    if (cell != here) moves[count++] = {p, cell};
  };
  if constexpr (has_equal_cells<M> && Width > 1) {
    body.cells.template for_packs_in_memory<Width>(begin, end, points.size(), [&](Index first, int n) {
      if (n == Width &&
          all_in_cells(mesh, points.position.template load<P>(first, Width), points.cell.data() + first))
        return;
      for (int k = 0; k < n; ++k) test(first + static_cast<Index>(k));
    });
  } else {
    for (Index c = begin; c < end; ++c) {
      if (body.cells.empty(c)) continue;
      const auto here = mesh.holder(c);
      body.cells.template for_packs<Width>(c, [&](Index first, int n) {
        points.position.template prefetch_ahead<Width>(first);
        const auto inside = here.holds(points.position.template load<P>(first, n)) || lanes_from<P>(n);
        if (all_of(inside)) return;
        for (int k = 0; k < n; ++k)
          if (!in_lane(inside, k)) test(first + static_cast<Index>(k));
      });
    }
  }
  return count;
}

/// Removes the `count` points in `moves` from their cells, the last one first; each entry then has the new
/// place of its point.
template <class B>
void leave_cells(B& body, CellList::Move* moves, Index count) {
  constexpr Index ahead = 4;
  auto& points = body.points;
  for (Index k = count; k-- > 0;) {
    // A swap touches one cache line per column, far apart in memory: prefetched a few moves earlier.
    if (k >= ahead) points.prefetch(moves[k - ahead].point);
    body.cells.leave(moves[k], points.cell, [&](Index p, Index q) { points.swap(p, q); });
  }
}

}  // namespace detail

/// Finds the cell of each point. Those in no cell of the mesh are listed in `body.outside`. Lists of cells
/// are right again after `regroup`; until then points may leave (`take_out`) and join (`add_points`).
/// `Width`: points tested at a time.
template <int Width, class B, class M>
void find_cells(B& body, M& mesh, const Blocks& blocks) {
  auto& points = body.points;
  auto& cells = body.cells;
  body.moves.resize(points.size() + cells.unsorted());
  body.move_count.resize(blocks.count());
  blocks.for_each_block([&](std::size_t b, Index begin, Index end) {
    CellList::Move* const moves = body.moves.data() + cells.offset(begin);
    body.move_count[b] = detail::find_moves<Width>(body, mesh, begin, end, moves);
    detail::leave_cells(body, moves, body.move_count[b]);
  });
  for (std::size_t b = 0; b < blocks.count(); ++b) {
    const CellList::Move* const moves = body.moves.data() + cells.offset(blocks.begin(static_cast<Index>(b)));
    for (Index k = body.move_count[b]; k-- > 0;) {
      const auto& move = moves[k];
      body.moved = true;
      cells.admit(move);
      if (move.to != none) continue;
      // A walk may end at the hull of a mesh that is not convex.
      points.cell[move.point] = mesh.search(points.position[move.point]);
      if (points.cell[move.point] != none) continue;
      body.outside.push_back(move.point);
      body.dropped = true;
    }
  }
}

/// Counts the points outside of the mesh as lost; `regroup` drops them.
template <class B>
void lose_outside(B& body) {
  body.lost += body.outside.size();
  const auto& points = body.points;
  for (const Index p : body.outside) {
    body.lost_mass += static_cast<double>(points.mass[p]);
    const auto v = points.velocity[p];
    body.lost_kinetic += static_cast<double>(points.mass[p] * dot(v, v)) / 2;
    body.lost_strain += static_cast<double>(
        points.volume[p] * elastic_energy_of(body.law, points.stress[p], points.load_history(p)));
  }
}

/// Renews the lists of cells, and drops the points that are in none. Points that moved are unsorted points of
/// their cells until they are more than a sixteenth: then the columns take a new order. Returns whether they
/// did.
template <class B>
bool regroup(B& body, const Blocks& blocks) {
  if (!body.moved) return false;
  auto& points = body.points;
  auto& cells = body.cells;
  const bool leave = body.dropped;
  body.moved = body.dropped = false;
  body.outside.clear();
  cells.list_unsorted(points.cell);
  constexpr std::size_t crowd = 16;
  if (!leave && cells.unsorted() * crowd <= points.size()) return false;
  points.reorder(cells.order(blocks));
  cells.take_order();
  return true;
}

/// Finds the cell of each point, removes those that left the mesh (and counts them), and renews the list of
/// cells. Returns whether the columns took a new order.
template <int Width, class B, class M>
bool relocate(B& body, M& mesh, const Blocks& blocks) {
  find_cells<Width>(body, mesh, blocks);
  lose_outside(body);
  return regroup(body, blocks);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
