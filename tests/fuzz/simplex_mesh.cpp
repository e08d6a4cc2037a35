// Fuzz target: any bytes as the arrays of a simplex mesh. The constructor throws `error` or makes a mesh
// whose cells have a finite volume and size, whose neighbours know each other, and which finds the centres of
// its cells.
#include <arenite/mesh/simplex_mesh.hpp>
#include <cstring>

#include "must.hpp"

using namespace arenite;

namespace {

/// Reads numbers from the front of the bytes; zeros after their end.
class Bytes {
 public:
  Bytes(const std::uint8_t* at, std::size_t left) : at_{at}, left_{left} {}
  template <class N>
  N take() {
    N n{};
    const std::size_t have = std::min(sizeof(N), left_);
    if (have > 0) std::memcpy(&n, at_, have);
    at_ += have;
    left_ -= have;
    return n;
  }
  bool empty() const { return left_ == 0; }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};

/// Positions are any doubles, or (`small`) halves of small whole numbers, which make sound cells likelier.
template <int D>
MeshData<D> mesh_data(Bytes& in, bool small) {
  MeshData<D> data;
  const std::size_t nodes = in.take<std::uint8_t>() % 32u, sets = in.take<std::uint8_t>() % 3u;
  for (std::size_t i = 0; i < nodes; ++i) {
    Vec<double, D> x;
    for (int k = 0; k < D; ++k) x[k] = small ? 0.5 * in.take<std::int8_t>() : in.take<double>();
    data.nodes.push_back(x);
  }
  for (std::size_t s = 0; s < sets; ++s)
    data.node_sets[s == 0 ? "a" : "b"] = {in.take<std::uint8_t>(), in.take<std::uint8_t>()};
  while (!in.empty() && data.cells.size() < 64) {
    std::array<Index, D + 1> cell;
    for (Index& i : cell) i = in.take<std::uint8_t>();
    data.cells.push_back(cell);
  }
  return data;
}

template <int D, class T>
void make(Bytes& in, bool small) {
  const MeshData<D> data = mesh_data<D>(in, small);
  try {
    SimplexMesh<D, T> mesh(data);
    for (Index c = 0; c < mesh.cell_count(); ++c) {
      must(mesh.volume(c) > 0 && std::isfinite(mesh.volume(c)));
      must(mesh.size(c) > 0 && std::isfinite(mesh.size(c)));
      must(mesh.frame(c).inverse.allFinite());
      typename SimplexMesh<D, T>::Point centre = Vec<T, D>::Zero();
      for (const Index i : mesh.nodes(c)) {
        must(i < mesh.node_count());
        centre += mesh.position(i) / T(D + 1);
      }
      for (int k = 0; k <= D; ++k)
        if (const Index other = mesh.neighbour(c, k); other != none) {
          bool mutual = false;
          for (int j = 0; j <= D; ++j) mutual = mutual || mesh.neighbour(other, j) == c;
          must(mutual);
        }
      must(mesh.walk(centre, c) == c);
      must(mesh.search(centre) != none);  // cells may lie upon each other: any of them
    }
  } catch (const error& e) {
    must(std::string_view(e.what()).find(": ") != std::string_view::npos);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const bool small = (bytes[0] & 4) != 0;
  Bytes in(bytes + 1, size - 1);
  switch (bytes[0] % 4) {
    case 0:
      make<2, double>(in, small);
      break;
    case 1:
      make<3, double>(in, small);
      break;
    case 2:
      make<2, float>(in, small);
      break;
    default:
      make<3, float>(in, small);
  }
  return 0;
}
