// Cold functions of point_contact.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <arenite/rigid/point_contact.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <class T, int D, int N>
ARENITE_COLD auto PointImpulses<T, D, N>::solve(const U& free, const Mat<double, N>& mobility,
                                                const std::vector<Constraint<T, D>>& constraints,
                                                const Friction& friction, double dt) -> U {
  U u = free;
  sweeps = 0;
  if (rows_.empty()) return u;
  find_constrained(constraints);
  double scale = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    Row& row = rows_[k];
    row.least = -(points[k].gap < 0 ? PointContact::push : 1) * points[k].gap / dt;
    row.friction = friction.coefficient();
    prepare(row, mobility, constraints);
    scale = std::max({scale, velocity_of(row, u).norm(), std::abs(row.least)});
  }
  for (double change = scale; sweeps < PointContact::most_sweeps && change > PointContact::precision * scale;
       ++sweeps) {
    change = 0;
    for (Row& row : rows_)
      if (row.response(0, 0) > 0) change = std::max(change, relax(row, constraints, u));
  }
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Row& row = rows_[k];
    const V impulse = row.axes.transpose() * row.impulse;
    points[k].impulse = impulse.template cast<T>();
    for (const Share& s : shares_of(row)) nodes_[s.node].impulse += s.weight * impulse;
  }
  return u;
}

template <class T, int D, int N>
ARENITE_COLD void PointImpulses<T, D, N>::add_to(GivenImpulses<T, D, N>& given) const {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec<T, D> arm = rows_[k].arm.template cast<T>();
    const auto& j = points[k].impulse;
    given.total += with_moment<N>(arm, j);
    given.exchanged += Vec<T, 2>(j.norm(), j.norm() * arm.norm());
  }
}

/// Notes which of the nodes are constrained.
template <class T, int D, int N>
ARENITE_COLD void PointImpulses<T, D, N>::find_constrained(const std::vector<Constraint<T, D>>& constraints) {
  const std::size_t fields = number_.size() / field_size_;
  for (std::size_t k = 0; k < constraints.size(); ++k)
    for (std::size_t f = 0; f < fields; ++f)
      if (const Index n = number_[f * field_size_ + constraints[k].node]; n != none)
        nodes_[n].constraint = static_cast<Index>(k);
}

template <class T, int D, int N>
auto PointImpulses<T, D, N>::velocity_of(const Row& row, const U& u) const -> V {
  V v = -velocity_at<double, D, N>(u, row.arm);
  for (const Share& share : shares_of(row)) v += share.weight * nodes_[share.node].velocity;
  return v;
}

template <class T, int D, int N>
ARENITE_COLD void PointImpulses<T, D, N>::prepare(Row& row, const Mat<double, N>& mobility,
                                                  const std::vector<Constraint<T, D>>& constraints) const {
  row.axes = contact_axes<D>(row.normal);
  const auto w = velocity_map<N, D>(row.arm);
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
  // What no impulse along the normal can move.
  if (!(row.response(0, 0) > 1e-9 * (unconstrained + mobility.trace()))) row.response(0, 0) = 0;
}

/// Takes the impulse at a point to what the others leave; returns by how much this changed its velocity, m/s.
template <class T, int D, int N>
double PointImpulses<T, D, N>::relax(Row& row, const std::vector<Constraint<T, D>>& constraints, U& u) {
  constexpr double floor = 1e-9;
  const V w = row.axes * velocity_of(row, u);
  const double normal = std::max(0.0, row.wanted(w, floor)[0]), more = normal - row.impulse[0];
  if (normal == 0 && row.impulse[0] == 0) return 0;
  V next = row.wanted(w + more * row.response.col(0), floor);
  next[0] = normal;
  const V change = row.lawful(next) - row.impulse;
  row.impulse += change;
  u -= row.by * change;
  const V impulse = row.axes.transpose() * change;
  for (const Share& share : shares_of(row)) {
    Node& n = nodes_[share.node];
    V moved = n.per_mass * impulse;
    if (n.constraint != none) moved = constraints[n.constraint].projector.template cast<double>() * moved;
    n.velocity += share.weight * moved;
  }
  return row.velocity_of(change, floor);
}

#define ARENITE_INSTANCES(T, D)          \
  template class PointImpulses<T, D, D>; \
  template class PointImpulses<T, D, D + rotations<D>>;
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
