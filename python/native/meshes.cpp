// Meshes: see meshes.hpp. Elements that another reader has read go through the same class as those of a Gmsh
// file, so that kinds, groups, nodes without a cell and curved planes mean the same.
#include "meshes.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <arenite/io/gmsh.hpp>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace arenite::python {
namespace {

namespace py = pybind11;

template <class T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;
using Names = std::vector<std::tuple<int, int, std::string>>;     // dimension, tag and name of each group
using Groups = std::vector<std::pair<int, Array<std::int64_t>>>;  // tag, numbers of elements in a block
using Blocks = std::vector<std::tuple<std::string, Array<std::int64_t>, Groups>>;  // kind, nodes [m, k]

/// Rows of numbers, `columns` in each.
template <class To, class Rows>
py::array_t<To> rows_of(const Rows& rows, std::size_t columns) {
  py::array_t<To> all({rows.size(), columns});
  To* to = all.mutable_data();
  for (const auto& row : rows)
    for (std::size_t k = 0; k < columns; ++k) *to++ = static_cast<To>(row.data()[k]);
  return all;
}
template <class From>
py::array_t<std::int64_t> numbers_of(const std::vector<From>& from) {
  py::array_t<std::int64_t> all(static_cast<py::ssize_t>(from.size()));
  std::copy(from.begin(), from.end(), all.mutable_data());
  return all;
}

template <int D>
py::dict arrays_of(const MeshData<D>& mesh) {
  py::dict names, shared, sets, all;
  for (const auto& [name, tag] : mesh.region_names) names[py::str(name)] = tag;
  for (const auto& [name, regions] : mesh.shared_regions) shared[py::str(name)] = numbers_of(regions);
  for (const auto& [name, nodes] : mesh.node_sets) sets[py::str(name)] = numbers_of(nodes);
  all["nodes"] = rows_of<double>(mesh.nodes, D);
  all["cells"] = rows_of<std::int64_t>(mesh.cells, D + 1);
  all["region"] = numbers_of(mesh.region);
  all["region_names"] = names;
  all["shared_regions"] = shared;
  all["node_sets"] = sets;
  return all;
}

template <int D>
void add_block(const shared_detail::MeshInput& in, shared_detail::GmshMesh<D>& mesh, const std::string& word,
               const Array<std::int64_t>& nodes, const Groups& groups) {
  const auto found = std::ranges::find(shared_detail::gmsh_kinds, word, &shared_detail::GmshKind::name);
  if (found == shared_detail::gmsh_kinds.end()) in.refuse("type of element", word, "is no known type");
  const auto& kind = mesh.kind(in, found->number);
  const auto columns = static_cast<py::ssize_t>(kind.nodes);
  if (nodes.ndim() != 2 || nodes.shape(1) != columns)
    in.refuse("nodes of a block of elements", word, joined_text({"must be [m, ", columns, "]"}));
  std::vector<std::vector<int>> of(static_cast<std::size_t>(nodes.shape(0)));
  for (const auto& [tag, elements] : groups)
    for (py::ssize_t i = 0; i < elements.size(); ++i) {
      const std::int64_t element = elements.data()[i];
      if (element < 0 || element >= nodes.shape(0))
        in.refuse("element of a group", element, joined_text({"must be below ", nodes.shape(0)}));
      auto& own = of[static_cast<std::size_t>(element)];
      if (std::ranges::find(own, tag) == own.end()) own.push_back(tag);
    }
  for (std::size_t e = 0; e < of.size(); ++e) {
    typename shared_detail::GmshMesh<D>::Nodes corners{};
    for (std::size_t k = 0; k < kind.nodes; ++k)
      corners[k] = mesh.node(in, static_cast<std::uint64_t>(nodes.data()[e * kind.nodes + k] + 1));
    mesh.add_element(in, kind, of[e], corners);
  }
}

template <int D>
py::dict gather(const Array<double>& points, const Names& names, const Blocks& blocks, bool repeats) {
  const shared_detail::MeshInput in({}, "SimplexMesh.from_meshio");
  shared_detail::GmshMesh<D> mesh;
  if (repeats) mesh.repeat_elements();
  for (const auto& [dimension, tag, name] : names) mesh.name_group(in, dimension, tag, name);
  const auto columns = static_cast<std::size_t>(points.shape(1));
  for (py::ssize_t i = 0; i < points.shape(0); ++i) {
    const double* const x = points.data() + static_cast<std::size_t>(i) * columns;
    mesh.add_tag(in, static_cast<std::uint64_t>(i) + 1);
    mesh.add_position(in, [&](std::size_t k) { return k < columns ? x[k] : 0; });
  }
  mesh.end_nodes(in);
  for (const auto& [word, nodes, groups] : blocks) add_block(in, mesh, word, nodes, groups);
  return arrays_of(std::move(mesh).finish(in));
}

void check_dimension(int dimension) {
  require(dimension == 2 || dimension == 3, "dimension", dimension,
          "must be 2 (triangles) or 3 (tetrahedra)");
}

}  // namespace

void add_meshes(py::module_& m) {
  m.def("read_gmsh", [](const std::filesystem::path& path, int dimension) {
    check_dimension(dimension);
    return dimension == 2 ? arrays_of(read_gmsh<2>(path)) : arrays_of(read_gmsh<3>(path));
  });
  m.def("gather_mesh", [](int dimension, const Array<double>& points, const Names& names,
                          const Blocks& blocks, bool repeats) {
    check_dimension(dimension);
    if (points.ndim() != 2 || points.shape(1) > 3)
      throw error("SimplexMesh.from_meshio: points: must be [n, 2] or [n, 3]");
    return dimension == 2 ? gather<2>(points, names, blocks, repeats)
                          : gather<3>(points, names, blocks, repeats);
  });
}

}  // namespace arenite::python
