// Fuzz target: any bytes as a Gmsh file, plane or solid by the first byte. The reader throws `error` or
// returns a mesh whose indices are right; what it returns goes into a SimplexMesh, which may refuse it.
#include <arenite/io/gmsh.hpp>
#include <arenite/mesh/simplex_mesh.hpp>

#include "must.hpp"

using namespace arenite;

namespace {

template <int D>
void read(std::string_view bytes) {
  try {
    const MeshData<D> data = shared_detail::read_gmsh_bytes<D>(bytes, "bytes");
    must(!data.cells.empty() && data.region.size() == data.cells.size());
    for (const auto& cell : data.cells)
      for (const Index i : cell) must(i < data.nodes.size());
    for (const auto& [name, nodes] : data.node_sets)
      for (const Index i : nodes) must(i < data.nodes.size());
    const SimplexMesh<D> mesh(data);
    must(mesh.cell_count() == data.cells.size());
  } catch (const error& e) {
    must(std::string_view(e.what()).find(": ") != std::string_view::npos);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view file(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  bytes[0] % 2 == 0 ? read<2>(file) : read<3>(file);
  return 0;
}
