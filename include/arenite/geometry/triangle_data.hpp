// Triangles as data: what readers return and a `TriangleSurface` is made of.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Triangles in space. Each names three vertices, counter-clockwise as seen from outside of the body.
struct TriangleData {
  std::vector<Vec<double, 3>> vertices;         ///< m
  std::vector<std::array<Index, 3>> triangles;  ///< vertex numbers from 0
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
