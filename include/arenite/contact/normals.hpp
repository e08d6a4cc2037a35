// Normals between two bodies that share a node: from the gradients of their masses, or of a surface.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <arenite/contact/region_surface.hpp>
#include <arenite/core/bind.hpp>
#include <arenite/core/name.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Normals of contact, once bound to a mesh:
/// - `needs_mass_gradient`: whether the node fields carry the gradient of mass;
/// - `between(fields, a, b, i)`: unit normal out of body b towards body a at node i, zero if there is none;
/// - optional `connect(scene)`: called once, when all parts of the scene are bound.
template <class N, class Fields>
concept contact_normals = requires(const N normals, const Fields& fields) {
  { N::needs_mass_gradient } -> std::convertible_to<bool>;
  normals.between(fields, 0, 1, 0).squaredNorm();
};

/// From the gradients of the bodies' masses: works everywhere, blurred over a cell.
struct MassGradient {
  static constexpr bool needs_mass_gradient = true;

  template <class Fields>
  auto between(const Fields& fields, std::size_t a, std::size_t b, std::size_t i) const {
    using V = std::remove_cvref_t<decltype(fields[0].start[0])>;
    V normal = V::Zero();
    for (const auto& [f, sign] : {std::pair{b, 1}, std::pair{a, -1}}) {
      const V& g = fields[f].mass_gradient[i];
      const auto length = g.norm();
      if (length > 0) normal += (static_cast<typename V::Scalar>(sign) / length) * g;
    }
    const auto length = normal.norm();
    return V(length > std::numeric_limits<typename V::Scalar>::epsilon() ? V(normal / length) : V(V::Zero()));
  }
};

/// Of the surface of a mesh region that one of two bodies fills and keeps filling (an elastic device in a
/// mesh that moves with it).
struct SurfaceOf {
  std::string region;
  BodyName body = 1;  ///< which of the scene's bodies fills it: its name or number
};

/// Normals out of a region's surface, for every node of the mesh; zero at nodes that are not on the surface.
template <class T, int D>
struct NormalMap {
  static constexpr bool needs_mass_gradient = false;
  std::vector<Vec<T, D>> out;  ///< [nodes] unit, or zero
  std::size_t body = 0;        ///< the body that fills the region
  SurfaceOf recipe{};

  template <class Fields>
  Vec<T, D> between(const Fields&, std::size_t, std::size_t b, std::size_t i) const {
    return b == body ? out[i] : -out[i];
  }
  template <class Scene>
  void connect(const Scene& scene) {
    body = scene.number_of(recipe.body, "SurfaceOf.body");
    const auto surface = surface_of<typename Scene::Kinematics>(scene.mesh, recipe.region, scene.constraints,
                                                                Scene::is_portion);
    out.assign(scene.mesh.node_count(), Vec<T, D>::Zero());
    for (std::size_t k = 0; k < surface.nodes.size(); ++k) out[surface.nodes[k]] = surface.normals[k];
  }
};

template <class Traits>
NormalMap<typename Traits::T, Traits::D> bind_part(const SurfaceOf& normals, const Traits&) {
  static_assert(Traits::body_count == 2,
                "Scene: Coulomb contact with SurfaceOf is between two bodies; for more use MassGradient");
  return {{}, 0, normals};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
