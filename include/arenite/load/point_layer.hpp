// Point layer: the points under a part of a body's surface, which carry its area.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <arenite/core/bind.hpp>
#include <arenite/core/name.hpp>
#include <arenite/functions/place_function.hpp>
#include <arenite/particles/body.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Normal and layer thickness of a surface.
struct SurfaceOptions {
  VectorFunction normal = Triple{};  ///< outward normal, of any length; may depend on the position
  double thickness = std::numeric_limits<double>::quiet_NaN();  ///< of the layer, m

  void check() const {
    require(thickness > 0 && std::isfinite(thickness), "SurfaceOptions.thickness", thickness,
            "must be given, and positive");
  }
};

/// A layer of a body's points under its surface. Each point represents the area V / thickness, so that the
/// areas sum to that of the surface if the region is filled evenly and `thickness` is its own: a row of
/// points, or of cells. `Region`: any that `fill` takes.
template <class Region = AnyRegion>
struct PointLayer {
  BodyName body;
  Region region;
  SurfaceOptions options;

  using TypeErased = PointLayer<>;
  template <class M>
  TypeErased type_erased() const {
    if constexpr (std::same_as<Region, AnyRegion>)
      return *this;
    else
      return {body, AnyRegion::of<M::dimension>(region), options};
  }
};

/// `surface("bar", Box{{0.95, 0}, {1, 0.1}}, {.normal = {1, 0}, .thickness = 0.05})`: the points of the body,
/// by name or number, that lie in the region when the scene is made.
template <class Region>
PointLayer<Region> surface(BodyName body, Region region, SurfaceOptions options) {
  return {std::move(body), std::move(region), std::move(options)};
}

/// Of the only body.
template <class Region>
PointLayer<Region> surface(Region region, SurfaceOptions options) {
  return {"", std::move(region), std::move(options)};
}

/// Calls `f(p)` for the points of a body in a region.
template <class M, class B, class F>
void for_each_point_in(const M& mesh, const B& body, const AnyRegion& region, F&& f) {
  const auto numbers = region_numbers(mesh, region);
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    bool inside = false;
    if (region.test)
      inside = region.contains(body.points.position[p]);
    else if constexpr (is_simplex_mesh<M>)
      inside = mesh.is_in(body.points.cell[p], numbers);
    if (inside) f(p);
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
