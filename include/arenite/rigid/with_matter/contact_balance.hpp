// Balance of contact: the velocity and spin of a rigid body at which its impulses and those of all nodes that
// it touches balance.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <vector>

#include <arenite/contact/coulomb.hpp>
#include <arenite/core/cold.hpp>
#include <arenite/rigid/body/twist.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// -1/m dJ/da of Coulomb's impulse J (`coulomb`) by the relative velocity a, where it has a slope. Without
/// `coupling` friction that slips does not grow with the normal impulse: the slope is then symmetric and
/// nowhere negative.
template <int D>
Mat<double, D> coulomb_slope(const Vec<double, D>& approach, const Vec<double, D>& normal,
                             const Friction& friction, bool coupling = true);

/// A node that a rigid body touches, as balances need it, for a body with N components of velocity.
template <int D, int N>
struct ResistingNode {
  Eigen::Matrix<double, D, N> map;  ///< `velocity_map`
  Vec<double, D> start;             ///< velocity of the matter before contact, m/s
  Vec<double, D> normal;            ///< out of the body
  double mass;                      ///< that an impulse has to move, kg
  bool inside;

  /// Relative velocity, the matter's minus the body's, where the body's is u.
  Vec<double, D> approach(const Vec<double, N>& u) const;
  /// `coulomb_slope` where the relative velocity is that; inside the body all motion is opposed.
  Mat<double, D> slope_at(const Vec<double, D>& relative, const Friction& friction, bool coupling) const;
  /// Adds mass W^T slope W to `sum` [N x N].
  void add_resistance(const Mat<double, D>& slope, double* sum) const;
};

/// The nodes that a body touches (`RigidBody::touched_nodes`).
template <class R>
auto resisting_nodes(const R& body) {
  constexpr int D = R::V::RowsAtCompileTime, N = R::Velocity::RowsAtCompileTime;
  std::vector<ResistingNode<D, N>> nodes;
  nodes.reserve(body.touched_nodes.size());
  for (const auto& t : body.touched_nodes)
    nodes.push_back({velocity_map<D, N>(t.arm.template cast<double>()),
                     t.before_contact().template cast<double>(), t.normal.template cast<double>(),
                     static_cast<double>(t.mass_ratio * t.mass), t.inside});
  return nodes;
}

/// How the impulses of the matter oppose the velocity u of a body, as an inertia [N x N]; `coupling`: see
/// `coulomb_slope`.
template <int D, int N>
Mat<double, N> resistance_of(const std::vector<ResistingNode<D, N>>& nodes, const Vec<double, N>& u,
                             const Friction& friction, bool coupling);

/// Solves f(u) = M (u - free) + sum_i W_i^T J_i(W_i u) = 0 for the twist u of a body, W_i u its velocity at
/// node i. f is made of pieces that are straight, or nearly so; without friction it is the gradient of a
/// convex function. Newton steps on the pieces, each followed along its direction to where f no longer points
/// ahead, reach the solution in a few steps, whatever the masses. Components are scaled by the square root of
/// the mass that they move.
template <int D>
class ContactBalance {
 public:
  static constexpr int N = D + rotations<D>;
  using U = Vec<double, N>;
  using Nodes = std::vector<ResistingNode<D, N>>;

  /// `inertia`: M; `moves`: 1 for each component of the twist that may change, else 0.
  ContactBalance(Nodes nodes, const Friction& friction, const U& free, const Mat<double, N>& inertia,
                 const U& moves);

  /// The twist.
  U solve();

 private:
  static constexpr double solved = 1e-9;  // of the impulses

  void look(const U& x);
  double iterate(U& x);
  double follow(const U& x, const U& direction, double begin);
  double size_of_rest() const;

  Nodes nodes_;
  Friction friction_;
  U free_, scale_;
  Mat<double, N> inertia_;
  U moves_;
  U rest_;
  Mat<double, N> slope_;
  double magnitude_ = 0, contact_magnitude_ = 0;
  double added_ = 0;  // mass that is added to the body, as a share of what each component moves
  U added_from_;      // where it rests
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <cmath>
#include <limits>
#include <utility>

#include <arenite/core/linear_solve.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <int D>
ARENITE_COLD Mat<double, D> coulomb_slope(const Vec<double, D>& approach, const Vec<double, D>& normal,
                                          const Friction& friction, bool coupling) {
  const double closing = dot(approach, normal);
  Mat<double, D> slope = zeros<Mat<double, D>>();
  if (!(closing < 0)) return slope;
  Vec<double, D> slip;
  for (int d = 0; d < D; ++d) slip[d] = approach[d] - closing * normal[d];
  const double speed = std::sqrt(dot(slip, slip)), most = friction.coefficient() * -closing;
  const bool sticks = friction.is_no_slip() || speed <= most;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      const double unit = i == j ? 1 : 0, across = normal[i] * normal[j];
      if (sticks) {
        slope(i, j) = unit;
        continue;
      }
      const double along = slip[i] / speed;
      slope(i, j) = across + most / speed * (unit - across - along * (slip[j] / speed));
      if (coupling) slope(i, j) -= friction.coefficient() * along * normal[j];
    }
  return slope;
}

