// Thin walls of a rigid body, found when a scene is made: where contact at nodes cannot distinguish the
// sides of a wall, matter passes through.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/mesh/window_grid.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/warnings/try_distance.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// A wall of a rigid body: two opposed faces.
struct ThinWall {
  double thickness, safe, cell;           ///< m; least thickness that stops matter; size of the cells there
  AnyDistance::Position face{}, other{};  ///< places on its faces, m
};

/// Places beside a body from which walls are searched for.
struct WallPlaces {
  MeshPlaces close;
  std::vector<AnyDistance::Position> apart{};  ///< how far nodes are apart there, along each axis, m
};

/// Walks to the surface of a body and on through it, against the normal. Inside each face a row of nodes must
/// be touched that are nearer to it than to the other one, or nothing stops matter there: thickness / 2 +
/// reach may not be less than the spacing of nodes across the wall.
class WallProbe {
 public:
  using Position = AnyDistance::Position;

  /// For a body with this reach, in sizes of a cell.
  WallProbe(const AnyDistance& distance, double reach) : distance_{&distance}, reach_{reach} {}

  /// The wall inside the face nearest to x, which lies at the distance d outside, in cells of this size, m.
  /// None where the body is thick, or where its faces are not opposed (within 18 deg): those of a wedge or a
  /// cone join in a tip, which is no wall.
  std::optional<ThinWall> behind(const Position& x, double d, double cell, const Position& apart) const {
    const auto out = normal(x, cell);
    const Position face = moved(x, out, -d);
    if (!(std::abs(at(face)) < 0.01 * cell)) return {};  // a distance that is not exact here
    double rows = 0;
    for (std::size_t k = 0; k < out.size(); ++k) rows = std::max(rows, std::abs(out[k]) * apart[k]);
    const double safe = 2 * (rows - reach_ * cell);
    double inside = 0, through = 0;
    for (int k = 1; k <= 4 && through == 0; ++k) {
      const double depth = 1.001 * safe * k / 4;
      (at(moved(face, out, -depth)) > 0 ? through : inside) = depth;
    }
    if (!(through > 0)) return {};
    for (int k = 0; k < 12; ++k) {
      const double middle = (inside + through) / 2;
      (at(moved(face, out, -middle)) > 0 ? through : inside) = middle;
    }
    const auto other = normal(moved(face, out, -through - 1e-3 * cell), cell);
    double cosine = 0;
    for (std::size_t k = 0; k < out.size(); ++k) cosine += out[k] * other[k];
    if (!(cosine < -0.95)) return {};
    return ThinWall{through, safe, cell, face, moved(face, out, -through)};
  }

 private:
  double at(const Position& x) const { return tried_distances(*distance_, {x})[0]; }
  static Position moved(Position x, const Position& along, double by) {
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += by * along[k];
    return x;
  }
  /// Unit vector by central differences; not finite where there is no slope.
  Position normal(const Position& x, double cell) const {
    Position n = tried_differences(*distance_, x, 1e-4 * cell);
    const double size = std::hypot(n[0], n[1], n[2]);
    for (double& component : n) component /= size;
    return n;
  }

  const AnyDistance* distance_;
  double reach_;
};

/// The thinnest of the walls that do not stop matter, if two or more are found from the places, on faces
/// within the box of the mesh. Walks from at most 500 places.
inline std::optional<ThinWall> thinnest_wall(const AnyDistance& distance, const WallPlaces& look,
                                             double reach) {
  const MeshPlaces& close = look.close;
  const auto d = tried_distances(distance, close.places);
  std::vector<std::size_t> beside;
  for (std::size_t k = 0; k < d.size(); ++k)
    if (d[k] > 0 && d[k] < 2 * close.sizes[k]) beside.push_back(k);
  const WallProbe probe(distance, reach);
  std::optional<ThinWall> thinnest;
  int seen = 0;
  for (const Index n : spread_numbers(beside.size(), 500)) {
    const std::size_t k = beside[n];
    const auto wall = probe.behind(close.places[k], d[k], close.sizes[k], look.apart[k]);
    if (!wall || !close.covers(wall->face) || !close.covers(wall->other)) continue;
    ++seen;
    if (!thinnest || wall->thickness * thinnest->cell < thinnest->thickness * wall->cell) thinnest = wall;
  }
  return seen < 2 ? std::nullopt : thinnest;
}

/// Warns of walls of a rigid body, called `rigid`, that are too thin to stop matter by contact at nodes with
/// its reach (docs/components_contact.md#thin-walls). Searches from at most 4,000 places.
template <class Scene>
void warn_thin_walls(const Scene& scene, const AnyDistance& distance, double reach,
                     const std::string& rigid) {
  WallPlaces look{mesh_places(scene, 4000, [&](const AnyDistance::Position& x, double size) {
    return !distance.is_beyond(x, 2 * size);
  })};
  if (!is_reporter(scene)) return;
  [[maybe_unused]] const auto& whole = [&]() -> const auto& {
    if constexpr (is_window<typename Scene::Mesh>)
      return scene.mesh.whole();
    else
      return scene.mesh;
  }
  ();
  for (std::size_t k = 0; k < look.close.places.size(); ++k) {
    AnyDistance::Position apart;
    apart.fill(look.close.sizes[k]);
    if constexpr (is_simplex_mesh<typename Scene::Mesh>)
      apart.fill(std::sqrt(2.0) * look.close.sizes[k]);
    else if (const Index c =
                 whole.search(in_scene<Scene::D>(look.close.places[k]).template cast<typename Scene::T>());
             c != none)
      apart = in_space(whole.extent(c));
    look.apart.push_back(apart);
  }
  const auto wall = thinnest_wall(distance, look, reach);
  if (!wall) return;
  const auto hundredths = [](double x) { return std::round(100 * x) / 100; };
  const double cells = wall->thickness / wall->cell, safe = wall->safe / wall->cell;
  warn(joined_text({"rigid body ", rigid, ": a wall is ", hundredths(cells), " cells thick at ",
                    vector_text(in_scene<Scene::D>(wall->face)), " m: with a reach of ", reach,
                    " contact at nodes holds walls that are thicker than ", hundredths(safe),
                    "; take a reach above ", hundredths(reach + (safe - cells) / 2),
                    ", smaller cells, a thicker wall, or PointContact, which holds any"}));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
