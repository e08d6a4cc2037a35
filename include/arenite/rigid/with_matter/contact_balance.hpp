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

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/with_matter/contact_balance_cold.hpp>
#endif
