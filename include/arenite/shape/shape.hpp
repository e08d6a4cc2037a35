// The concept of a shape function: what couples points and nodes. One object a cell, evaluated for each of
// its points.
#pragma once

#include <arenite/shape/linear_simplex.hpp>
#include <arenite/shape/quadratic_bspline.hpp>

namespace arenite {

/// - `S::fits<M>`: whether the functions are made for mesh M;
/// - `S::node_count(mesh)`, `S::node_position(mesh, node)`: the nodes that carry coefficients;
/// - `S::Cell<M>(mesh, cell)`: `nodes` [size], `weights(x)` [size], `gradients(x)` [D x size] in 1/m;
/// - `S::constant_gradient`: whether the gradients are the same everywhere in a cell.
template <class S, class M>
concept shape_function = mesh<M> &&
    S::template fits<M>&& requires(const M m, const typename M::Point x, Index i) {
  { S::constant_gradient } -> std::convertible_to<bool>;
  { S::node_count(m) } -> std::same_as<Index>;
  { S::node_position(m, i) } -> std::convertible_to<typename M::Point>;
  typename S::template Cell<M>;
  {typename S::template Cell<M>(m, i).weights(x)};
  {typename S::template Cell<M>(m, i).gradients(x)};
};

}  // namespace arenite
