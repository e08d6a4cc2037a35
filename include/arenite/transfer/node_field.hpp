// Node field: what one velocity field of the background mesh stores. A scene has one, or one for each body in
// contact.
#pragma once

#include <vector>

#include <arenite/core/parallel.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite {

/// Columns over all nodes of the mesh. `Mapped`: a second velocity for the stress update (MUSL); `Gradient`:
/// the gradient of mass, for contact normals. What is not asked for is not stored.
template <real T, int D, bool Mapped, bool Gradient>
struct NodeField {
  static constexpr bool has_mapped = Mapped;
  static constexpr bool has_gradient = Gradient;

  std::vector<T> mass;  ///< [nodes] kg
  std::vector<Vec<T, D>>
      start;  ///< [nodes] momentum (kg m/s) while points scatter, then velocity at the step's begin (m/s)
  std::vector<Vec<T, D>> force;     ///< [nodes] internal force of the points, N
  std::vector<Vec<T, D>> velocity;  ///< [nodes] velocity at the step's end, m/s
  std::vector<Vec<T, D>> mapped;    ///< [nodes if Mapped] momentum, then velocity for the stress update, m/s
  std::vector<Vec<T, D>>
      mass_gradient;  ///< [nodes if Gradient] sum of m grad N, kg/m: points out of the body

  explicit NodeField(Index nodes)
      : mass(nodes, T(0)),
        start(nodes, Vec<T, D>::Zero()),
        force(start),
        velocity(start),
        mapped(Mapped ? nodes : 0, Vec<T, D>::Zero()),
        mass_gradient(Gradient ? nodes : 0, Vec<T, D>::Zero()) {}

  std::size_t size() const { return mass.size(); }

  void clear() {
    const Vec<T, D> zero = Vec<T, D>::Zero();
    parallel_chunks(size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        mass[i] = 0;
        start[i] = zero;
        force[i] = zero;
        if constexpr (Mapped) mapped[i] = zero;
        if constexpr (Gradient) mass_gradient[i] = zero;
      }
    });
  }

  /// Velocity from which strains are taken.
  const std::vector<Vec<T, D>>& strain_velocity() const {
    if constexpr (Mapped) return mapped;
    return velocity;
  }

  std::size_t bytes() const {
    return mass.size() * sizeof(T) +
           (start.size() + force.size() + velocity.size() + mapped.size() + mass_gradient.size()) *
               sizeof(Vec<T, D>);
  }
};

}  // namespace arenite
