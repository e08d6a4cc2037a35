// Section forces: what one side of a cut through a body puts on the other.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <arenite/core/error.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/particles/region.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A plane cut, as thick as points must be looked for to find the stress on it: two cells or more.
struct Section {
  std::array<double, 3> through{};                              ///< any place on it, m
  std::array<double, 3> normal{};                               ///< any length
  double thickness = std::numeric_limits<double>::quiet_NaN();  ///< m
};

/// Every position: what a section goes through unless a region is given.
struct Everywhere {
  template <int D>
  bool contains(const Vec<double, D>&) const {
    return true;
  }
};

/// Force [D] on the body behind a section from the part in front of it, into which the normal points, N: the
/// integral of the traction, positive along the normal in tension. The stress of the points in the section is
/// weighted with a hat across it; `region` bounds the cut. In axisymmetry a force along the axis is that on
/// the full circle, the other component the sum of the radial tractions. `section_force<"pile">(scene,
/// {.through = {0, 1, 0}, .normal = {0, 1, 0}, .thickness = 0.1})`.
template <Name which = "", class Scene, class Region = Everywhere>
Vec<double, Scene::D> section_force(const Scene& scene, const Section& section, const Region& region = {}) {
  constexpr int D = Scene::D;
  static_assert(region_type<Region, D>, "section_force: the region must provide contains(position)");
  require(section.thickness > 0 && std::isfinite(section.thickness), "Section.thickness", section.thickness,
          "must be given, positive");
  const auto through = vector_argument<double, D>("Section.through", section.through);
  const Vec<double, D> normal = direction_argument<double, D>("Section.normal", section.normal).normalized();
  const auto& points = scene.template body<which>().points;
  const double half = section.thickness / 2;
  Vec<double, D> force = Vec<double, D>::Zero();
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vec<double, D> x = points.position[p].template cast<double>();
    const double distance = std::abs((x - through).dot(normal));
    if (distance >= half || !region.contains(x)) continue;
    const double share = (1 - distance / half) / half * static_cast<double>(points.volume[p]);
    const auto stress = points.stress[p];
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k) force[i] += share * static_cast<double>(stress(i, k)) * normal[k];
  }
  return force;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
