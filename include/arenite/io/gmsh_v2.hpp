// Sections $Nodes and $Elements of Gmsh's format 2.2 (reference manual, "MSH file format version 2
// (Legacy)").
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <span>

#include <arenite/core/instruction_set.hpp>
#include <arenite/io/gmsh_mesh.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

template <int D>
void read_v2_nodes(MeshInput& in, GmshMesh<D>& mesh) {
  const auto count = in.text<std::uint64_t>("number of nodes");
  in.end_line("number of nodes");
  in.check_count("number of nodes", count, in.binary() ? 28 : 8);
  mesh.reserve_nodes(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const int tag = in.integer("tag of the node");
    in.check(tag >= 1, "tag of the node", tag, "must be at least 1");
    mesh.add_tag(in, static_cast<std::uint64_t>(tag));
    mesh.read_position(in);
  }
}

/// One element: its tags, of which the first is the physical group, and its nodes.
template <int D>
void read_v2_element(MeshInput& in, GmshMesh<D>& mesh, const GmshKind& kind, int tags) {
  int group = 0;
  for (int t = 0; t < tags; ++t) {
    const int tag = in.integer("tag of the element");
    if (t == 0) group = tag;
  }
  typename GmshMesh<D>::Nodes nodes{};
  for (std::size_t k = 0; k < kind.nodes; ++k) {
    const int tag = in.integer("node of the element");
    in.check(tag >= 1, "node of the element", tag, "must be at least 1");
    nodes[k] = mesh.node(in, static_cast<std::uint64_t>(tag));
  }
  mesh.add_element(in, kind, std::span(&group, 1), nodes);
  in.end_row("element");
}

template <int D>
void read_v2_elements(MeshInput& in, GmshMesh<D>& mesh) {
  const auto count = in.text<std::uint64_t>("number of elements");
  in.end_line("number of elements");
  in.check_count("number of elements", count, 8);
  mesh.reserve_cells(count);
  mesh.repeat_elements();
  // Text: one element a line, as number, type, number of tags. Binary: runs of one type, whose header is
  // type, length of the run, number of tags; then each element begins with its number.
  for (std::uint64_t left = count; left > 0;) {
    if (!in.binary()) in.integer("number of the element");
    const GmshKind& kind = mesh.kind(in, in.integer("type of element"));
    const int run = in.binary() ? in.integer("elements that follow") : 1;
    if (run < 1 || static_cast<std::uint64_t>(run) > left)
      in.fail("elements that follow", run,
              joined_text({"must be from 1 to ", left, ", what is left of the number of elements"}));
    const int tags = in.integer("number of tags");
    in.check(tags >= 0, "number of tags", tags, "must not be negative");
    for (int i = 0; i < run; ++i) {
      if (in.binary()) in.integer("number of the element");
      read_v2_element(in, mesh, kind, tags);
    }
    left -= static_cast<std::uint64_t>(run);
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
