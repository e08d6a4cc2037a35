// The kinds of elements that a Gmsh file can contain, and their names in messages.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// A kind of element of the Gmsh reference manual's list "elementType" (chapter "MSH file format").
struct GmshKind {
  int number = 0;
  std::size_t dim = 0;
  std::size_t nodes = 0;  ///< 0: higher order
  const char* name = "";
};

inline constexpr std::array<GmshKind, 33> gmsh_kinds{{
    {1, 1, 2, "line"},
    {2, 2, 3, "triangle"},
    {3, 2, 4, "quadrangle"},
    {4, 3, 4, "tetrahedron"},
    {5, 3, 8, "hexahedron"},
    {6, 3, 6, "prism"},
    {7, 3, 5, "pyramid"},
    {8, 1, 0, "3-node line"},
    {9, 2, 0, "6-node triangle"},
    {10, 2, 0, "9-node quadrangle"},
    {11, 3, 0, "10-node tetrahedron"},
    {12, 3, 0, "27-node hexahedron"},
    {13, 3, 0, "18-node prism"},
    {14, 3, 0, "14-node pyramid"},
    {15, 0, 1, "point"},
    {16, 2, 0, "8-node quadrangle"},
    {17, 3, 0, "20-node hexahedron"},
    {18, 3, 0, "15-node prism"},
    {19, 3, 0, "13-node pyramid"},
    {20, 2, 0, "9-node triangle"},
    {21, 2, 0, "10-node triangle"},
    {22, 2, 0, "12-node triangle"},
    {23, 2, 0, "15-node triangle"},
    {24, 2, 0, "15-node triangle"},
    {25, 2, 0, "21-node triangle"},
    {26, 1, 0, "4-node line"},
    {27, 1, 0, "5-node line"},
    {28, 1, 0, "6-node line"},
    {29, 3, 0, "20-node tetrahedron"},
    {30, 3, 0, "35-node tetrahedron"},
    {31, 3, 0, "56-node tetrahedron"},
    {92, 3, 0, "64-node hexahedron"},
    {93, 3, 0, "125-node hexahedron"},
}};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
