// Contact of a rigid body at the material points: impulses that keep each point out of the body, found
// together with the body's velocity.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <arenite/boundary/constraints.hpp>
#include <arenite/contact/coulomb.hpp>
#include <arenite/contact/relaxed_impulse.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/rigid/body/twist.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Contact at the material points: none may move into the body, whatever the masses, with Coulomb friction.
/// It acts where the points are, whatever the grid, and so without the gap that contact at nodes leaves (see
/// `DistanceSurface`); a point represents matter around it, of which half its size is inside the body when it
/// touches. Needs a `DistanceSurface`, and points whose velocities are not mapped back (no MUSL). Impulses
/// are found by sweeps of projected Gauss-Seidel, the body's velocity with them.
struct PointContact {
  static constexpr bool through_centre_of_mass = false, at_points = true;
  /// Points nearer than this many sizes of their cell may come to touch within a step.
  static constexpr double margin = 0.3;
  /// Share of a point's depth in the body that is pushed out in a step.
  static constexpr double push = 0.2;
  static constexpr int most_sweeps = 50;
  /// Sweeps end where none changes a velocity by more than this share of the largest one.
  static constexpr double precision = 1e-6;
};

/// A point that a body touched, or could have, in a step.
template <class T, int D>
struct TouchedPoint {
  std::size_t body;                       ///< number
  Index point;                            ///< where it is in the body's columns until the end of the step
  double gap;                             ///< distance from the surface at the start of the step, m
  Vec<T, D> normal;                       ///< out of the rigid body
  Vec<T, D> impulse = Vec<T, D>::Zero();  ///< on the matter, N s
};

/// The points that a rigid body touches in a step, and the impulses between them. `N`: components of the
/// body's velocity, D or those of a twist.
///
/// With the velocities v_i of the nodes, weights w_i at a point, and the body's velocity W u there, the point
/// moves against the body with v = sum w_i v_i - W u. Conditions at the end of the step: its part along the
/// normal v_n >= -gap / dt (where the gap is negative v_n >= -push gap / dt), j_n >= 0, one of them an
/// equality; |j_t| <= mu j_n, and points that slip do so against j_t. An impulse j changes the nodes'
/// velocities by w_i P_i j / m_i, P_i being what constraints leave free, and the body's by -A W^T j, A its
/// mobility: so v changes by (sum w_i^2 P_i / m_i + W A W^T) j.
template <class T, int D, int N>
class PointImpulses {
 public:
  using V = Vec<double, D>;
  using U = Vec<double, N>;

  std::vector<TouchedPoint<T, D>> points{};  ///< of the last step
  double deepest = 0;                        ///< greatest depth of a point at the start of a step so far, m
  int sweeps = 0;                            ///< of the last step

  /// A node that some of the points touch.
  struct Node {
    std::size_t field;
    Index node;
    V velocity;             ///< as the constraints leave it, m/s
    V impulse = V::Zero();  ///< N s
    double per_mass;        ///< 1/kg
    Index constraint = none;
  };
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Of a point from the centre of a body that rotates, m.
  const V& arm(std::size_t point) const { return rows_[point].arm; }

  /// Begins a step with `fields` fields of `nodes` nodes each.
  void clear(std::size_t fields, std::size_t nodes) {
    points.clear();
    rows_.clear();
    shares_.clear();
    for (const Node& n : nodes_) number_[n.field * field_size_ + n.node] = none;
    nodes_.clear();
    if (number_.size() != fields * nodes) number_.assign(fields * nodes, none);
    field_size_ = nodes;
  }

  /// Adds a point with the functions of its cell; `arm`: of the point from the centre of a body that rotates,
  /// m.
  template <class Cell, class Weights, class Field>
  void add(const TouchedPoint<T, D>& touched, std::size_t field_number, const Field& field, const Cell& cell,
           const Weights& weights, const V& arm) {
    Row row{.first = shares_.size(), .normal = touched.normal.template cast<double>(), .arm = arm};
    for (std::size_t i = 0; i < cell.nodes.size(); ++i) {
      const Index node = cell.nodes[i];
      const auto weight = static_cast<double>(weights[static_cast<int>(i)]);
      if (weight == 0 || !(field.mass[node] > 0)) continue;
      Index& number = number_[field_number * field_size_ + node];
      if (number == none) {
        number = static_cast<Index>(nodes_.size());
        nodes_.push_back({.field = field_number,
                          .node = node,
                          .velocity = field.velocity[node].template cast<double>(),
                          .per_mass = 1 / static_cast<double>(field.mass[node])});
      }
      shares_.push_back({number, weight});
    }
    row.count = shares_.size() - row.first;
    rows_.push_back(row);
    points.push_back(touched);
    deepest = std::max(deepest, -touched.gap);
  }

