// The rigid bodies of a scene as they touch one another: pairs, points, and the impulses of all of them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <arenite/contact/coulomb.hpp>
#include <arenite/contact/relaxed_impulse.hpp>
#include <arenite/core/error.hpp>
#include <arenite/rigid/between_bodies/contact_points.hpp>
#include <arenite/rigid/between_bodies/contact_solver.hpp>
#include <arenite/rigid/body/twist.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Two rigid bodies by name (or number, as a word) with their own friction; without one they do not
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

  std::vector<TouchingBody<D>> bodies{};                ///< in the order of the scene, then walls
  std::vector<std::vector<ContactSegment>> segments{};  ///< [bodies]
  std::vector<RigidTouch<D>> touches{};                 ///< of the last step
  double deepest = 0;                                   ///< overlap since the start, m

  /// Walls come last among the bodies. A wall stops bodies with a mass, but a smooth one none that crosses it
  /// at the start: it is a plane of symmetry then.
  void set_pairs(const Friction& of_all, const std::optional<Friction>& of_walls,
                 const std::vector<RigidPair>& exceptions) {
    using Kind = typename TouchingBody<D>::Kind;
    pairs_.clear();
    for (std::size_t a = 0; a < bodies.size(); ++a)
      for (std::size_t b = a + 1; b < bodies.size(); ++b) {
        if (bodies[b].is_wall() && bodies[a].kind != Kind::with_mass) continue;
        std::optional<Friction> friction = bodies[b].is_wall() ? of_walls : of_all;
        for (const auto& p : exceptions) {
          const std::size_t x = number_of(p.first), y = number_of(p.second);
          require(x != y, "RigidContact.pairs", p.first, "must be two different bodies");
          if (std::minmax(x, y) == std::minmax(a, b)) friction = p.friction;
        }
        if (!friction) continue;
        require(!segments[a].empty() || !segments[b].empty(), "RigidContact",
                joined_text({bodies[a].name, ", ", bodies[b].name}),
                "one of both must be a shape with contact_segments(), such as Ball, Box or Polygon");
        if (bodies[b].kind == Kind::smooth_wall && least_gap(a, b) < -least_overlap(a, b)) continue;
        pairs_.push_back({a, b, friction->coefficient()});
      }
  }
  /// Throws `error` if two bodies overlap where they are.
  void check_start() const {
    for (const auto& [first, second, friction] : pairs_) check_start(first, second);
  }

  /// Finds where bodies touch, or may within a step of dt, s; they move with their twists.
  void find(double dt) {
    touches.clear();
    rows_.clear();
    speed_ = 0;
    for (const auto& b : bodies) speed_ = std::max(speed_, b.speed(reach_of(b)));
    for (const auto& [first, second, friction] : pairs_) {
      if (!bodies[first].moves() && !bodies[second].moves()) continue;
      const double size = std::min(bodies[first].size, bodies[second].size);
      // A body may be thrown as fast as twice the fastest.
      const double margin = 4 * dt * speed_ + (std::isfinite(size) ? 1e-4 * size : 0);
      ContactPoints<D>::find(bodies, first, second, margin, touches);
      ContactPoints<D>::find(bodies, second, first, margin, touches);
      while (rows_.size() < touches.size())
        if (!add_row(touches[rows_.size()], friction))
          touches.erase(touches.begin() + static_cast<std::ptrdiff_t>(rows_.size()));
    }
    set_end_gaps();
    expected_.clear();
    goals_.clear();
    for (std::size_t k = 0; k < touches.size(); ++k) {
      const auto& t = touches[k];
      deepest = std::max(deepest, -t.gap);
      // Out of an overlap no faster than the bodies would close without contact: no energy comes of it.
      const double closing = std::max(0.0, -velocity_of(k)[0]);
      goals_.push_back(t.gap >= 0 ? 0 : t.gap + std::min(-0.2 * t.gap, dt * closing));
    }
  }
  /// Gaps with the bodies where they are at the end of the step.
  void set_end_gaps() {
    for (auto& t : touches) t.end_gap = ContactPoints<D>::end_gap(bodies, t);
  }

  /// Whether no point overlaps at the end of the step, those that push touch, and the bodies move as the
  /// impulses were found for.
  bool is_solved(double dt, double precision) const {
    for (std::size_t k = 0; k < expected_.size(); ++k)
      if (!((expected_[k] - bodies[k].twist).template head<D>().norm() <= precision * speed_)) return false;
    for (std::size_t k = 0; k < touches.size(); ++k) {
      const double enough = precision * (dt * speed_ + 1e-6 * std::abs(touches[k].gap)),
                   off = touches[k].end_gap - goals_[k];
      if (off < -enough || (rows_[k].impulse[0] > 0 && off > enough)) return false;
    }
    return true;
  }
  /// Finds the impulses for the bodies' mobilities.
  void solve(double dt) {
    expected_.resize(bodies.size());
    for (std::size_t k = 0; k < bodies.size(); ++k) expected_[k] = bodies[k].twist;
    for (std::size_t k = 0; k < touches.size(); ++k) {
      auto& row = rows_[k];
      row.least = velocity_of(k)[0] + (goals_[k] - touches[k].end_gap) / dt;
      set_response(row);
    }
    solver_.solve(rows_, expected_, speed_);
    for (auto& b : bodies) b.impulse.setZero();
    for (std::size_t k = 0; k < touches.size(); ++k) {
      const auto& row = rows_[k];
      touches[k].impulse = row.to[0].template leftCols<D>().transpose() * row.impulse;
      for (int i = 0; i < 2; ++i) bodies[row.body[i]].impulse += row.to[i].transpose() * row.impulse;
    }
  }

 private:
  struct Pair {
    std::size_t first, second;
    double friction;
  };
  std::size_t number_of(const std::string& name) const {
    for (std::size_t k = 0; k < bodies.size(); ++k)
      if (bodies[k].name == name) return k;
    require(false, "RigidContact.pairs", name, "must be the name or the number of a rigid body of the scene");
    return 0;
  }
  void check_start(std::size_t first, std::size_t second) const {
    require(least_gap(first, second) >= -least_overlap(first, second), "RigidContact",
            joined_text({bodies[first].name, ", ", bodies[second].name}), "must not overlap at the start");
  }
  /// Least gap of two bodies where they are, m; 0 where they do not overlap.
  double least_gap(std::size_t first, std::size_t second) const {
    std::vector<RigidTouch<D>> found;
    ContactPoints<D>::find(bodies, first, second, 0, found);
    ContactPoints<D>::find(bodies, second, first, 0, found);
    double least = 0;
    for (const auto& t : found) least = std::min(least, t.gap);
    return least;
  }
  /// From here on two bodies count as overlapping, m.
  double least_overlap(std::size_t first, std::size_t second) const {
    return 1e-4 * std::min(bodies[first].size, bodies[second].size);
  }
  /// Greatest distance of a body's points from its centre, m.
  double reach_of(const TouchingBody<D>& b) const {
    double square = 0;
    for (int i = 0; i < D; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double distant = std::max(std::abs(b.distance->lower()[k] - b.begin.centre[i]),
                                      std::abs(b.distance->upper()[k] - b.begin.centre[i]));
      if (std::isfinite(distant)) square += distant * distant;
    }
    return std::sqrt(square);
  }
  /// False if no impulse along the normal moves either body.
  bool add_row(const RigidTouch<D>& t, double friction) {
    ContactConstraint<D> row;
    row.body[0] = t.first;
    row.body[1] = t.second;
    row.friction = friction;
    const Mat<double, D> axes = contact_axes<D>(t.normal);
    for (int i = 0; i < 2; ++i)
      row.to[i] = (i == 0 ? 1.0 : -1.0) * axes * velocity_map<D, N>(t.place - bodies[row.body[i]].centre());
    set_response(row);
    const double any = bodies[t.first].mobility.template topLeftCorner<D, D>().trace() +
                       bodies[t.second].mobility.template topLeftCorner<D, D>().trace();
    if (!(row.response(0, 0) > 1e-12 * any)) return false;
    rows_.push_back(row);
    return true;
  }
  void set_response(ContactConstraint<D>& row) const {
    row.response.setZero();
    for (int i = 0; i < 2; ++i) {
      row.by[i] = bodies[row.body[i]].mobility * row.to[i].transpose();
      row.response += row.to[i] * row.by[i];
    }
  }
  V velocity_of(std::size_t k) const {
    const auto& row = rows_[k];
    return row.to[0] * bodies[row.body[0]].twist + row.to[1] * bodies[row.body[1]].twist;
  }

  std::vector<Pair> pairs_{};
  std::vector<ContactConstraint<D>> rows_{};  // [touches]
  std::vector<double> goals_{};               // [touches] least gaps at the end of the step, m
  std::vector<Vec<double, N>> expected_{};    // [bodies] twists; none before the first solution
  ContactSolver<D> solver_{};
  double speed_ = 0;  // greatest one of the step, m/s
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
