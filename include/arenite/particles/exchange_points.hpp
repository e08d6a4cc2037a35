// Points that leave a body and join it, as values. Between `find_cells` and `regroup`, which makes the lists
// of cells right again.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>
#include <vector>

#include <arenite/particles/body.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Adds a point of a law to totals: count, mass, momentum, kinetic and strain energy.
template <class L, class Points, class Point>
void add_to(PointTotals<Points::dimension>& totals, const L& law, const Points&, const Point& point) {
  const auto mass = static_cast<double>(point.mass);
  const Vec<double, Points::dimension> velocity = point.velocity.template cast<double>();
  totals += {1, mass, mass * velocity, mass * velocity.squaredNorm() / 2,
             static_cast<double>(point.volume * elastic_energy_of(law, point.stress, point.history))};
}

/// Removes the points for which `leaves(p)` is true from a body; `take(point)` gets each as a value. Returns
/// their totals.
template <class B, class Leaves, class Take>
auto take_out(B& body, Index cell_count, Leaves&& leaves, Take&& take) {
  auto& points = body.points;
  PointTotals<std::remove_cvref_t<decltype(points)>::dimension> totals;
  std::vector<Index> leaving;
  for (Index c = 0; c < cell_count; ++c) {
    leaving.clear();
    for (const Index p : body.cells[c])
      if (leaves(p)) leaving.push_back(p);
    // The last one first, as `leave` wants it: others change places with it.
    for (std::size_t k = leaving.size(); k-- > 0;) {
      const auto point = points[leaving[k]];
      add_to(totals, body.law, points, point);
      take(point);
      CellList::Move move{leaving[k], none};
      body.cells.leave(move, points.cell, [&](Index p, Index q) { points.swap(p, q); });
      body.cells.admit(move);
      body.moved = body.dropped = true;
    }
  }
  return totals;
}

/// Throws `error` for a point that cannot be added; names its index.
template <class B>
void check_point(const B& body, const typename B::Point& point, std::size_t number) {
  const auto name = [&](const char* member) {
    return joined_text({"point ", number, " to be added: ", member});
  };
  require(point.position.allFinite(), name("position"), vector_text(point.position), "must be finite");
  require(point.velocity.allFinite(), name("velocity"), vector_text(point.velocity), "must be finite");
  require(point.volume > 0 && std::isfinite(point.volume), name("volume"), point.volume,
          "must be given, positive");
  require(std::isnan(point.mass) || (point.mass > 0 && std::isfinite(point.mass)), name("mass"), point.mass,
          "must be positive, or NaN for the law's density times the volume");
  for (const auto& s : point.stress.c) require(std::isfinite(s), name("stress"), s, "must be finite");
  require(point.velocity_gradient.allFinite(), name("velocity_gradient"), point.velocity_gradient.norm(),
          "must be finite");
  require(std::isfinite(point.dilation), name("dilation"), point.dilation, "must be finite");
  std::apply(
      [&](const auto&... h) { (require(std::isfinite(h), name("history"), h, "must be finite"), ...); },
      point.history.members());
  for (const auto& value : point.part_columns)
    require(std::isfinite(value), name("part_columns"), value, "must be finite");
  require(body.points.size() + number < none - 1, name("number"), body.points.size() + number,
          "a body holds fewer than 2^32 points");
}

/// Adds points to a body, each in its cell; `id(point)` is the id it gets, where points have ids. Returns
/// their totals.
template <class B, class Id>
auto append_points(B& body, const std::vector<typename B::Point>& added, const std::vector<Index>& cell,
                   Id&& id) {
  auto& points = body.points;
  using T = typename std::remove_cvref_t<decltype(points)>::scalar;
  PointTotals<std::remove_cvref_t<decltype(points)>::dimension> totals;
  points.reserve_more(added.size());
  body.cells.reserve(points.size() + added.size());
  for (std::size_t k = 0; k < added.size(); ++k) {
    auto point = added[k];
    if (std::isnan(point.mass)) point.mass = static_cast<T>(body.law.density()) * point.volume;
    point.id = id(point);
    add_to(totals, body.law, points, point);
    points.push_back(point, cell[k]);
    body.cells.admit_new(static_cast<Index>(points.size() - 1));
  }
  points.reserve_spare();
  body.moved = body.moved || !added.empty();
  return totals;
}

/// Adds points to a body, each in the cell that contains it. Throws `error`, with nothing added, if one lies
/// outside the mesh or is not finite. Returns their totals.
template <class B, class M, class Id>
auto add_points(B& body, M& mesh, const std::vector<typename B::Point>& added, Id&& id) {
  std::vector<Index> cell;
  for (std::size_t k = 0; k < added.size(); ++k) {
    check_point(body, added[k], k);
    cell.push_back(mesh.search(added[k].position));
    require(cell.back() != none, {"point ", k, " to be added: position"}, vector_text(added[k].position),
            "must lie in the mesh");
  }
  return append_points(body, added, cell, id);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
