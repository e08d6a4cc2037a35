// Volume of a cell in the kinematics of a scene: of the full circle in axisymmetry.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/mesh/kinematics.hpp>
#include <arenite/mesh/mesh.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Volume of a whole cell in these kinematics, m3: exact for the linear thickness of axisymmetry.
template <class K, class M>
typename M::scalar full_volume(const M& mesh, Index cell) {
  using T = typename M::scalar;
  if constexpr (!K::hoop) {
    return mesh.volume(cell);
  } else if constexpr (is_simplex_mesh<M>) {
    auto centre = zeros<typename M::Point>();
    for (const Index i : mesh.nodes(cell)) centre += mesh.position(i);
    centre /= static_cast<T>(mesh.nodes(cell).size());
    return mesh.volume(cell) * K::thickness(centre);
  } else {
    return mesh.volume(cell) * K::thickness(typename M::Point(mesh.corner(cell) + mesh.extent(cell) / 2));
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
