// Gmsh meshes in: formats 2.2 and 4.1, text and binary.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <filesystem>
#include <istream>
#include <set>
#include <string>
#include <string_view>

#include <arenite/core/instruction_set.hpp>
#include <arenite/core/map.hpp>
#include <arenite/io/gmsh_v2.hpp>
#include <arenite/io/gmsh_v4.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace shared_detail {

enum class GmshFormat { v2_2, v4_1 };

/// $MeshFormat: version, 0 (text) or 1 (binary), size in bytes of a number; a binary file adds the int 1.
inline GmshFormat read_gmsh_format(MeshInput& in) {
  const double version = in.text<double>("version");
  in.check(version == 2.2 || version == 4.1, "version", version,
           "must be 2.2 or 4.1 (Gmsh: Mesh.MshFileVersion = 4.1)");
  const int binary = in.text<int>("file type");
  in.check(binary == 0 || binary == 1, "file type", binary, "must be 0 (text) or 1 (binary)");
  const int bytes = in.text<int>("data size");
  in.check(bytes == 8 || (bytes == 4 && version == 4.1), "data size", bytes,
           version == 4.1 ? "must be 4 or 8, the bytes of a size_t" : "must be 8, the bytes of a double");
  in.end_line("data size");
  if (binary == 1) {
    in.set_binary(static_cast<std::size_t>(bytes));
    const auto one = in.raw<std::int32_t>("byte-order mark");
    in.check(one == 1, "byte-order mark", one,
             one == 0x01000000
                 ? "must be 1: the file has the other byte order than this machine (big-endian?)"
                 : "must be 1");
  }
  return version == 2.2 ? GmshFormat::v2_2 : GmshFormat::v4_1;
}

/// $PhysicalNames, text in a binary file too: number, then a line `dimension tag "name"` each.
template <int D>
void read_gmsh_names(MeshInput& in, GmshMesh<D>& mesh) {
  const auto count = in.text<std::uint64_t>("number of names");
  in.end_line("number of names");
  for (std::uint64_t i = 0; i < count; ++i) {
    const int dim = in.text<int>("dimension of the group");
    const int tag = in.text<int>("tag of the group");
    const std::string_view name = in.rest_of_line();
    in.check(name.size() > 2 && name.front() == '"' && name.back() == '"', "name", MeshInput::quote(name),
             "must stand between double quotes");
    mesh.name_group(in, dim, tag, std::string(name.substr(1, name.size() - 2)));
  }
}

template <int D>
MeshData<D> read_gmsh_bytes(std::string_view bytes, std::string name) {
  MeshInput in(bytes, std::move(name));
  GmshMesh<D> mesh;
  GmshEntities entities;
  GmshFormat format{};
  std::set<std::string, MapOrder> seen;
  while (true) {
    const std::string section = in.open_section();
    if (section.empty()) break;
    const auto must_follow = [&](std::string_view other) {
      in.check(seen.contains(other), "section", joined_text({"$", section}),
               joined_text({"must stand behind $", other}));
    };
    if (section != "MeshFormat" && section != "Comments") must_follow("MeshFormat");
    const bool v4 = format == GmshFormat::v4_1;
    in.check(section != "ParametricNodes", "section", "$ParametricNodes",
             "nodes with parameters are not read (Gmsh: Mesh.SaveParametric = 0)");
    const bool known = section == "MeshFormat" || section == "PhysicalNames" || section == "Nodes" ||
                       section == "Elements" ||
                       (v4 && (section == "Entities" || section == "PartitionedEntities"));
    if (!known) {
      in.skip_section();  // as the manual asks: comments, post-processing data, what others have added
      continue;
    }
    in.check(seen.insert(section).second, "section", joined_text({"$", section}), "is given twice");
    if (section == "MeshFormat") {
      format = read_gmsh_format(in);
    } else if (section == "PhysicalNames") {
      read_gmsh_names(in, mesh);
    } else if (section == "PartitionedEntities") {
      in.fail("section", joined_text({"$", section}),
              "partitioned meshes are not read (Gmsh: Mesh.NbPartitions = 0)");
    } else if (section == "Entities") {
      in.check(!seen.contains("Elements"), "section", joined_text({"$", section}),
               "must stand before $Elements");
      entities = read_v4_entities(in);
    } else if (section == "Nodes") {
      v4 ? read_v4_nodes(in, mesh) : read_v2_nodes(in, mesh);
      mesh.end_nodes(in);
    } else {
      must_follow("Nodes");
      v4 ? read_v4_elements(in, mesh, entities) : read_v2_elements(in, mesh);
    }
    in.close_section();
  }
  for (const char* needed : {"MeshFormat", "Nodes", "Elements"})
    if (!seen.contains(needed)) in.refuse("section", joined_text({"$", needed}), "is missing");
  return std::move(mesh).finish(in);
}

}  // namespace shared_detail

/// Reads a Gmsh mesh of triangles (D = 2) or tetrahedra (D = 3) from format 2.2 or 4.1, text or binary.
///
/// - `nodes` are those that a cell uses, in ascending order of their Gmsh tags (which may have gaps); other
///   nodes are dropped. A plane mesh must lie in a plane of constant z.
/// - `cells` stand in the order of the file. Lines, points (and faces, for D = 3) only make node sets.
/// - `region` is the physical tag of each cell's surface (D = 2) or volume (D = 3), 0 without one;
///   `region_names` are the names of the physical groups of dimension D. Cells in several of them have a
///   negative region, one for each such set of groups, which `shared_regions` gives to the names of all.
/// - `node_sets` are the nodes of the physical groups of lower dimension, under the group's name or, without
///   one, under "dimension:tag" as in "1:7". Groups that share a name share a set; nodes that no cell uses
///   are left out, and a set without nodes too.
///
/// Sections that the format does not define, and post-processing data, are skipped. Partitions are not read.
///
/// Throws `error` that names file, section, line or byte, value and rule: unreadable, truncated or
/// inconsistent file, other version or byte order, cells that are not simplices of first order, cells that
/// are given twice, parametric nodes, unknown node tags, coordinates that are not finite, no cells.
///
/// Format: Gmsh reference manual, "MSH file format" and "MSH file format version 2 (Legacy)", gmsh.info.
template <int D>
MeshData<D> read_gmsh(std::istream& in, std::string name = "Gmsh stream") {
  static_assert(D == 2 || D == 3, "read_gmsh<D>: D must be 2 (triangles) or 3 (tetrahedra)");
  const std::string bytes = shared_detail::read_all(in, name);
  return shared_detail::read_gmsh_bytes<D>(bytes, std::move(name));
}

/// Reads a Gmsh mesh from a file.
template <int D>
MeshData<D> read_gmsh(const std::filesystem::path& path) {
  static_assert(D == 2 || D == 3, "read_gmsh<D>: D must be 2 (triangles) or 3 (tetrahedra)");
  return shared_detail::read_gmsh_bytes<D>(shared_detail::read_all(path), path.string());
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
