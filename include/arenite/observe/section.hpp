// Section forces: the force of one side of a cut through a body on the other.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/fill/region.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A plane cut, thick enough to contain the points that give the stress on it: two cells or more.
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

/// Force [D], N, by the side of a section into which the normal points on the other side: the integral of
/// the traction, positive along the normal in tension. The stress of the points in the section is
/// weighted with a hat across it; `region` bounds the cut. In axisymmetry a force along the axis is that on
/// the full circle, the other component the sum of the radial tractions. `section_force<"pile">(scene,
/// {.through = {0, 1, 0}, .normal = {0, 1, 0}, .thickness = 0.1})`. On coarse simplices see
/// `nodal_section_force`.
template <class Scene, class B, class Region = Everywhere>
Vec<double, Scene::D> section_force(const Scene& scene, const B& body, const Section& section,
                                    const Region& region = {}) {
  constexpr int D = Scene::D;
  static_assert(region_type<Region, D>, "section_force: the region must provide contains(position)");
  require(section.thickness > 0 && std::isfinite(section.thickness), "Section.thickness", section.thickness,
          "must be given, positive");
  const auto through = vector_argument<double, D>("Section.through", section.through);
  const Vec<double, D> normal = direction_argument<double, D>("Section.normal", section.normal).normalized();
  const auto& points = body.points;
  const double half = section.thickness / 2;
  Vec<double, D> force = zeros<Vec<double, D>>();
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vec<double, D> x = points.position[p].template cast<double>();
    const double distance = std::abs((x - through).dot(normal));
    if (distance >= half || !region.contains(x)) continue;
    const double share = (1 - distance / half) / half * static_cast<double>(points.volume[p]);
    const auto stress = points.stress[p];
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k) force[i] += share * static_cast<double>(stress(i, k)) * normal[k];
  }
  sum_over(scene.communicator(), force);
  return force;
}
template <Name which = "", class Scene, class Region = Everywhere>
Vec<double, Scene::D> section_force(const Scene& scene, const Section& section, const Region& region = {}) {
  return section_force(scene, scene.template body<which>(), section, region);
}

/// The section force in the momentum balance of the nodes, through a cut of the whole body: the internal forces of the
/// body's nodes, each for the share of its mass that is of points in front of the cut. Both sides get
/// opposite forces, and at rest each is in balance with its weight to what forces are out of balance, also
/// where stresses jump from cell to cell: a cantilever of linear triangles, two cells high, has its shear
/// force to 0.01 %, where the stresses of points miss 3.5 %. A point in the section is on both sides, as far
/// as the hat reaches. Walls and contact at nodes of the section count for each side by its share of mass,
/// and radial forces in axisymmetry go without the hoop.
template <class Scene, class B>
Vec<double, Scene::D> nodal_section_force(const Scene& scene, const B& body, const Section& section) {
  constexpr int D = Scene::D;
  using V = Vec<double, D>;
  using Shape = typename Scene::Shape;
  require(section.thickness > 0 && std::isfinite(section.thickness), "Section.thickness", section.thickness,
          "must be given, positive");
  const V through = vector_argument<double, D>("Section.through", section.through);
  const V normal = direction_argument<double, D>("Section.normal", section.normal).normalized();
  // Of each node: mass, kg; that of points in front of the cut; internal force, N, with its sign turned.
  constexpr std::size_t size = 2 + D;
  std::vector<double> nodes(size * static_cast<std::size_t>(Shape::node_count(scene.mesh)));
  const auto& points = body.points;
  for (Index c = 0; c < scene.mesh.cell_count(); ++c) {
    if (body.cells.empty(c)) continue;
    const typename Shape::template Cell<typename Scene::Mesh> cell(scene.mesh, c);
    for (const Index p : body.cells[c]) {
      const auto x = points.position[p];
      const auto w = cell.weights(x);
      const auto gradient = cell.gradients(x);
      const auto stress = points.stress[p];
      const double distance = (x.template cast<double>() - through).dot(normal),
                   place = std::clamp(2 * distance / section.thickness, -1.0, 1.0),
                   share = place < 0 ? square(1 + place) / 2 : 1 - square(1 - place) / 2;
      for (int i = 0; i < static_cast<int>(cell.nodes.size()); ++i) {
        double* const node = &nodes[size * cell.nodes[static_cast<std::size_t>(i)]];
        const double mass = static_cast<double>(points.mass[p]) * static_cast<double>(w[i]);
        node[0] += mass;
        node[1] += share * mass;
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b)
            node[2 + a] += static_cast<double>(points.volume[p]) * static_cast<double>(stress(a, b)) *
                           static_cast<double>(gradient(b, i));
      }
    }
  }
  const auto owns = scene.node_owner();
  if constexpr (Scene::is_portion) scene.communicator().sum_nodes(std::span<double>(nodes), size);
  V force = zeros<V>();
  for (std::size_t n = 0; n < nodes.size(); n += size)
    if (nodes[n] > 0 && owns(static_cast<Index>(n / size)))
      for (int a = 0; a < D; ++a)
        force[a] += nodes[n + 1] / nodes[n] * nodes[n + 2 + static_cast<std::size_t>(a)];
  sum_over(scene.communicator(), force);
  return force;
}

template <Name which = "", class Scene>
Vec<double, Scene::D> nodal_section_force(const Scene& scene, const Section& section) {
  return nodal_section_force(scene, scene.template body<which>(), section);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
