// Splitting of points that are too large for their cell, so that matter which flows into finer cells does not
// thin out there.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/mesh/full_volume.hpp>
#include <arenite/scene/insert_remove.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// When points split.
struct SplitOptions {
  /// A point splits if its volume exceeds 1 / per_cell of that of its cell, >= 1.
  double per_cell = 4;
};

namespace detail {

/// The places of the points that a point of volume V splits into: the corners of a square or cube of half the
/// edge of one with its volume, around it.
template <class K, class T, int D>
std::array<Vec<T, D>, (1 << D)> split_places(const Vec<T, D>& x, T volume) {
  const double size = std::pow(static_cast<double>(volume / K::thickness(x)), 1.0 / D);
  std::array<Vec<T, D>, (1 << D)> places;
  for (std::size_t k = 0; k < places.size(); ++k)
    for (int a = 0; a < D; ++a)
      places[k][a] = x[a] + static_cast<T>((k >> a & 1) != 0 ? size / 4 : -size / 4);
  return places;
}

/// Whether cells belong to the same region of the mesh.
template <class M>
bool same_region(const M& mesh, Index a, Index b) {
  if constexpr (requires { mesh.region(a); })
    return mesh.region(a) == mesh.region(b);
  else
    return true;
}

}  // namespace detail

/// Splits each point of a body, by name or number, that is too large for its cell into four in the
/// plane, eight in space: equal shares of its mass and volume on the corners of a square around it, with its
/// velocity, stress and history. Mass, momentum, angular momentum and both energies are kept to round-off.
/// (A point's velocity gradient stays that of its parts, which do not take the velocities that it has where
/// they lie: those would add angular momentum.) A point stays whole where a part would lie outside of the
/// mesh or in another of its regions. Parts are checked again in the next call. With `PointIds` all parts
/// get new ids. Returns how many points split.
template <Name which = "", class Scene>
std::size_t split_points(Scene& scene, const SplitOptions& options = {}) {
  require(options.per_cell >= 1 && std::isfinite(options.per_cell), "SplitOptions.per_cell", options.per_cell,
          "must be at least 1");
  using T = typename Scene::T;
  using K = typename Scene::Kinematics;
  constexpr int D = Scene::D;
  static_assert(!Scene::is_portion, "split_points: a scene over a portion of a mesh cannot split points yet");
  auto& body = scene.template body<which>();
  static_assert(std::remove_cvref_t<decltype(body.points)>::part_column_count == 0,
                "split_points: a part of the scene keeps numbers with each point, which do not say how they "
                "split (tractions on points, point loads)");
  using Point = typename std::remove_cvref_t<decltype(body)>::Point;
  std::vector<Point> parts;
  std::vector<Index> cells;
  // A cell's points are not in it any more for sure: they moved since they were sorted.
  const auto splits = [&](Index p) {
    const Vec<T, D> x = body.points.position[p];
    const Index c = scene.mesh.walk(x, body.points.cell[p]);
    if (c == none) return false;
    const T volume = body.points.volume[p];
    if (!(static_cast<double>(volume) * options.per_cell >
          static_cast<double>(full_volume<K>(scene.mesh, c)) * (1 + 1e-6)))
      return false;
    const auto places = detail::split_places<K, T, D>(x, volume);
    std::array<Index, (1 << D)> in{};
    for (std::size_t k = 0; k < places.size(); ++k) {
      in[k] = scene.mesh.walk(places[k], c);
      if (in[k] == none || !detail::same_region(scene.mesh, in[k], c)) return false;
    }
    auto part = body.points[p];
    part.mass /= static_cast<T>(places.size());
    part.volume /= static_cast<T>(places.size());
    part.id = no_id;
    for (std::size_t k = 0; k < places.size(); ++k) {
      part.position = places[k];
      parts.push_back(part);
      cells.push_back(in[k]);
    }
    return true;
  };
  const auto gone = take_out(body, scene.mesh.cell_count(), splits, [](const auto&) {});
  append_points(body, parts, cells, [&](const Point& p) { return detail::id_for(scene, p); });
  if (gone.count > 0 && regroup(body, scene.blocks)) scene.balance_threads();
  return gone.count;
}

/// A part of a scene that calls `split_points` for a body once in `every` steps:
/// `SplitPoints<"sand">{{.per_cell = 9}}`.
template <Name which = "">
struct SplitPoints {
  SplitOptions options{};
  std::size_t every = 10;  ///< steps; 0: never
  std::size_t split = 0;   ///< points that have split so far
  static constexpr bool reads_start_state = false;
  static constexpr std::string_view state_name = "split";

  template <class Scene>
  void renew_points(Scene& scene) {
    if (every > 0 && scene.steps % every == 0) split += split_points<which>(scene, options);
  }
  template <class F>
  void visit_state(F&& f) {
    f("points", split);
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
