// Whether the values that a scene is made of are complete and in order: one sentence for each mistake, before
// anything else is compiled.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <type_traits>

#include <arenite/core/refusals.hpp>
#include <arenite/mesh/kinematics.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/part/parts.hpp>
#include <arenite/shape/shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// In the place of the kinematics of a scene that the compiler has refused.
struct Refused {};
template <bool Complete, class K>
using refused_unless = std::conditional_t<Complete, K, Refused>;

template <class N>
concept numerics_type = requires {
  typename N::Shape;
  typename N::Transfer;
  typename N::AntiLocking;
};

/// Stops the compiler with the cure for the first mistake.
template <class K, class M, class N, class... Given>
constexpr bool is_complete_scene() {
  constexpr bool has_kinematics = kinematics_type<K>, has_mesh = mesh_type<M>,
                 has_numerics = numerics_type<N>;
  static_assert(
      has_kinematics,
      "Scene: the first value must be the kinematics: PlaneStrain, Axisymmetric or ThreeDimensional");
  static_assert(!has_kinematics || has_mesh,
                "Scene: the second value must be a mesh: a CartesianGrid or a SimplexMesh");
  static_assert(!has_kinematics || !has_mesh || has_numerics,
                "Scene: the third value must be the numerics: Numerics<QuadraticBSpline, Apic>{} on a grid, "
                "Numerics<LinearSimplex>{} on a simplex mesh");
  if constexpr (has_kinematics && has_mesh && has_numerics) {
    constexpr bool agrees = M::dimension == K::dimension;
    static_assert(agrees, ARENITE_SAYS_DIMENSIONS);
    constexpr bool fits = shape_function<typename N::Shape, M>;
    static_assert(fits, ARENITE_SAYS_SHAPE_MESH);
    constexpr bool has_bodies = (0 + ... + int(is_bodies<Given>)) == 1;
    static_assert(has_bodies, "Scene: exactly one bodies(..) is needed");
    return agrees && fits && has_bodies;
  }
  return false;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
