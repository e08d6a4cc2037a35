// Anti-locking: cures of volumetric locking, as a policy of the numerics. A policy has (examples/extend/own_average.cpp)
// - `fits<Shape>`: whether it goes with the shape functions;
// - `averages_stress`: whether the points of filled cells get their mean stress, as in `ElementAverage`;
// - `StrainAverage<T>` (optional): its average of the strains of a body's points in a step, with
//   - `sum<K, N>(mesh, blocks, body, nodes, dt)`: the sums to average over cells or nodes, from `CellStrain`,
//     from the cell sums (simplices) or from the nodes' `strain_velocity()`;
//   - `numbers_per_node`, `numbers()`: its sums at nodes, which portions of a mesh then add up; 0: none;
//   - `finish(mesh, blocks, body)`: once all has been collected;
//   - `average(strain, cell)`: the strain, `Sym`, of points in a cell, in packs.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/checked.hpp>
#include <arenite/transfer/volumetric_average.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

struct FillRule {
  static constexpr const char* name = "ElementAverage.fill";
  static constexpr const char* bounds = "must be positive";
  static bool holds(double fill) { return fill > 0; }
};
struct FillOfBothRule : FillRule {
  static constexpr const char* name = "NodalAndElementAverage.fill";
};

/// The strain average of a policy; Nothing if it has none.
template <class Policy, class T>
struct StrainAverageOf {
  using type = Nothing;
};
template <class Policy, class T>
requires requires { typename Policy::template StrainAverage<T>; }
struct StrainAverageOf<Policy, T> {
  using type = typename Policy::template StrainAverage<T>;
};

}  // namespace detail

/// The strain of each point as the shape functions give it.
struct NoAntiLocking {
  static constexpr bool averages_stress = false;
  template <class Shape>
  static constexpr bool fits = true;
};

/// Volumetric strain of a cell averaged with its neighbours' through the nodes: a node takes the mean of its
/// cells, weighted by the volume of their points, a cell the mean of its nodes (Detournay and Dzik 2006,
/// nodal mixed discretization; in MPM: Al-Kafaji 2013, Formulation of a dynamic material point method,
/// sec. 4.1.3). For linear simplices.
struct NodalAveraging {
  template <class T>
  using StrainAverage = VolumetricAverage<T>;
  static constexpr bool averages_stress = false;
  template <class Shape>
  static constexpr bool fits = Shape::constant_gradient;
};

/// In a filled cell, the points get their mean stress, weighted by volume, once they are in their cells at
/// the start of a step, and carry it over the whole volume of the cell (Gauss integration in filled cells;
/// Beuth, Wieckowski, Vermeer 2011, doi:10.1002/nag.961); those of a partly filled cell keep their own
/// stresses, and open points carry none.
///
/// `fill` separates cells inside a body from those at its free surface. Shear leaves cells inside short of
/// points for a while; one that then carries its stress only over its points gives way, the more often the
/// fewer points there are: at 0.9 a cell of nine as soon as one is missing. From 0.3 to 0.7 the
/// penetrometer's drop hardly depends on `fill`, and at 0.5 hardly on the number of points
/// (docs/decisions.md, averages).
struct ElementAverage {
  static constexpr bool averages_stress = true;
  Checked<detail::FillRule> fill = 0.5;  ///< a cell counts as filled from this fraction on, -, positive
  template <class Shape>
  static constexpr bool fits = Shape::constant_gradient;
};

/// Both: volumetric strains averaged over nodes, stresses over filled cells. With averaged strains a cell
/// cannot even out the pressure errors that the scatter of its number of points causes; the mean stress
/// over the whole volume of the cell does, so that the number of points affects the result far less than
/// with either of the two.
struct NodalAndElementAverage {
  template <class T>
  using StrainAverage = VolumetricAverage<T>;
  static constexpr bool averages_stress = true;
  Checked<detail::FillOfBothRule> fill = 0.5;  ///< a cell counts as filled from this fraction on, -, positive
  template <class Shape>
  static constexpr bool fits = Shape::constant_gradient;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
