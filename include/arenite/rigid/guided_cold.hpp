// Cold functions of guided.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <arenite/core/error.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/rigid/guided.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <class T, int D>
ARENITE_COLD BoundGuided<T, D>::BoundGuided(const Guided& g, bool hoop)
    : mass{g.mass}, load{g.load}, speed{static_cast<T>(g.velocity)} {
  require(g.mass > 0 && std::isfinite(g.mass), "Guided.mass", g.mass, "must be given, positive");
  require(std::isfinite(g.velocity), "Guided.velocity", g.velocity, "must be finite");
  require(load.is_uniform(), "Guided.load", "f(x, t)", "must be a number or a function of time");
  if (load.is_constant()) {
    const double force = load({}, 0);
    require(std::isfinite(force), "Guided.load", force, "must be finite");
  }
  axis = direction_argument<T, D>("Guided.axis", g.axis);
  require(!hoop || axis[0] == 0, "Guided.axis", vector_text(axis),
          "must be the axis of symmetry (0, 1) in an axisymmetric scene");
  axis.normalize();
}

template <class T, int D>
ARENITE_COLD auto BoundGuided<T, D>::free_velocity(const V& before, const V& acceleration, T time, T dt) const
    -> V {
  const double begin = static_cast<double>(time) - static_cast<double>(dt);
  const double force = value_at<double, D>(load, Vec<double, D>::Zero(), begin, "Guided.load");
  const T own = acceleration.dot(axis) + static_cast<T>(force / mass);
  return before + dt * own * axis;
}

template <class T, int D>
ARENITE_COLD auto BoundGuided<T, D>::after(const V& contact_velocity, const V& free_velocity, const V& total,
                                           const Vec<T, 2>& exchanged) const -> V {
  const V change = contact_velocity - free_velocity;
  const T m = static_cast<T>(mass), left = m * change.dot(axis) + total.dot(axis);
  if (detail::is_round_off(std::abs(left), exchanged[0], 16)) return contact_velocity;
  return free_velocity - (total.dot(axis) / m) * axis;
}

template <class T, int D>
ARENITE_COLD Mat<double, D> BoundGuided<T, D>::mobility(const Mat<double, D>& added) const {
  const Vec<double, D> along = axis.template cast<double>();
  return along * along.transpose() / (mass + along.dot(added * along));
}

template <class T, int D>
ARENITE_COLD double BoundGuided<T, D>::work(const V& before, const V& free_velocity, const V& mean,
                                            const V&) const {
  const V change = free_velocity - before;
  return static_cast<double>(static_cast<T>(mass) * change.dot(mean));
}

#define ARENITE_INSTANCES(T, D) template struct BoundGuided<T, D>;
ARENITE_FOR_NUMBERS_AND_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
