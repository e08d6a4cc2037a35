// Columns of a body's points without the types of its law: what observers read of points in plain functions.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>

#include <arenite/particles/body.hpp>
#include <arenite/particles/measures.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The columns that all bodies have, each [count]. They are valid until points are added, removed or sorted.
template <class T>
struct PointColumns {
  std::size_t count = 0;
  int dimension = 0;
  double density = 0;                              // of the law, kg/m3
  std::array<const T*, 3> position{}, velocity{};  // [dimension] m, m/s
  std::array<const T*, 6> stress{};                // as in `Sym`, Pa
  const T *mass = nullptr, *volume = nullptr;      // kg, m3
  const Index* cell = nullptr;
};

template <class L, class T, int D, ExtraColumns E>
PointColumns<T> columns_of_points(const Body<L, T, D, E>& body) {
  const auto& points = body.points;
  PointColumns<T> columns{.count = points.size(),
                          .dimension = D,
                          .density = body.law.density(),
                          .position = column_data(points.position),
                          .velocity = column_data(points.velocity),
                          .mass = points.mass.data(),
                          .volume = points.volume.data(),
                          .cell = points.cell.data()};
  for (std::size_t k = 0; k < Sym<T, D>::size; ++k) columns.stress[k] = points.stress.column(k).data();
  return columns;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
