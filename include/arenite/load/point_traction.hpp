// Traction on the surface of a body: points near the surface carry its area and the load on it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>
#include <utility>

#include <arenite/load/point_forces.hpp>
#include <arenite/load/point_layer.hpp>
#include <arenite/load/surface_load.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A traction, Pa, on the surface of a body, wherever that goes. The points of a layer under the surface
/// carry area vectors, which turn and stretch with the matter (Nanson's formula); the load on its present
/// area acts on the points themselves, so that no node gets more force than its mass allows. The total force
/// is exact. Stresses near the surface are not: the load acts within the layer, whose points carry from none
/// of it to all. With a layer of half a cell they are off by 57 % in the last cell, 15 % in the next and 2 %
/// from the fourth on, wherever in a cell the surface lies. Matter that fills a mesh up to its faces takes
/// `traction(top(), ..)`, which is exact there.
template <class Region = AnyRegion>
struct PointTraction {
  PointLayer<Region> where;
  SurfaceLoad load;

  using TypeErased = PointTraction<>;
  template <class M>
  TypeErased type_erased() const {
    return {where.template type_erased<M>(), load};
  }
};

template <class Region>
PointTraction<Region> traction(PointLayer<Region> where, VectorFunction t) {
  return {std::move(where), SurfaceLoad(std::move(t))};
}
/// A vector, Pa, times a function of time (or of place and time).
template <class Region>
PointTraction<Region> traction(PointLayer<Region> where, const Triple& t, const ScalarFunction& factor) {
  return {std::move(where), SurfaceLoad(VectorFunction(t, factor))};
}
/// A pressure, Pa, against the outward normal.
template <class Region>
PointTraction<Region> pressure(PointLayer<Region> where, ScalarFunction p) {
  return {std::move(where), SurfaceLoad(std::move(p))};
}

/// The load of `BoundPointForces`: numbers are the area vector, m2.
template <class T, int D>
struct LoadedArea {
  static constexpr int columns = D;
  static constexpr bool deforms = true;
  BodyName body;
  AnyRegion region;
  SurfaceOptions options;
  SurfaceLoad load;
  std::string text;  // for messages

  const std::string& name() const { return text; }
  template <class Scene, class Body, class Set>
  void place(const Scene& scene, const Body& of, Set&& set) const {
    options.check();
    for_each_point_in(scene.mesh, of, region, [&](std::size_t p) {
      const Vec<T, D> x = of.points.position[p], n = value_at(options.normal, x, 0, "SurfaceOptions.normal");
      require(n.norm() > 0, "SurfaceOptions.normal", vector_text(n), "must be given");
      set(p, Vec<T, D>(of.points.volume[p] / static_cast<T>(options.thickness) * n.normalized()));
    });
  }
  Vec<T, D> force(const Vec<T, D>& x, const Vec<T, D>& area, double time) const {
    return load.force(x, area, time, text);
  }
  /// a' = tr(L) a - L^T a, the rate of J F^-T A.
  Vec<T, D> follow(const Vec<T, D>& area, const Mat<T, D>& gradient, T hoop, T dt) const {
    return area + dt * ((gradient.trace() + hoop) * area - gradient.transpose() * area);
  }
};

template <class Traits>
auto bind_part(const PointTraction<>& t, const Traits&) {
  using Load = LoadedArea<typename Traits::T, Traits::D>;
  return BoundPointForces<typename Traits::T, Traits::D, Load>(
      Load{t.where.body, t.where.region, t.where.options, t.load,
           joined_text({t.load.name(), " on the surface of a body", t.where.body.word.empty() ? "" : ", ",
                        t.where.body.word})});
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
