// Thin walls of a rigid body, found when a scene is made: matter passes through a wall that is thinner than
// its contact can tell one side from the other.
#pragma once

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
#include <arenite/rigid/try_distance.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// A wall of a rigid body: two opposed faces.
struct ThinWall {
  double cells = std::numeric_limits<double>::infinity();  ///< thickness, in sizes of the cells there
  AnyDistance::Position face{}, other{};                   ///< places on its faces, m
};

/// Walks to the surface of a body and on through it, against the normal.
class WallProbe {
 public:
  using Position = AnyDistance::Position;

  /// In a scene of so many dimensions; walls from `safe` cells on are of no interest.
  WallProbe(const AnyDistance& distance, int dimension, double safe)
      : distance_{&distance}, dimension_{static_cast<std::size_t>(dimension)}, safe_{safe} {}

  /// The wall behind the face nearest to x, which lies at the distance d outside, in cells of this size, m.
  /// None where the body is thick, or where its faces are not opposed (within 18 deg): those of a wedge or a
  /// cone meet in a tip, which is no wall.
  std::optional<ThinWall> behind(const Position& x, double d, double cell) const {
    const auto out = normal(x, cell);
    const Position face = moved(x, out, -d);
    if (!(std::abs(at(face)) < 0.01 * cell)) return {};  // a distance that is not exact here
    double inside = 0, through = 0;
    for (int k = 1; k <= 4 && through == 0; ++k) {
      const double depth = k * safe_ * cell / 4;
      (at(moved(face, out, -depth)) > 0 ? through : inside) = depth;
    }
    if (through == 0) return {};
    for (int k = 0; k < 12; ++k) {
      const double middle = (inside + through) / 2;
      (at(moved(face, out, -middle)) > 0 ? through : inside) = middle;
    }
    const auto other = normal(moved(face, out, -through - 1e-3 * cell), cell);
    double cosine = 0;
    for (std::size_t k = 0; k < dimension_; ++k) cosine += out[k] * other[k];
    if (!(cosine < -0.95)) return {};
    return ThinWall{through / cell, face, moved(face, out, -through)};
  }

 private:
  double at(const Position& x) const { return tried_distances(*distance_, {x})[0]; }
  static Position moved(Position x, const Position& along, double by) {
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += by * along[k];
    return x;
  }
  /// Unit vector by central differences; not finite where there is no slope.
  Position normal(const Position& x, double cell) const {
    Position n{};
    double square = 0;
    for (std::size_t k = 0; k < dimension_; ++k) {
      Position ahead = x, behind = x;
      ahead[k] += 1e-4 * cell;
      behind[k] -= 1e-4 * cell;
      n[k] = at(ahead) - at(behind);
      square += n[k] * n[k];
    }
    for (double& component : n) component /= std::sqrt(square);
    return n;
  }

  const AnyDistance* distance_;
  std::size_t dimension_;
  double safe_;
};

/// The thinnest wall that is seen from two or more of the places beside a body's surface, in cells of these
/// sizes, m, and whose faces lie in the box of the mesh. Walks from at most 500 places.
inline std::optional<ThinWall> thinnest_wall(const AnyDistance& distance, const MeshPlaces& near,
                                             int dimension, double safe) {
  const auto d = tried_distances(distance, near.places);
  std::vector<std::size_t> beside;
  for (std::size_t k = 0; k < d.size(); ++k)
    if (d[k] > 0 && d[k] < 2 * near.sizes[k]) beside.push_back(k);
  const WallProbe probe(distance, dimension, safe);
  ThinWall thinnest;
  int seen = 0;
  for (const Index n : spread_numbers(beside.size(), 500)) {
    const std::size_t k = beside[n];
    const auto wall = probe.behind(near.places[k], d[k], near.sizes[k]);
    if (!wall || !near.covers(wall->face) || !near.covers(wall->other)) continue;
    ++seen;
    if (wall->cells < thinnest.cells) thinnest = *wall;
  }
  if (seen < 2) return {};
  return thinnest;
}

/// Warns of walls of a rigid body, called `rigid`, that are thinner than contact at nodes holds
/// (docs/components_contact.md): one cell. Looks from at most 4,000 places.
template <class Scene>
void warn_thin_walls(const Scene& scene, const AnyDistance& distance, const std::string& rigid) {
  constexpr double safe = 1;
  const auto near = mesh_places(scene, 4000, [&](const AnyDistance::Position& x, double size) {
    return !distance.is_beyond(x, 2 * size);
  });
  if (const auto wall = thinnest_wall(distance, near, Scene::D, safe * (1 - 1e-3)))
    warn(joined_text("rigid body ", rigid, ": a wall is ", std::round(100 * wall->cells) / 100,
                     " cells thick at ", vector_text(in_scene<Scene::D>(wall->face)),
                     " m: contact at nodes lets matter through walls below ", safe,
                     " cell; take smaller cells, a thicker wall, or PointContact, which holds with any"));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
