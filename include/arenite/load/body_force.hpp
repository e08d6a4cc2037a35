// Body force: an acceleration of all matter that depends on the place.
#pragma once

#include <array>
#include <utility>

#include <arenite/boundary/place_function.hpp>
#include <arenite/core/failure.hpp>
#include <arenite/core/part_energy.hpp>
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

/// The same in a mesh: a part that adds forces, those of the step's begin.
template <class T, int D>
class BoundBodyForce {
 public:
  explicit BoundBodyForce(BodyForce f) : value_{std::move(f.value)} {}

  template <class Scene>
  void connect(Scene& scene) {
    forces_.connect(scene);
  }
  template <class Scene>
  void add_force(Scene& scene, double) {
    Failure failure;
    for (std::size_t k = 0; k < forces_.field.size(); ++k) {
      const auto& field = scene.fields[k];
      auto& force = forces_.field[k].force;
      parallel_chunks(field.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          force[i].setZero();
          const T mass = field.collected[i].mass();
          if (mass > 0)
            failure.guard(i, [&] {
              const Vec<T, D> x = Scene::Shape::node_position(scene.mesh, static_cast<Index>(i));
              force[i] = mass * value_at(value_, x, scene.time, "body force");
            });
        }
      });
    }
    failure.rethrow();
    forces_.add_to(scene);
  }
  template <class Scene>
  void follow_motion(Scene& scene, double dt) {
    work_ += forces_.work(scene, dt);
  }
  /// At a position, m, and a time, s: what geostatic stresses take for gravity, m/s2.
  Vec<T, D> acceleration_at(const Vec<T, D>& x, double time) const {
    return value_at(value_, x, time, "body force");
  }
  PartEnergy count_energy() const { return {.external = work_}; }
  bool holds_against(const Vec<T, D>&) const { return false; }
  template <class F>
  void visit_state(F&& f) {
    f("work", work_);
  }

 private:
  VectorFunction value_;
  FieldForces<T, D> forces_;
  double work_ = 0;  // since the start, J
};

template <class Site>
BoundBodyForce<typename Site::T, Site::D> bind_part(const BodyForce& force, const Site&) {
  return BoundBodyForce<typename Site::T, Site::D>(force);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
