// Sections $Entities, $Nodes and $Elements of Gmsh's format 4.1 (reference manual, "MSH file format").
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite/io/gmsh_mesh.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// Physical groups of each model entity, by (dimension, tag); nothing in a file without $Entities.
using GmshEntities = std::optional<Map<std::pair<int, int>, std::vector<int>>>;

inline GmshEntities read_v4_entities(MeshInput& in) {
  GmshEntities entities(std::in_place);
  std::array<std::uint64_t, 4> count{};
  for (auto& n : count) n = in.size("number of entities");
  in.end_row("number of entities");
  for (int dim = 0; dim <= 3; ++dim) {
    for (std::uint64_t i = 0; i < count[static_cast<std::size_t>(dim)]; ++i) {
      const int tag = in.integer("tag of the entity");
      auto [entity, is_new] = entities->try_emplace({dim, tag});
      in.check(is_new, "tag of the entity", tag, joined_text({"is given twice in dimension ", dim}));
      for (int k = 0; k < (dim == 0 ? 3 : 6); ++k) in.real("bounding box");
      const std::uint64_t groups = in.size("number of physical groups");
      in.check_count("number of physical groups", groups, in.binary() ? sizeof(std::int32_t) : 2);
      for (std::uint64_t k = 0; k < groups; ++k) entity->second.push_back(in.integer("physical group"));
      if (dim == 0) continue;
      const std::uint64_t boundary = in.size("number of bounding entities");
      for (std::uint64_t k = 0; k < boundary; ++k) in.integer("bounding entity");
    }
  }
  return entities;
}

/// Header of $Nodes and of $Elements.
struct GmshBlocks {
  std::uint64_t blocks = 0;
  std::uint64_t items = 0;
};

inline GmshBlocks read_v4_blocks(MeshInput& in, std::string_view items, std::size_t least_bytes) {
  GmshBlocks header;
  header.blocks = in.size("number of blocks");
  header.items = in.size(items);
  in.check_count(items, header.items, least_bytes);
  in.size("lowest tag");
  in.size("highest tag");
  in.end_row("header");
  return header;
}

/// Number of items of a block, of which `left` are left in the section.
inline std::uint64_t read_v4_block_size(MeshInput& in, std::uint64_t left) {
  const std::uint64_t count = in.size("items of the block");
  in.check(count <= left, "items of the block", count,
           joined_text({"must be at most ", left, ", what is left of the section"}));
  in.end_row("header of the block");
  return count;
}

template <int D>
void read_v4_nodes(MeshInput& in, GmshMesh<D>& mesh) {
  const auto header = read_v4_blocks(in, "number of nodes", in.size_bytes() + (in.binary() ? 24 : 6));
  mesh.reserve_nodes(header.items);
  std::uint64_t left = header.items;
  for (std::uint64_t block = 0; block < header.blocks; ++block) {
    in.integer("dimension of the entity");
    in.integer("tag of the entity");
    const int parametric = in.integer("parametric");
    in.check(parametric == 0, "parametric", parametric, "must be 0 (Gmsh: Mesh.SaveParametric = 0)");
    const std::uint64_t count = read_v4_block_size(in, left);
    for (std::uint64_t i = 0; i < count; ++i) mesh.add_tag(in, in.size("tag of the node"));
    if (count > 0) in.end_row("tag of the node");
    for (std::uint64_t i = 0; i < count; ++i) mesh.read_position(in);
    left -= count;
  }
  in.check(left == 0, "number of nodes", header.items,
           joined_text({"is ", left, " more than the blocks hold"}));
}

template <int D>
void read_v4_elements(MeshInput& in, GmshMesh<D>& mesh, const GmshEntities& entities) {
  const auto header = read_v4_blocks(in, "number of elements", 2 * in.size_bytes());
  mesh.reserve_cells(header.items);
  const std::vector<int> no_groups;
  std::uint64_t left = header.items;
  for (std::uint64_t block = 0; block < header.blocks; ++block) {
    const int dim = in.integer("dimension of the entity");
    const int entity = in.integer("tag of the entity");
    std::span<const int> groups = no_groups;
    if (entities) {
      const auto found = entities->find({dim, entity});
      in.check(found != entities->end(), "tag of the entity", entity,
               joined_text({"is not among $Entities of dimension ", dim}));
      groups = found->second;
    }
    const GmshKind& kind = mesh.kind(in, in.integer("type of element"));
    in.check(static_cast<int>(kind.dim) == dim, "type of element", kind.name,
             joined_text({"must have the dimension of its entity, ", dim}));
    const std::uint64_t count = read_v4_block_size(in, left);
    for (std::uint64_t i = 0; i < count; ++i) {
      in.size("tag of the element");
      typename GmshMesh<D>::Nodes nodes{};
      for (std::size_t k = 0; k < kind.nodes; ++k) nodes[k] = mesh.node(in, in.size("node of the element"));
      mesh.add_element(in, kind, groups, nodes);
      in.end_row("element");
    }
    left -= count;
  }
  in.check(left == 0, "number of elements", header.items,
           joined_text({"is ", left, " more than the blocks hold"}));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
