// A simplex mesh as a file or a generator gives it: plain arrays, nothing derived.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/map.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Raw triangles (D = 2) or tetrahedra (D = 3). Cells may be oriented either way; `SimplexMesh` turns and
/// checks them.
template <int D>
struct MeshData {
  std::vector<Vec<double, D>> nodes;               ///< [nodes] position, m
  std::vector<std::array<Index, D + 1>> cells;     ///< [cells] nodes of each cell
  std::vector<int> region;                         ///< [cells] region of each cell; empty: all 0
  Map<std::string, int> region_names;              ///< name to region
  Map<std::string, std::vector<Index>> node_sets;  ///< name to nodes, ascending, each once
  /// Name to further regions that it means: those of cells that have several names.
  Map<std::string, std::vector<int>> shared_regions{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
