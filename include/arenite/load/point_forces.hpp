// Point forces: loads that act where material points are, and go with them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/load/node_force.hpp>
#include <arenite/parallel/failure.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A part that adds the forces of some points of a body to the nodes, with the shape functions at the
/// positions at the start of the step. `Load`: the numbers stored with each point, and the force they give:
/// - `columns`: numbers by point, not all zero where a point is loaded; `body`: a `BodyName`; `name()`;
/// - `place(scene, body, set)`: calls `set(p, numbers)` for the loaded points of a new scene;
/// - `force(x, numbers, time)`: N, at a position; may throw, and runs on several threads;
/// - `follow(numbers, gradient, hoop, dt)`: the numbers after a step with this velocity gradient, 1/s, and
///   hoop rate v_r / r, if `deforms`.
template <class T, int D, class Load>
class BoundPointForces : public BookedForces<T, D> {
 public:
  static constexpr int point_columns = Load::columns;
  using Numbers = Vec<T, Load::columns>;

  explicit BoundPointForces(Load load) : load_{std::move(load)} {}

  template <class Scene>
  void connect(Scene& scene) {
    first_ = first_point_column(scene, *this);
    body_ = scene.number_of(load_.body, joined_text({load_.name(), ": body"}));
    std::size_t count = 0;
    with_body(scene, [&](auto& body, auto&) {
      load_.place(scene, body, [&](std::size_t p, const Numbers& numbers) {
        set(body.points, p, numbers);
        ++count;
      });
    });
    require(count > 0 || Scene::is_portion, {load_.name(), ": points"}, count,
            "must be at least one point of the body");
    this->forces_.resize(scene.fields.size());  // those of other bodies stay empty
    nodes<Scene>().clear(Scene::Shape::node_count(scene.mesh));
  }

  template <class Scene>
  void add_force(Scene& scene, double) {
    auto& nodes = this->template nodes<Scene>();
    nodes.clear(Scene::Shape::node_count(scene.mesh));
    with_body(scene, [&](auto& body, auto& field) {
      find_loaded(body.points);
      force_.resize(loaded_.size());
      Failure failure;
      parallel_chunks(loaded_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          failure.guard(k, [&] {
            const Index p = loaded_[k];
            force_[k] = load_.force(Vec<T, D>(body.points.position[p]), get(body.points, p), scene.time);
          });
      });
      failure.rethrow();
      each_in_cell(scene, body, 0, loaded_.size(), [&](const auto& cell, std::size_t k) {
        const auto w = cell.weights(body.points.position[loaded_[k]]);
        for (std::size_t i = 0; i < cell.nodes.size(); ++i)
          nodes.force[cell.nodes[i]] += w[static_cast<int>(i)] * force_[k];
      });
      nodes.sum(scene);
      nodes.add_to(field.sums);
    });
  }

  template <class Scene>
  void follow_motion(Scene& scene, double dt) {
    BookedForces<T, D>::follow_motion(scene, dt);
    if constexpr (Load::deforms)
      with_body(scene, [&](auto& body, auto& field) {
        parallel_chunks(loaded_.size(), [&](std::size_t begin, std::size_t end) {
          each_in_cell(scene, body, begin, end, [&](const auto& cell, std::size_t k) {
            deform<typename Scene::Kinematics>(cell, field, body.points, loaded_[k], static_cast<T>(dt));
          });
        });
      });
  }

 private:
  template <class Scene>
  NodeForce<T, D>& nodes() {
    return this->forces_[Scene::field_of(body_)];
  }
  template <class Points>
  Numbers get(const Points& points, std::size_t p) const {
    Numbers numbers;
    for (int k = 0; k < Load::columns; ++k)
      numbers[k] = points.part_columns[first_ + static_cast<std::size_t>(k)][p];
    return numbers;
  }
  template <class Points>
  void set(Points& points, std::size_t p, const Numbers& numbers) {
    for (int k = 0; k < Load::columns; ++k)
      points.part_columns[first_ + static_cast<std::size_t>(k)][p] = numbers[k];
  }

  /// Calls `f(body, field)` for the body that is loaded.
  template <class Scene, class F>
  void with_body(Scene& scene, F&& f) {
    std::size_t number = 0;
    scene.for_each_body([&](auto& body, auto& field) {
      if (number++ == body_) f(body, field);
    });
  }
  /// Lists the loaded points. Most chunks of points have none: the test of a whole chunk takes packs.
  template <class Points>
  void find_loaded(const Points& points) {
    has_loaded_.assign((points.size() + chunk_size - 1) / chunk_size, 0);
    parallel_chunks(points.size(), [&](std::size_t begin, std::size_t end) {
      T any = 0;
      for (int k = 0; k < Load::columns; ++k)
        for (std::size_t p = begin; p < end; ++p)
          any += std::abs(points.part_columns[first_ + static_cast<std::size_t>(k)][p]);
      has_loaded_[begin / chunk_size] = any != 0;
    });
    loaded_.clear();
    for (std::size_t chunk = 0; chunk < has_loaded_.size(); ++chunk)
      if (has_loaded_[chunk])
        for (std::size_t p = chunk * chunk_size; p < std::min(points.size(), (chunk + 1) * chunk_size); ++p)
          if ((get(points, p).array() != 0).any()) loaded_.push_back(static_cast<Index>(p));
  }

  /// Calls `f(cell, k)` for the loaded points number `begin` to `end`, with the shape functions of its cell.
  template <class Scene, class Body, class F>
  void each_in_cell(const Scene& scene, const Body& body, std::size_t begin, std::size_t end, F&& f) const {
    using Cell = typename Scene::Shape::template Cell<typename Scene::Mesh>;
    std::optional<Cell> cell;  // remade if the next point is in another one
    Index number = none;
    for (std::size_t k = begin; k < end; ++k) {
      if (const Index c = body.points.cell[loaded_[k]]; c != number) cell.emplace(scene.mesh, number = c);
      f(*cell, k);
    }
  }

  /// Updates the numbers of a point over a step with the velocities of the nodes.
  template <class K, class Cell, class Field, class Points>
  void deform(const Cell& cell, const Field& field, Points& points, Index p, T dt) {
    const Vec<T, D> x = points.position[p];
    const auto g = cell.gradients(x);
    const auto w = cell.weights(x);
    Mat<T, D> gradient = Mat<T, D>::Zero();
    T radial = 0;
    for (std::size_t i = 0; i < cell.nodes.size(); ++i) {
      const Vec<T, D>& v = field.velocity[cell.nodes[i]];
      gradient += v * g.col(static_cast<int>(i)).transpose();
      radial += w[static_cast<int>(i)] * v[0];
    }
    const T hoop = K::hoop && x[0] > 0 ? radial / x[0] : T(0);
    set(points, p, load_.follow(get(points, p), gradient, hoop, dt));
  }

  Load load_;
  std::size_t first_ = 0, body_ = 0;
  std::vector<Index> loaded_;     // points of this step
  std::vector<Vec<T, D>> force_;  // [loaded points] N
  std::vector<char> has_loaded_;  // [chunks of points]
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