template <int D, int N>
ARENITE_COLD Vec<double, D> ResistingNode<D, N>::approach(const Vec<double, N>& u) const {
  Vec<double, D> a;
  for (int d = 0; d < D; ++d) {
    a[d] = start[d];
    for (int k = 0; k < N; ++k) a[d] -= map(d, k) * u[k];
  }
  return a;
}

template <int D, int N>
ARENITE_COLD Mat<double, D> ResistingNode<D, N>::slope_at(const Vec<double, D>& relative,
                                                          const Friction& friction, bool coupling) const {
  if (!inside) return coulomb_slope<D>(relative, normal, friction, coupling);
  Mat<double, D> all = zeros<Mat<double, D>>();
  for (int d = 0; d < D; ++d) all(d, d) = 1;
  return all;
}

template <int D, int N>
ARENITE_COLD void ResistingNode<D, N>::add_resistance(const Mat<double, D>& slope, double* sum) const {
  for (int column = 0; column < N; ++column)
    for (int d = 0; d < D; ++d) {
      double moved = 0;
      for (int e = 0; e < D; ++e) moved += slope(d, e) * map(e, column);
      moved *= mass;
      for (int row = 0; row < N; ++row) sum[row + column * N] += map(d, row) * moved;
    }
}

template <int D, int N>
ARENITE_COLD Mat<double, N> resistance_of(const std::vector<ResistingNode<D, N>>& nodes,
                                          const Vec<double, N>& u, const Friction& friction, bool coupling) {
  Mat<double, N> sum = zeros<Mat<double, N>>();
  for (const auto& node : nodes)
    node.add_resistance(node.slope_at(node.approach(u), friction, coupling), sum.data());
  return sum;
}

template <int D>
ARENITE_COLD ContactBalance<D>::ContactBalance(Nodes nodes, const Friction& friction, const U& free,
                                               const Mat<double, N>& inertia, const U& moves)
    : nodes_{std::move(nodes)},
      friction_{friction},
      free_{free},
      scale_{zeros<U>()},
      inertia_{inertia},
      moves_{moves},
      added_from_{zeros<U>()} {
  for (const auto& node : nodes_)
    for (int k = 0; k < N; ++k)
      for (int d = 0; d < D; ++d) scale_[k] += node.mass * (node.map(d, k) * node.map(d, k));
  for (int k = 0; k < N; ++k) scale_[k] = std::sqrt(scale_[k] + inertia_(k, k));
}

template <int D>
ARENITE_COLD double ContactBalance<D>::size_of_rest() const {
  return std::sqrt(dot(rest_, rest_));
}

template <int D>
ARENITE_COLD auto ContactBalance<D>::solve() -> U {
  U x = zeros<U>();  // scaled, from `free` on
  look(x);
  if (contact_magnitude_ == 0) return free_;
  U best = x;
  double least = iterate(x);
  if (least > solved * magnitude_ && !friction_.is_no_slip()) {
    // Of a far heavier body, then of ever lighter ones, each from where the one before ended.
    const auto keep_better = [&](double size) {
      if (size < least) best = x, least = size;
    };
    best = x;
    x = zeros<U>();
    for (added_ = 1; added_ > 1e-12 && least > solved * magnitude_; added_ /= 8) {
      added_from_ = x;
      iterate(x);
      const double added = std::exchange(added_, 0.0);
      look(x);
      keep_better(size_of_rest());
      added_ = added;
    }
    added_ = 0;
    keep_better(iterate(x));
    x = best;
  }
  U u = free_;
  for (int k = 0; k < N; ++k) u[k] += x[k] / scale_[k];
  return u;
}

