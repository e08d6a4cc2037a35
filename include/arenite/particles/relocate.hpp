// Relocation: each point in its cell, at the cost of one test for those that stayed.
#pragma once

#include <arenite/mesh/blocks.hpp>
#include <arenite/particles/body.hpp>

namespace arenite {
namespace detail {

/// Lists the points of a block's cells that have left their cells, from `moves` on; returns how many.
template <int Width, class B, class M>
Index find_moves(const B& body, const M& mesh, Index begin, Index end, CellList::Move* moves) {
  using T = typename M::scalar;
  using P = lanes_of<T, Width>;
  const auto& points = body.points;
  Index count = 0;
  for (Index c = begin; c < end; ++c) {
    if (body.cells.empty(c)) continue;
    const auto here = mesh.holder(c);
    body.cells.template for_packs<Width>(c, [&](Index first, int n) {
      const auto inside = here.holds(points.position.template load<P>(first, n)) || lanes_from<P>(n);
      if (all_of(inside)) return;
      for (Index p = first; p < first + static_cast<Index>(n); ++p) {
        const Index cell = mesh.walk(points.position[p], c);
        if (cell != c) moves[count++] = {p, cell};
      }
    });
  }
  return count;
}

}  // namespace detail

/// Finds the cell of each point, removes those that left the mesh (and counts them), and renews the list of
/// cells. Points that moved are guests of their cells until they are more than a sixteenth: then the columns
/// are sorted. `Width`: points tested at a time.
template <int Width, class B, class M>
void relocate(B& body, M& mesh, const Blocks& blocks) {
  auto& points = body.points;
  body.moves.resize(points.size() + body.cells.guests());
  body.move_count.resize(blocks.count());
  blocks.for_each_block([&](std::size_t b, Index begin, Index end) {
    body.move_count[b] =
        detail::find_moves<Width>(body, mesh, begin, end, body.moves.data() + body.cells.offset(begin));
  });
  bool moved = false, lost = false;
  for (std::size_t b = 0; b < blocks.count(); ++b)
    for (std::size_t k = body.move_count[b]; k-- > 0;) {
      auto move = body.moves[body.cells.offset(blocks.begin(static_cast<Index>(b))) + k];
      if (move.to == none) move.to = mesh.search(points.position[move.point]);
      moved = true;
      if (move.to == none) {
        lost = true;
        ++body.lost;
        body.lost_mass += static_cast<double>(points.mass[move.point]);
      }
      body.cells.leave(move, points.cell, [&](Index p, Index q) { points.swap(p, q); });
    }
  if (!moved) return;
  constexpr std::size_t crowd = 16;
  if (lost || body.cells.guests() * crowd > points.size()) {
    points.reorder(body.cells.sorted(points.cell, mesh.cell_count()));
    body.cells.build(points.cell, mesh.cell_count());
  } else {
    body.cells.seat_guests(points.cell);
  }
}

}  // namespace arenite
