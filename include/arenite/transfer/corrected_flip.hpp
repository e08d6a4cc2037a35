// Common part of XPIC and FMPM: FLIP with a correction of the nodes' velocities by iterations over the points.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <arenite/core/checked.hpp>
#include <arenite/transfer/flip.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// With S the interpolation to the points and S+ the lumped mapping to the nodes a step computes
///   v_p = sum w_i (v_i^new + c_i),   c = sum_{l=1}^{order-1} (I - S+ S)^l u
/// where u = `Start::of(nodes, i)` are velocities of the nodes. Each term but the first is an iteration over the
/// points (on linear simplices over the cells). Order 1 is PIC.
///
/// That is the formula of a step: smaller steps damp more. With a time constant the points keep the fraction
/// k = exp(-dt / time) of what FLIP gives them, so that noise decays in time, whatever the step:
///   v_p = k (v_p + sum w_i (v_i^new - v_i^old)) + (1 - k) sum w_i (v_i^new + c_i)
/// (The authors instead mix steps with and without the correction: Nairn and Hammerquist 2021.)
template <class Start>
struct CorrectedFlip {
  static constexpr bool affine = false;
  struct OrderRule {
    static constexpr const char* name = Start::order_name;
    static constexpr const char* bounds = "must be a whole number from 1 on";
    static bool holds(double order) { return order >= 1 && order <= 1e6 && order == std::floor(order); }
  };
  struct TimeRule {
    static constexpr const char* name = Start::time_name;
    static constexpr const char* bounds = "must not be negative (0: all of it in each step)";
    static bool holds(double time) { return time >= 0; }
  };
  Checked<OrderRule> order = 2.0;          ///< a whole number, -, in [1, 1e6]; 1: PIC
  Checked<TimeRule> time = 0.0;            ///< time constant, s, >= 0; 0: all of it in each step
  Checked<Flip::FractionRule> kept = 0.0;  ///< k of a step: `in_step` sets it
  template <class Shape>
  static constexpr bool fits = true;

  CorrectedFlip in_step(double dt) const {
    return {.order = order, .time = time, .kept = time > 0 ? std::exp(-dt / time) : 0.0};
  }
  /// Iterations in a step.
  int iterations() const { return static_cast<int>(order) - 1; }
  /// u of node i, as a pack.
  template <class Nodes>
  auto iterated(const Nodes& nodes, Index i) const {
    return times(1 - kept, Start::of(nodes).pack(i));
  }

  template <class Point>
  auto particle_field(const Point& p) const {
    return VelocityField{p.velocity()};
  }
  template <class Cell, class Nodes>
  auto gather(const Cell& cell, const Nodes& nodes) const {
    using T = typename Cell::T;
    Flip::Gathered<T, CellVectors<T, Cell::D, Cell::size>> gathered;
    gathered.fraction = static_cast<T>(kept);
    repeat<Cell::size>([&](std::size_t i) { gathered.velocity.set(i, increment_at(nodes, cell.nodes[i])); });
    return gathered;
  }
  /// d_i of v_p = k v_p + sum w_i d_i.
  template <class Nodes>
  auto increment_at(const Nodes& nodes, Index i) const {
    return returned_velocity(nodes, i) - times(kept, nodes.start.pack(i));
  }
  /// k v_i^old + d_i.
  template <class Nodes>
  auto returned_velocity(const Nodes& nodes, Index i) const {
    return nodes.velocity.pack(i) + nodes.correction.pack(i);
  }

 private:
  template <class V>
  static V times(double factor, const V& v) {
    return V(static_cast<std::remove_cvref_t<decltype(v[0])>>(factor)) * v;
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