/// f and its slope, scaled, at x.
template <int D>
ARENITE_COLD void ContactBalance<D>::look(const U& x) {
  U change, u = free_;
  for (int k = 0; k < N; ++k) u[k] += change[k] = x[k] / scale_[k];
  double sums[N * N + 2 * N] = {};  // slope by columns, f, magnitudes
  for (const auto& node : nodes_) {
    const Vec<double, D> a = node.approach(u);
    const auto contact = node.inside ? stick<double, D>(a, node.mass)
                                     : coulomb<double, D>(a, node.normal, node.mass, friction_);
    const Vec<double, D>& j = contact.impulse;
    if (dot(j, j) == 0) continue;
    for (int k = 0; k < N; ++k) {
      double share = 0;
      for (int d = 0; d < D; ++d) share += node.map(d, k) * j[d];
      sums[N * N + k] += share;
      sums[N * N + N + k] += std::abs(share);
    }
    node.add_resistance(node.slope_at(a, friction_, true), sums);
  }
  contact_magnitude_ = 0;
  double squared = 0;
  for (int row = 0; row < N; ++row) {
    const double by = moves_[row] / scale_[row], contact = sums[N * N + row],
                 magnitude = sums[N * N + N + row];
    double own = 0;
    for (int k = 0; k < N; ++k) own += inertia_(row, k) * change[k];
    contact_magnitude_ += magnitude;
    rest_[row] = by * (own + contact);
    squared += std::pow(by * (std::abs(own) + magnitude), 2);
    for (int k = 0; k < N; ++k)
      slope_(row, k) = by * (inertia_(row, k) + sums[row + k * N]) * (moves_[k] / scale_[k]);
    slope_(row, row) += 1 - moves_[row];
    if (added_ > 0) {
      rest_[row] += added_ * (x[row] - added_from_[row]);
      slope_(row, row) += added_;
    }
  }
  magnitude_ = std::sqrt(squared);
}

/// Newton steps from x on; returns the least size of f found, and x there.
template <int D>
ARENITE_COLD double ContactBalance<D>::iterate(U& x) {
  constexpr double round_off = std::numeric_limits<double>::epsilon();
  look(x);
  U best = x;
  double least = size_of_rest();
  for (int step = 0; step < 60 && least > 0; ++step) {
    const U begin = rest_;
    U direction = solve_linear<N>(slope_, begin);
    bool finite = true;
    for (int k = 0; k < N; ++k) {
      direction[k] = -direction[k];
      finite = finite && std::isfinite(direction[k]);
    }
    if (!finite || !(dot(direction, begin) < 0))
      for (int k = 0; k < N; ++k) direction[k] = -begin[k];
    const double share = follow(x, direction, dot(direction, begin));
    for (int k = 0; k < N; ++k) x[k] += share * direction[k];
    const double size = size_of_rest();
    const bool better = size < least;
    if (better) {
      best = x;
      least = size;
    }
    if (size <= solved * magnitude_ && !better) break;  // round-off
    if (share * std::sqrt(dot(direction, direction)) <= round_off * std::sqrt(dot(x, x))) break;
  }
  x = best;
  return least;
}

/// Line search: the full step along a direction if the component of f along it is then at most 0.9 of that at
/// the start, or f is solved; else until it is at most 0.1 of that. Returns the share of the direction; f is
/// that there.
template <int D>
ARENITE_COLD double ContactBalance<D>::follow(const U& x, const U& direction, double begin) {
  const auto look_at = [&](double share) {
    U at = x;
    for (int k = 0; k < N; ++k) at[k] += share * direction[k];
    look(at);
    return dot(direction, rest_);
  };
  double close = 0, distant = 1, at_near = begin;
  double ahead = look_at(1);
  if (ahead <= 0.9 * std::abs(begin) || size_of_rest() <= solved * magnitude_) return 1;
  double share = 1, at_far = ahead;
  for (int k = 0; k < 40; ++k) {
    share = k % 3 == 2 ? (close + distant) / 2 : close + (distant - close) * at_near / (at_near - at_far);
    ahead = look_at(share);
    if (std::abs(ahead) <= 0.1 * std::abs(begin)) break;
    (ahead < 0 ? close : distant) = share;
    (ahead < 0 ? at_near : at_far) = ahead;
  }
  return share;
}

#define ARENITE_INSTANCES(D)                                                                            \
  template Mat<double, D> coulomb_slope(const Vec<double, D>&, const Vec<double, D>&, const Friction&,  \
                                        bool);                                                          \
  template struct ResistingNode<D, D>;                                                                  \
  template struct ResistingNode<D, D + rotations<D>>;                                                   \
  template Mat<double, D> resistance_of(const std::vector<ResistingNode<D, D>>&, const Vec<double, D>&, \
                                        const Friction&, bool);                                         \
  template Mat<double, D + rotations<D>> resistance_of(                                                 \
      const std::vector<ResistingNode<D, D + rotations<D>>>&, const Vec<double, D + rotations<D>>&,     \
      const Friction&, bool);                                                                           \
  template class ContactBalance<D>;
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
