// Body force: an acceleration of all matter that depends on the place.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <utility>

#include <arenite/functions/place_function.hpp>
#include <arenite/load/node_force.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A force on a unit of mass, m/s2, as a function of place and time: `body_force([](const auto& x, double t)
/// { return std::array{..}; })`. It is evaluated at the nodes and acts on their masses: the total on matter
/// is exact for functions that are linear in the position, else off by the second order of the cell size. An
/// acceleration that is the same everywhere is `gravity`.
struct BodyForce {
  VectorFunction value;
};
inline BodyForce body_force(VectorFunction value) { return {std::move(value)}; }

/// A body force in a mesh: a part that adds the forces of the start of the step.
template <class T, int D>
class BoundBodyForce : public BookedForces<T, D> {
 public:
  explicit BoundBodyForce(BodyForce f) : value_{std::move(f.value)} {}

  template <class Scene>
  void add_force(Scene& scene, double) {
    this->act(scene, [&](const Vec<T, D>& x, const NodeSums<T, D>& sums) {
      return Vec<T, D>(sums.mass() * acceleration_at(x, scene.time));
    });
  }
  /// At a position, m, and a time, s: what geostatic stresses take for gravity, m/s2.
  Vec<T, D> acceleration_at(const Vec<T, D>& x, double time) const {
    return value_at(value_, x, time, "body force");
  }

 private:
  VectorFunction value_;
};

template <class Traits>
BoundBodyForce<typename Traits::T, Traits::D> bind_part(const BodyForce& force, const Traits&) {
  return BoundBodyForce<typename Traits::T, Traits::D>(force);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
