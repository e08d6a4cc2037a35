// STL files in: triangles of a closed surface, text and binary.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite/geometry/triangle_data.hpp>
#include <arenite/io/mesh_input.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace shared_detail {

/// Corners as a file gives them, three a triangle.
using StlCorners = std::vector<Vec<double, 3>>;

/// Bytes of a binary file with as many triangles as its bytes 80 to 83 say.
inline std::uint64_t stl_binary_size(std::string_view bytes) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < 4; ++k)
    count |= std::uint64_t{static_cast<unsigned char>(bytes[80 + k])} << 8 * k;
  return 84 + 50 * count;
}

/// Whether a file is text: it has not the length of a binary one, and no byte at its start that text does not
/// have. (Many a binary file begins with "solid", and a text with a blank line or a byte-order mark.)
inline bool is_stl_text(std::string_view bytes) {
  const auto in_text = [](char c) { return (c >= '\t' && c <= '\r') || c >= ' ' || c < 0; };
  return !bytes.empty() && (bytes.size() < 84 || bytes.size() != stl_binary_size(bytes)) &&
         std::ranges::all_of(bytes.substr(0, 512), in_text);
}

/// 80 bytes, the number of triangles, then for each of them twelve floats (the normal, which the order of the
/// corners gives too, and the corners) and two bytes; all numbers little-endian.
inline StlCorners read_stl_binary(MeshInput& in, std::size_t size) {
  in.set_binary(4);
  const auto number = [&](std::string_view name) {
    const auto bytes = in.raw<std::array<unsigned char, 4>>(name);
    return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
           std::uint32_t{bytes[3]} << 24;
  };
  in.raw<std::array<char, 80>>("head");
  const std::uint32_t count = number("number of triangles");
  const std::uint64_t expected = 84 + std::uint64_t{50} * count;
  in.check(size == expected, "number of triangles", count,
           joined_text({"such a file is ", expected, " bytes long; this one has ", size}));
  StlCorners corners;
  corners.reserve(std::size_t{3} * count);
  for (std::uint32_t t = 0; t < count; ++t) {
    in.raw<std::array<char, 12>>("normal");
    for (int k = 0; k < 3; ++k) {
      Vec<double, 3> x;
      for (int d = 0; d < 3; ++d) {
        x[d] = static_cast<double>(std::bit_cast<float>(number("vertex")));
        in.check(std::isfinite(x[d]), "vertex", x[d], "must be finite");
      }
      corners.push_back(x);
    }
    in.raw<std::array<char, 2>>("attribute");
  }
  return corners;
}

/// Solids one after the other: `solid name`, facets, `endsolid name`. Keywords in small or capital letters.
inline StlCorners read_stl_text(MeshInput& in) {
  const auto next = [&] {
    std::string word(in.word());
    for (char& c : word)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return word;
  };
  const auto refuse = [&](std::string_view word, std::string_view rule) {
    in.fail("word", word.empty() ? "the end of the file" : MeshInput::quote(word), rule);
  };
  const auto expect = [&](std::string_view keyword) {
    if (const std::string word = next(); word != keyword) refuse(word, joined_text({"must be ", keyword}));
  };
  StlCorners corners;
  for (std::string word = next(); !word.empty(); word = next()) {
    if (word != "solid") refuse(word, "must be solid");
    in.rest_of_line();  // the name
    for (word = next(); word == "facet"; word = next()) {
      expect("normal");
      for (int d = 0; d < 3; ++d) in.word();  // the order of the corners gives it too
      expect("outer");
      expect("loop");
      for (int k = 0; k < 3; ++k) {
        expect("vertex");
        Vec<double, 3> x;
        for (int d = 0; d < 3; ++d) {
          x[d] = in.text<double>("vertex");
          in.check(std::isfinite(x[d]), "vertex", x[d], "must be finite");
        }
        corners.push_back(x);
      }
      expect("endloop");
      expect("endfacet");
    }
    if (word != "endsolid") refuse(word, "must be facet or endsolid");
    in.rest_of_line();
  }
  return corners;
}

/// Triangles whose corners are one vertex where they are the same three numbers; vertices in the order in
/// which they come first. A triangle two of whose corners are one is left out: its neighbours touch there.
inline TriangleData merge_corners(const StlCorners& corners, double scale) {
  std::vector<Index> order(corners.size()), vertex(corners.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto before = [&](Index a, Index b) {
    for (int d = 0; d < 3; ++d)
      if (corners[a][d] != corners[b][d]) return corners[a][d] < corners[b][d];
    return a < b;
  };
  std::ranges::sort(order, before);
  for (std::size_t i = 0; i < order.size(); ++i)
    vertex[order[i]] = i > 0 && corners[order[i]] == corners[order[i - 1]] ? vertex[order[i - 1]] : order[i];
  TriangleData data;
  for (std::size_t i = 0; i < corners.size(); ++i) {  // the first of equal corners comes before the others
    if (vertex[i] == i) {
      vertex[i] = static_cast<Index>(data.vertices.size());
      data.vertices.push_back(scale * corners[i]);
    } else {
      vertex[i] = vertex[vertex[i]];
    }
  }
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    if (vertex[i] != vertex[i + 1] && vertex[i + 1] != vertex[i + 2] && vertex[i + 2] != vertex[i])
      data.triangles.push_back({vertex[i], vertex[i + 1], vertex[i + 2]});
  return data;
}

inline TriangleData read_stl_bytes(std::string_view bytes, std::string name, double scale) {
  require(scale > 0 && std::isfinite(scale), "read_stl: scale", scale, "must be positive");
  constexpr std::string_view utf_8 = "\xef\xbb\xbf";  // its byte-order mark
  if (bytes.starts_with(utf_8)) bytes.remove_prefix(utf_8.size());
  MeshInput in(bytes, std::move(name));
  if (bytes.size() / 4 >= none) in.refuse("bytes", bytes.size(), "the file must be smaller than 16 GB");
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
    in.refuse("encoding", "UTF-16", "a text file must be ASCII or UTF-8");
  const StlCorners corners = is_stl_text(bytes) ? read_stl_text(in) : read_stl_binary(in, bytes.size());
  if (corners.empty()) in.refuse("triangles", 0, "the file holds none");
  return merge_corners(corners, scale);
}

}  // namespace shared_detail

/// Reads the triangles of an STL file, text or binary, for a `TriangleSurface`. `scale`: metres in a unit of
/// the file, 1e-3 if it is in millimetres. Corners with the same coordinates are one vertex, the normals of
/// the file are not used, and all solids of a text file are read.
///
/// Throws `error` that names file, line or byte, value and rule: unreadable or truncated file, a number of
/// triangles that is not that of the file's length, coordinates that are not finite, no triangles.
inline TriangleData read_stl(std::istream& in, std::string name = "STL stream", double scale = 1) {
  const std::string bytes = shared_detail::read_all(in, name);
  return shared_detail::read_stl_bytes(bytes, std::move(name), scale);
}

/// Reads an STL file.
inline TriangleData read_stl(const std::filesystem::path& path, double scale = 1) {
  return shared_detail::read_stl_bytes(shared_detail::read_all(path), path.string(), scale);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
