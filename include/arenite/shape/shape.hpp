// The concept of a shape function: what couples points and nodes. One object a cell, evaluated for each of
// its points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/shape/cubic_bspline.hpp>
#include <arenite/shape/linear_grid.hpp>
#include <arenite/shape/linear_simplex.hpp>
#include <arenite/shape/mls_gradient.hpp>
#include <arenite/shape/quadratic_bspline.hpp>
#include <arenite/shape/ugimp.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// - `S::fits<M>`: whether the functions are made for mesh M;
/// - `S::node_count(mesh)`, `S::node_position(mesh, node)`: the nodes that carry coefficients;
/// - `S::steepness`: see `ProductShape`; where it is infinite `S::courant_limit(maps_back)`, the largest
///   stable step in cell sizes over the wave speed as measured, with MUSL's mapped velocities and without,
///   and `S::for_each_neighbour(mesh, node, f)` for the exchange of light nodes;
/// - `S::Cell<M>(mesh, cell)`: `nodes` [size]; `weights(x)` [size], `gradients(x)` [D x size] in 1/m at a
///   position x and `node_positions()` [D x size] in m, as Eigen's.
/// The kernels evaluate at a `std::array` x [D] of packs or scalars, and the cell has, as arrays,
/// - if `S::constant_gradient`: `weights(x)` [size], `offsets(x)` [D][size] to the nodes in m, and the member
///   `gradient`, the same everywhere in the cell;
/// - else, on a grid, functions that are products along the axes: `line_values(x)`, `line_slopes(x)` and
///   `offsets(x)` [D][N], and `S::halo`; APIC needs `inverse_inertia(x)` [D], too. `ProductShape` makes all
///   of it of the functions along one axis: examples/extend/shapes/.
template <class S, class M>
concept shape_function = mesh_type<M> &&
    S::template fits<M>&& requires(const M m, const typename M::Point x, Index i,
                                   const typename S::template Cell<M> cell) {
  { S::constant_gradient } -> std::convertible_to<bool>;
  { S::steepness } -> std::convertible_to<double>;
  { S::node_count(m) } -> std::same_as<Index>;
  { S::node_position(m, i) } -> std::convertible_to<typename M::Point>;
  typename S::template Cell<M>;
  {typename S::template Cell<M>(m, i)};
  {cell.nodes};
  {cell.weights(x)};
  {cell.gradients(x)};
  {cell.node_positions()};
}
&&requires(const typename S::template Cell<M> cell,
           const std::array<typename M::scalar, static_cast<std::size_t>(M::dimension)> place) {
  {cell.offsets(place)};
  requires(S::constant_gradient &&
           requires {
             {cell.weights(place)};
             {cell.gradient};
           }) ||
      (!S::constant_gradient && requires {
        {cell.line_values(place)};
        {cell.line_slopes(place)};
        { S::halo } -> std::convertible_to<Index>;
      });
};

/// Spacing of points, in cell edges, from which a body under tension may part between them, or from a wall:
/// measured (docs/limits.md). A shape may say its own.
template <class S>
inline constexpr double bearing_spacing = [] {
  if constexpr (requires { S::bearing_spacing; })
    return S::bearing_spacing;
  else
    return 0.65;
}();

/// Whether functions fall to zero with a slope that does not: nodes may then get force and hardly any mass,
/// in any cell.
template <class S>
inline constexpr bool has_light_nodes = S::steepness == std::numeric_limits<double>::infinity();

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
