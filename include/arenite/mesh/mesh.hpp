// The concept of a mesh: cells that contain points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>

#include <arenite/mesh/cartesian_grid.hpp>
#include <arenite/mesh/simplex_mesh.hpp>
#include <arenite/mesh/window_grid.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// - `walk(x, hint)`: the cell of x, or `none`; `search(x)`: the same without a hint, slower, right
/// everywhere.
/// - `holder(cell).holds(x)`: whether one cell contains x [D], a `std::array` of scalars or of packs;
/// - `size(cell)`: length for the stable step, m; `volume(cell)`: area or volume, m^D;
/// - `node_size(node)`: smallest size of the cells at a node, of any shape function, m.
template <class M>
concept mesh_type =
    requires(M m, const M cm, const typename M::Point x, Index cell,
             const std::array<typename M::scalar, static_cast<std::size_t>(M::dimension)> place) {
  { M::dimension } -> std::convertible_to<int>;
  { cm.cell_count() } -> std::same_as<Index>;
  { cm.walk(x, cell) } -> std::same_as<Index>;
  { m.search(x) } -> std::same_as<Index>;
  { cm.holder(cell).holds(place) } -> std::same_as<bool>;
  { cm.size(cell) } -> std::convertible_to<typename M::scalar>;
  { cm.volume(cell) } -> std::convertible_to<typename M::scalar>;
  { cm.node_size(cell) } -> std::convertible_to<typename M::scalar>;
};

/// Whether M is a `SimplexMesh`.
template <class M>
inline constexpr bool is_simplex_mesh = false;
template <int D, class T>
inline constexpr bool is_simplex_mesh<SimplexMesh<D, T>> = true;

/// `knots(i, j)`: the place of line i + j along an axis of a grid, m, or of the face beyond which it would
/// lie.
template <class K>
concept grid_knots = requires(const K& knots, Index i, int shift) {
  { knots(i, shift) } -> std::floating_point;
};

/// Whether M is a grid whose cells differ in their edges (`RectilinearGrid`).
template <class M>
inline constexpr bool is_rectilinear = requires {
  typename M::Knots;
};

/// Whether M is a grid whose cells are all equal, so that the place of a point gives the number of its cell.
template <class M>
inline constexpr bool has_equal_cells = requires(const M& mesh) {
  mesh.inverse_edge();
};

/// Whether an axis of a grid is periodic (`PeriodicGrid`), or any is.
template <class M>
constexpr bool is_periodic(int axis) {
  if constexpr (requires { M::periodic_axes; })
    return ((M::periodic_axes >> axis) & 1) != 0;
  else
    return false;
}
template <class M>
constexpr bool is_periodic() {
  return is_periodic<M>(0) || is_periodic<M>(1) || is_periodic<M>(2);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
