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

#include <arenite/core/cold.hpp>
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

#if ARENITE_HAS_COLD

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <set>
#include <string_view>
#include <utility>

#include <arenite/core/map.hpp>
#include <arenite/io/output_file.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace shared_detail {

/// The array is one that VTK knows and has `items` items.
ARENITE_COLD void check_vtu_arrays(const std::vector<VtuArray>& arrays, std::size_t items,
                                   std::string_view where) {
  std::set<std::string_view, MapOrder> names;
  for (const VtuArray& a : arrays) {
    require(!a.name.empty() && names.insert(a.name).second, {"name of an array of ", where}, a.name,
            "must be given, and once");
    require(a.components == 1 || a.components == 3 || a.components == 6 || a.components == 9,
            {"components of array ", a.name}, a.components, "must be 1, 3, 6 or 9");
    require(a.items == items, {"items of array ", a.name}, a.items,
            {"must be ", items, ", as ", where, " are"});
  }
}

/// Integers of 4 or 8 bytes each, or of one, as a recipe that owns them.
ARENITE_COLD VtuArray own_integers(std::string name, std::string_view type, std::size_t number_bytes,
                                   std::vector<char> bytes) {
  const std::size_t items = bytes.size() / number_bytes;
  return {std::move(name),
          items,
          1,
          type,
          number_bytes,
          [bytes = std::move(bytes), number_bytes](std::size_t begin, std::size_t end, char* out) {
            if (end > begin)
              std::memcpy(out, bytes.data() + begin * number_bytes, (end - begin) * number_bytes);
          }};
}

ARENITE_COLD std::vector<VtuArray> vtu_topology(const std::vector<VtuCells>& blocks, std::size_t points,
                                                bool wide) {
  std::vector<char> connectivity, offsets, types;
  constexpr std::array<char, 5> vtk_type{0, 1, 3, 5, 10};
  const auto put = [wide](std::vector<char>& bytes, std::size_t value) {
    const auto long_number = static_cast<std::int64_t>(value);
    const auto number = static_cast<std::int32_t>(value);
    const auto* const from =
        wide ? reinterpret_cast<const char*>(&long_number) : reinterpret_cast<const char*>(&number);
    bytes.insert(bytes.end(), from, from + (wide ? sizeof long_number : sizeof number));
  };
  std::size_t corners = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const VtuCells& block = blocks[b];
    require(block.points >= 1 && block.points <= 4, "points of a cell", block.points, "must be 1, 2, 3 or 4");
    for (std::size_t i = 0; i < block.items; ++i) {
      for (std::size_t k = 0; k < block.points; ++k) {
        const Index point = block.point(i, k);
        require(point < points, {"point of cell ", i, " of block ", b}, point,
                {"must be less than ", points});
        put(connectivity, point);
      }
      put(offsets, corners += block.points);
      types.push_back(vtk_type[block.points]);
    }
  }
  const std::string_view type = wide ? vtu_type<std::int64_t>() : vtu_type<std::int32_t>();
  const std::size_t bytes = wide ? sizeof(std::int64_t) : sizeof(std::int32_t);
  std::vector<VtuArray> arrays;
  arrays.push_back(own_integers("connectivity", type, bytes, std::move(connectivity)));
  arrays.push_back(own_integers("offsets", type, bytes, std::move(offsets)));
  arrays.push_back(own_integers("types", vtu_type<std::uint8_t>(), 1, std::move(types)));
  return arrays;
}

ARENITE_COLD std::size_t check_vtu_data(const VtuData& data) {
  require(data.points.components == 3 && data.points.type.starts_with("Float"), "components of the points",
          data.points.components, "points must be [n x 3], double or float");
  std::size_t cells = 0, corners = 0;
  for (const VtuCells& block : data.cells) {
    cells += block.items;
    corners += block.items * block.points;
  }
  check_vtu_arrays(data.point_data, data.points.items, "points");
  check_vtu_arrays(data.cell_data, cells, "cells");
  return corners;
}

/// Declares arrays in the XML part; `offset` is that of the next array in the appended data.
ARENITE_COLD void declare_vtu_arrays(std::ostream& out, std::string_view element,
                                     std::span<const VtuArray> arrays, std::uint64_t& offset) {
  out << "<" << element << ">\n";
  for (const VtuArray& a : arrays) {
    out << "<DataArray type=\"" << a.type << "\" Name=\"" << xml_escape(a.name) << "\"";
    if (a.components > 1) out << " NumberOfComponents=\"" << a.components << "\"";
    out << " format=\"appended\" offset=\"" << offset << "\"/>\n";
    offset += sizeof(std::uint64_t) + a.items * a.components * a.number_bytes;
  }
  out << "</" << element << ">\n";
}

/// Size in bytes, then the values, a piece at a time.
ARENITE_COLD void append_vtu_arrays(std::ostream& out, std::span<const VtuArray> arrays) {
  std::vector<char> piece;
  for (const VtuArray& a : arrays) {
    const std::size_t item = a.components * a.number_bytes;
    const std::uint64_t bytes = a.items * item;
    std::array<char, sizeof bytes> size;
    std::memcpy(size.data(), &bytes, sizeof bytes);
    out.write(size.data(), size.size());
    constexpr std::size_t step = 8192;
    piece.resize(step * item);
    for (std::size_t i = 0; i < a.items && out; i += step) {
      const std::size_t end = std::min(a.items, i + step);
      a.fetch(i, end, piece.data());
      out.write(piece.data(), static_cast<std::streamsize>((end - i) * item));
    }
  }
}

}  // namespace shared_detail

ARENITE_COLD void write_vtu(const FilePath& path, const VtuData& data) {
  const std::size_t points = data.points.items, corners = shared_detail::check_vtu_data(data);
  constexpr std::size_t most = 2147483647;
  const auto topology = shared_detail::vtu_topology(data.cells, points, std::max(points, corners) > most);
  const std::size_t cells = topology.back().items;
  VtuArray positions = data.points;
  positions.name = "Points";
  const std::span<const VtuArray> position(&positions, 1);

  shared_detail::replace_file(path.string(), [&](std::ostream& out) {
    std::uint64_t offset = 0;
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
        << shared_detail::vtk_byte_order()
        << "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << points
        << "\" NumberOfCells=\"" << cells << "\">\n";
    shared_detail::declare_vtu_arrays(out, "Points", position, offset);
    shared_detail::declare_vtu_arrays(out, "Cells", topology, offset);
    shared_detail::declare_vtu_arrays(out, "PointData", data.point_data, offset);
    shared_detail::declare_vtu_arrays(out, "CellData", data.cell_data, offset);
    out << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    shared_detail::append_vtu_arrays(out, position);
    shared_detail::append_vtu_arrays(out, topology);
    shared_detail::append_vtu_arrays(out, data.point_data);
    shared_detail::append_vtu_arrays(out, data.cell_data);
    out << "\n</AppendedData>\n</VTKFile>\n";
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
