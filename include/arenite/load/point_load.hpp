// Point load: a force on one material point.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>
#include <string>
#include <utility>

#include <arenite/core/name.hpp>
#include <arenite/functions/place_function.hpp>
#include <arenite/load/point_forces.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A force, N (of a metre of thickness, or of the full circle), on the point of a body that is nearest to a
/// place, m, among those of the cell that contains it, when the scene is made; it moves with the point. Its
/// local effect depends on the cell size, as that of a concentrated force on a mesh always does; total and
/// moment are exact.
struct PointLoad {
  BodyName body;
  Triple place;
  VectorFunction force;
};

/// `point_load("beam", {1, 0.1}, {0, -1_kN})`; or a force as a function of time, or of the point's place and
/// time, that returns (x, y, z).
inline PointLoad point_load(BodyName body, Triple place, VectorFunction force) {
  return {std::move(body), place, std::move(force)};
}
inline PointLoad point_load(BodyName body, Triple place, const Triple& force, const ScalarFunction& factor) {
  return {std::move(body), place, VectorFunction(force, factor)};
}
/// Of the only body.
inline PointLoad point_load(Triple place, VectorFunction force) { return {"", place, std::move(force)}; }
inline PointLoad point_load(Triple place, const Triple& force, const ScalarFunction& factor) {
  return {"", place, VectorFunction(force, factor)};
}

/// The load of `BoundPointForces`: the number is 1 of the loaded point.
template <class T, int D>
struct LoadedPoint {
  static constexpr int columns = 1;
  static constexpr bool deforms = false;
  BodyName body;
  Triple at;
  VectorFunction value;

  std::string name() const { return "point load"; }
  template <class Scene, class Body, class Set>
  void place(Scene& scene, const Body& of, Set&& set) const {
    Vec<T, D> x;
    for (int k = 0; k < D; ++k) x[k] = static_cast<T>(at[static_cast<std::size_t>(k)]);
    const Index c = scene.mesh.search(x);
    require(c != none || Scene::is_portion, "point load: place", vector_text(x), "must lie in the mesh");
    if (c == none) return;
    T least = std::numeric_limits<T>::infinity();
    Index nearest = none;
    for (const Index p : of.cells[c]) {
      const T distance = (of.points.position[p] - x).squaredNorm();
      if (distance < least) {
        least = distance;
        nearest = p;
      }
    }
    if (nearest != none) set(nearest, Vec<T, 1>(T(1)));
  }
  Vec<T, D> force(const Vec<T, D>& x, const Vec<T, 1>& share, double time) const {
    return share[0] * value_at(value, x, time, "point load");
  }
};

template <class Traits>
auto bind_part(const PointLoad& load, const Traits&) {
  using Load = LoadedPoint<typename Traits::T, Traits::D>;
  return BoundPointForces<typename Traits::T, Traits::D, Load>(Load{load.body, load.place, load.force});
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
