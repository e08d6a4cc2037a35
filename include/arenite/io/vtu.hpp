// Unstructured VTK files (.vtu) out, for ParaView, VTK and meshio.
// Data are in raw appended form, which ParaView and meshio read: base64 would take a third more bytes, and
// time. Format: "VTK XML file formats", docs.vtk.org, version 1.0 with 64-bit sizes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite/core/scalar.hpp>
#include <arenite/io/file_path.hpp>
#include <arenite/io/vtu_array.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Cells of one kind, given by the number of their points: 1 vertex, 2 line, 3 triangle, 4 tetrahedron.
struct VtuCells {
  std::size_t points = 1;  ///< of each cell
  std::size_t items = 0;
  std::function<Index(std::size_t cell, std::size_t corner)> point;
};

/// A view of `cells`, which must outlive it.
template <std::size_t N>
VtuCells vtu_cells(std::span<const std::array<Index, N>> cells) {
  static_assert(N >= 1 && N <= 4,
                "vtu_cells: a cell has 1 to 4 points (vertex, line, triangle, tetrahedron)");
  return {N, cells.size(), [=](std::size_t cell, std::size_t corner) { return cells[cell][corner]; }};
}
template <std::size_t N>
VtuCells vtu_cells(const std::vector<std::array<Index, N>>& cells) {
  return vtu_cells(std::span<const std::array<Index, N>>(cells));
}

template <std::size_t N>
VtuCells vtu_cells(const std::vector<std::array<Index, N>>&& cells) = delete;

/// A vertex on each of `count` points: ParaView shows no point that is in no cell.
inline VtuCells vtu_vertices(std::size_t count) {
  return {1, count, [](std::size_t cell, std::size_t) { return static_cast<Index>(cell); }};
}

/// Contents of a VTU file.
struct VtuData {
  VtuArray points;                   ///< [points x 3], m, double or float; its name is not used
  std::vector<VtuCells> cells;       ///< in this order
  std::vector<VtuArray> point_data;  ///< [points x components] each
  std::vector<VtuArray> cell_data;   ///< [cells x components] each
};

namespace shared_detail {

/// Connectivity, offsets and types of all cells, as arrays; the first two of 64-bit integers if `wide`, else of 32-bit ones.
std::vector<VtuArray> vtu_topology(const std::vector<VtuCells>& blocks, std::size_t points, bool wide);

/// Throws `error` unless all shapes fit; returns the number of all corners of cells.
std::size_t check_vtu_data(const VtuData& data);

}  // namespace shared_detail

/// Writes `data` to `path`, whose folder must exist. A file of that name stays as it was until the new one is
/// complete. Throws `error`: shapes that do not fit, a cell's point that is not there, or a disk that does
/// not take the file.
void write_vtu(const FilePath& path, const VtuData& data);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/io/vtu_cold.hpp>
#endif
