// The concept of a shape function: what couples points and nodes. One object a cell, evaluated for each of
// its points.
#pragma once

#include <arenite/shape/linear_simplex.hpp>
#include <arenite/shape/quadratic_bspline.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// - `S::fits<M>`: whether the functions are made for mesh M;
/// - `S::node_count(mesh)`, `S::node_position(mesh, node)`: the nodes that carry coefficients;
/// - `S::Cell<M>(mesh, cell)`: `nodes` [size]; `weights(x)` [size] and `gradients(x)` [D x size] in 1/m at
///   a position x, as Eigen's; `weights(x)` [size] and `offsets(x)` [D][..] at a `std::array` x [D] of packs
///   or scalars, as arrays of them, for the kernels;
/// - `S::constant_gradient`: whether the gradients are the same everywhere in a cell: then they are its
/// member
///   `gradient`; else its functions must be products along the axes, and it has `line_values(x)`,
///   `line_slopes(x)` [D][3], arrays too.
template <class S, class M>
concept shape_function = mesh<M> && S::template fits<M>&& requires(
    const M m, const typename M::Point x, Index i,
    const std::array<typename M::scalar, static_cast<std::size_t>(M::dimension)> place) {
  { S::constant_gradient } -> std::convertible_to<bool>;
  { S::node_count(m) } -> std::same_as<Index>;
  { S::node_position(m, i) } -> std::convertible_to<typename M::Point>;
  typename S::template Cell<M>;
  {typename S::template Cell<M>(m, i).weights(x)};
  {typename S::template Cell<M>(m, i).gradients(x)};
  {typename S::template Cell<M>(m, i).weights(place)};
  {typename S::template Cell<M>(m, i).offsets(place)};
}
&&(S::constant_gradient ||
   requires(const typename S::template Cell<M> cell,
            const std::array<typename M::scalar, static_cast<std::size_t>(M::dimension)> place) {
     {cell.line_values(place)};
     {cell.line_slopes(place)};
   });

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
