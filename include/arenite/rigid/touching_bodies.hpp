// The rigid bodies of a scene as they touch one another: pairs, points, and the impulses of all of them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <arenite/contact/coulomb.hpp>
#include <arenite/rigid/contact_points.hpp>
#include <arenite/rigid/contact_solver.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Two rigid bodies by name (or number, as a word) with a friction of their own; without one they do not
/// touch each other.
struct RigidPair {
  std::string first, second;
  std::optional<Friction> friction{};
};

template <int D>
class TouchingBodies {
 public:
  using V = Vec<double, D>;
  static constexpr int N = D + rotations<D>;

  std::vector<TouchingBody<D>> bodies{};                ///< in the order of the scene
  std::vector<std::vector<ContactSegment>> segments{};  ///< [bodies]
  std::vector<RigidTouch<D>> touches{};                 ///< of the last step
  double deepest = 0;                                   ///< overlap since the start, m

  void set_pairs(const Friction& of_all, const std::vector<RigidPair>& exceptions);
  /// Throws `error` if two bodies overlap where they are.
  void check_start() const;

  /// Finds where bodies touch, or may within a step of dt, s; they move with their twists.
  void find(double dt);
  /// Gaps with the bodies where they are at the end of the step.
  void set_end_gaps();

  /// Whether no point overlaps at the end of the step, those that push touch, and the bodies move as the
  /// impulses were found for.
  bool is_solved(double dt, double precision) const;
  /// Finds the impulses, as far as the bodies answer to them with their mobilities.
  void solve(double dt);

 private:
  struct Pair {
    std::size_t first, second;
    double friction;
  };
  std::size_t number_of(const std::string& name) const;
  void check_start(std::size_t first, std::size_t second) const;
  /// Greatest distance of a body's points from its centre, m.
  double reach_of(const TouchingBody<D>& b) const;
  /// False if no impulse along the normal moves either body.
  bool add_row(const RigidTouch<D>& t, double friction);
  void set_response(ContactConstraint<D>& row) const;
  V velocity_of(std::size_t k) const;

  std::vector<Pair> pairs_{};
  std::vector<ContactConstraint<D>> rows_{};  // [touches]
  std::vector<double> goals_{};               // [touches] least gaps at the end of the step, m
  std::vector<Vec<double, N>> expected_{};    // [bodies] twists; none before the first solution
  ContactSolver<D> solver_{};
  double speed_ = 0;  // greatest one of the step, m/s
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/rigid/touching_bodies_cold.hpp>
#endif