  /// Finds all impulses for a step dt, s. `free`: the body's velocity at its end without contact, `mobility`:
  /// its change by an impulse, 1/kg. Returns the body's velocity in contact.
  U solve(const U& free, const Mat<double, N>& mobility, const std::vector<Constraint<T, D>>& constraints,
          const Friction& friction, double dt) {
    U u = free;
    sweeps = 0;
    if (rows_.empty()) return u;
    find_constrained(constraints);
    double scale = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      Row& row = rows_[k];
      row.least = -(points[k].gap < 0 ? PointContact::push : 1) * points[k].gap / dt;
      prepare(row, mobility, constraints);
      scale = std::max({scale, velocity_of(row, u).norm(), std::abs(row.least)});
    }
    for (double change = scale;
         sweeps < PointContact::most_sweeps && change > PointContact::precision * scale; ++sweeps) {
      change = 0;
      for (Row& row : rows_)
        if (row.response(0, 0) > 0) change = std::max(change, relax(row, friction, constraints, u));
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const Row& row = rows_[k];
      const V impulse = row.axes.transpose() * row.impulse;
      points[k].impulse = impulse.template cast<T>();
      for (const Share& s : shares_of(row)) nodes_[s.node].impulse += s.weight * impulse;
    }
    return u;
  }

 private:
  struct Share {
    Index node;  // number among those touched
    double weight;
  };
  /// A point: its axes are the normal and tangents.
  struct Row {
    std::size_t first, count = 0;  // of its shares
    V normal, arm;
    double least = 0;                                                      // normal velocity, m/s
    Mat<double, D> axes = Mat<double, D>::Zero();                          // rows
    Mat<double, D> response = Mat<double, D>::Zero();                      // in these axes, 1/kg
    Eigen::Matrix<double, N, D> by = Eigen::Matrix<double, N, D>::Zero();  // of the body's velocity, 1/kg
    V impulse = V::Zero();                                                 // in these axes, N s
  };

  std::span<const Share> shares_of(const Row& row) const { return {shares_.data() + row.first, row.count}; }

  /// Notes which of the nodes are constrained.
  void find_constrained(const std::vector<Constraint<T, D>>& constraints) {
    const std::size_t fields = number_.size() / field_size_;
    for (std::size_t k = 0; k < constraints.size(); ++k)
      for (std::size_t f = 0; f < fields; ++f)
        if (const Index n = number_[f * field_size_ + constraints[k].node]; n != none)
          nodes_[n].constraint = static_cast<Index>(k);
  }
  /// Velocity of a node by an impulse on it, as far as constraints allow.
  static V change_of(const Node& n, const V& impulse, const std::vector<Constraint<T, D>>& constraints) {
    const V change = n.per_mass * impulse;
    if (n.constraint == none) return change;
    return constraints[n.constraint].projector.template cast<double>() * change;
  }

  V velocity_of(const Row& row, const U& u) const {
    V v = -velocity_at<double, D>(u, row.arm);
    for (const Share& s : shares_of(row)) v += s.weight * nodes_[s.node].velocity;
    return v;
  }

  void prepare(Row& row, const Mat<double, N>& mobility,
               const std::vector<Constraint<T, D>>& constraints) const {
    row.axes = contact_axes<D>(row.normal);
    const auto w = velocity_map<D, N>(row.arm);
    row.by = mobility * w.transpose() * row.axes.transpose();
    Mat<double, D> response = w * mobility * w.transpose();
    double unconstrained = 0;
    for (const Share& s : shares_of(row)) {
      const Node& n = nodes_[s.node];
      const double moved = s.weight * s.weight * n.per_mass;
      unconstrained += moved;
      if (n.constraint == none)
        response.diagonal().array() += moved;
      else
        response += moved * constraints[n.constraint].projector.template cast<double>();
    }
    row.response = row.axes * response * row.axes.transpose();
    // No impulse along the normal can move the point.
    if (!(row.response(0, 0) > 1e-9 * (unconstrained + mobility.trace()))) row.response(0, 0) = 0;
  }

  /// Relaxes the impulse at a point for the present impulses at the others; returns by how much this changed
  /// its velocity, m/s.
  double relax(Row& row, const Friction& friction, const std::vector<Constraint<T, D>>& constraints, U& u) {
    const double across = tangential_response(row.response, 1e-9);
    const V next = relaxed_impulse<D>(row.impulse, row.axes * velocity_of(row, u), row.least, row.response,
                                      across, friction.coefficient());
    const V change = next - row.impulse;
    if (next[0] == 0 && row.impulse[0] == 0) return 0;
    row.impulse += change;
    u -= row.by * change;
    const V impulse = row.axes.transpose() * change;
    for (const Share& s : shares_of(row)) {
      Node& n = nodes_[s.node];
      n.velocity += s.weight * change_of(n, impulse, constraints);
    }
    return velocity_change<D>(change, row.response, across);
  }

  std::vector<Row> rows_{};  // [points]
  std::vector<Share> shares_{};
  std::vector<Node> nodes_{};
  std::vector<Index> number_{};  // [fields * nodes] among `nodes_`, or none
  std::size_t field_size_ = 0;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
