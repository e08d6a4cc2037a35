// Measures of a body: energies, momentum, volume. Each sums over the points in fixed chunks, the same on any
// number of threads.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <functional>

#include <arenite/core/cold.hpp>
#include <arenite/particles/body.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Sum of `f(point)` over `count` points. Each chunk keeps eight partial sums, as each addition to a single one
/// would have to wait for the one before.
template <class Value, class F>
Value sum_points(std::size_t count, Value zero, F&& f) {
  return parallel_reduce(
      count, zero,
      [&](std::size_t begin, std::size_t end) {
        constexpr std::size_t lanes = 8;
        std::array<Value, lanes> sum;
        sum.fill(zero);
        std::size_t p = begin;
        for (; p + lanes <= end; p += lanes)
          for (std::size_t k = 0; k < lanes; ++k) sum[k] += f(p + k);
        for (std::size_t k = 0; p < end; ++p, ++k) sum[k] += f(p);
        Value all = zero;
        for (const Value& part : sum) all += part;
        return all;
      },
      std::plus<>{});
}

/// Over the points of a body.
template <class B, class Value, class F>
requires requires(const B& body) { body.points; }
Value sum_points(const B& body, Value zero, F&& f) { return sum_points(body.points.size(), zero, f); }

/// Sums over columns, of `count` points each.
template <class T>
double sum_column(const T* values, std::size_t count);
/// Sum of m v^2 / 2; `velocity`: [dimension].
template <class T>
double kinetic_energy(std::size_t count, const T* mass, int dimension,
                      const std::array<const T*, 3>& velocity);
/// Sum of m x, kg m; `position`: [dimension].
template <class T>
std::array<double, 3> moment_of_mass(std::size_t count, const T* mass, int dimension,
                                     const std::array<const T*, 3>& position);

/// Where the columns of vectors begin.
template <class T, int D>
std::array<const T*, 3> column_data(const VectorColumns<T, D>& columns) {
  std::array<const T*, 3> data{};
  for (std::size_t k = 0; k < D; ++k) data[k] = columns.column(k).data();
  return data;
}

/// Kinetic energy of the points' velocities, J; that of their velocity gradients is
/// `gradient_kinetic_energy`.
template <class B>
double kinetic_energy(const B& body) {
  const auto& p = body.points;
  return kinetic_energy(p.size(), p.mass.data(), p.dimension, column_data(p.velocity));
}

/// Kinetic energy, J, of the velocity gradients C that points carry (APIC, TPIC): sum m/2 C : (C D), with the
/// inertia of the shape functions at the points, D = sum w_i (x_i - x_p)(x_i - x_p)^T. 0 where they carry
/// none. The kinetic energy of the velocity fields that P2G scatters exceeds that of the points' velocities
/// by this much.
template <class Shape, class M, class B>
double gradient_kinetic_energy(const M& mesh, const Blocks& blocks, const B& body) {
  const auto& points = body.points;
  if constexpr (std::remove_cvref_t<decltype(points)>::affine) {
    constexpr std::size_t D = M::dimension;
    const auto of_cell = [&](Index c) {
      double sum = 0;
      if (body.cells.empty(c)) return sum;
      const typename Shape::template Cell<M> cell(mesh, c);
      const auto node = cell.node_positions();
      for (const Index p : body.cells[c]) {
        const auto x = points.position[p];
        const auto w = cell.weights(x);
        double twice = 0;
        for (int i = 0; i < cell.size; ++i)
          for (std::size_t d = 0; d < D; ++d) {
            double v = 0;  // of C (x_i - x_p)
            for (std::size_t a = 0; a < D; ++a)
              v += static_cast<double>(points.velocity_gradient.column(a * D + d)[p] *
                                       (node(static_cast<int>(a), i) - x[static_cast<int>(a)]));
            twice += static_cast<double>(w[i]) * v * v;
          }
        sum += static_cast<double>(points.mass[p]) * twice / 2;
      }
      return sum;
    };
    return blocks.reduce(0.0, of_cell, std::plus<>{});
  } else {
    return 0;
  }
}

/// Recoverable energy, J.
template <class B>
double strain_energy(const B& body) {
  return sum_points(body, 0.0, [&](std::size_t p) {
    return static_cast<double>(body.points.volume[p] * elastic_energy_of(body.law, body.points.stress[p],
                                                                         body.points.load_history(p)));
  });
}

/// Momentum, kg m/s, shape [D].
template <class L, class T, int D, ExtraColumns E>
Vec<double, D> momentum(const Body<L, T, D, E>& body) {
  return sum_points(body, zeros<Vec<double, D>>(), [&](std::size_t p) -> Vec<double, D> {
    return static_cast<double>(body.points.mass[p]) * body.points.velocity[p].template cast<double>();
  });
}

/// Mass of the points, kg.
template <class B>
double mass(const B& body) {
  return sum_column(body.points.mass.data(), body.points.size());
}

/// V, voids that opened included, and V0 of the points together, m3: how much the body has swollen. No other
/// measure shows slow swelling.
template <class B>
std::array<double, 2> volume_and_initial(const B& body) {
  return {sum_column(body.points.volume.data(), body.points.size()) + body.opened_volume,
          body.initial_volume - body.lost_mass / body.law.density()};
}
/// Mean of V / V0, -.
template <class B>
double mean_volume_ratio(const B& body) {
  const auto [volume, initial] = volume_and_initial(body);
  return initial > 0 ? volume / initial : 1.0;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <class T>
ARENITE_COLD double sum_column(const T* values, std::size_t count) {
  return sum_points(count, 0.0, [=](std::size_t p) { return static_cast<double>(values[p]); });
}

template <class T>
ARENITE_COLD double kinetic_energy(std::size_t count, const T* mass, int dimension,
                                   const std::array<const T*, 3>& velocity) {
  return sum_points(count, 0.0, [&](std::size_t p) {
    T square = velocity[0][p] * velocity[0][p] + velocity[1][p] * velocity[1][p];
    if (dimension == 3) square += velocity[2][p] * velocity[2][p];
    return 0.5 * static_cast<double>(mass[p] * square);
  });
}

template <class T>
ARENITE_COLD std::array<double, 3> moment_of_mass(std::size_t count, const T* mass, int dimension,
                                                  const std::array<const T*, 3>& position) {
  std::array<double, 3> moment{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    moment[k] = sum_points(count, 0.0, [&](std::size_t p) {
      return static_cast<double>(mass[p]) * static_cast<double>(position[k][p]);
    });
  return moment;
}

#define ARENITE_INSTANCES(T)                                                                  \
  template double sum_column(const T*, std::size_t);                                          \
  template double kinetic_energy(std::size_t, const T*, int, const std::array<const T*, 3>&); \
  template std::array<double, 3> moment_of_mass(std::size_t, const T*, int, const std::array<const T*, 3>&);
ARENITE_FOR_NUMBERS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
