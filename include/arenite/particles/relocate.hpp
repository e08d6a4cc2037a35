// Relocation: each point in its cell, at the cost of one test for those that stayed.
#pragma once

#include <arenite/mesh/blocks.hpp>
#include <arenite/particles/body.hpp>

namespace arenite {
namespace detail {

/// Lists the points of a block's cells that have left their cells.
template <int Width, class B, class M>
void find_moves(const B& body, const M& mesh, Index begin, Index end, std::vector<CellList::Move>& moves) {
  using T = typename M::scalar;
  using P = lanes_of<T, Width>;
  const auto& points = body.points;
  moves.clear();
  for (Index c = begin; c < end; ++c) {
    if (body.cells.empty(c)) continue;
    const auto here = mesh.holder(c);
    body.cells.template for_packs<Width>(c, [&](Index first, int count) {
      const auto inside = here.holds(points.position.template load<P>(first, count)) || lanes_from<P>(count);
      if (all_of(inside)) return;
      for (Index p = first; p < first + static_cast<Index>(count); ++p) {
        const Index cell = mesh.walk(points.position[p], c);
        if (cell != c) moves.push_back({p, cell});
      }
    });
  }
}

}  // namespace detail

/// Finds the cell of each point, removes those that left the mesh (and counts them), and renews the list of
/// cells. Points that moved are guests of their cells until they are more than a sixteenth: then the columns
/// are sorted. `Width`: points tested at a time.
template <int Width, class B, class M>
void relocate(B& body, M& mesh, const Blocks& blocks) {
  auto& points = body.points;
  body.moves.resize(blocks.count());
  blocks.for_each_block([&](std::size_t b, Index begin, Index end) {
    detail::find_moves<Width>(body, mesh, begin, end, body.moves[b]);
  });
  bool moved = false, lost = false;
  for (auto& moves : body.moves)
    for (std::size_t k = moves.size(); k-- > 0;) {
      auto move = moves[k];
      if (move.to == none) move.to = mesh.search(points.position[move.point]);
      moved = true;
      if (move.to == none) {
        lost = true;
        ++body.lost;
        body.lost_mass += static_cast<double>(points.mass[move.point]);
      }
      body.cells.leave(move, points.cell, [&](Index a, Index b) { points.swap(a, b); });
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
