// Meshes for the tests: boxes of jittered triangles or tetrahedra with cells cut out, in shuffled order and
// turned either way.
#pragma once

#include <algorithm>
#include <arenite/mesh/box_mesh.hpp>
#include <arenite/mesh/mesh.hpp>
#include <functional>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace arenite::test {

template <int D>
struct SampleMesh {
  std::array<int, D> cells;                       ///< bricks along each axis
  Vec<double, D> lower = Vec<double, D>::Zero();  ///< m
  Vec<double, D> upper = Vec<double, D>::Ones();  ///< m
  double jitter = 0.2;                            ///< of inner nodes, in brick edges
  std::function<bool(const Vec<double, D>&)> keep = [](const auto&) {
    return true;
  };  ///< of a brick, by centre
  std::function<int(const Vec<double, D>&)> region = [](const auto&) {
    return 0;
  };  ///< of a brick, by centre
  unsigned seed = 1;
};

/// Nodes that touch a brick that is not kept, another region or the hull stay where they are.
template <int D>
MeshData<D> sample_data(const SampleMesh<D>& o) {
  constexpr std::size_t simplices = D == 2 ? 2 : 6;  // of a brick
  std::mt19937 random(o.seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  BoxMesh<D> box;
  for (std::size_t k = 0; k < D; ++k) {
    box.lower[k] = o.lower[static_cast<int>(k)];
    box.upper[k] = o.upper[static_cast<int>(k)];
    box.bricks[k] = static_cast<Index>(o.cells[k]);
  }
  const MeshData<D> whole = box_mesh(box);

  MeshData<D> data;
  std::vector<Index> number(whole.nodes.size(), none);           // of a node that is kept
  std::vector<std::vector<int>> regions_at(whole.nodes.size());  // of the bricks at each node
  for (std::size_t first = 0; first < whole.cells.size(); first += simplices) {
    std::set<Index> corners;
    for (std::size_t c = first; c < first + simplices; ++c)
      corners.insert(whole.cells[c].begin(), whole.cells[c].end());
    Vec<double, D> centre = Vec<double, D>::Zero();
    for (const Index i : corners) centre += whole.nodes[i] / static_cast<double>(corners.size());
    if (!o.keep(centre)) continue;
    const int region = o.region(centre);
    for (const Index i : corners) {
      if (number[i] == none) {
        number[i] = static_cast<Index>(data.nodes.size());
        data.nodes.push_back(whole.nodes[i]);
      }
      regions_at[number[i]].push_back(region);
    }
    for (std::size_t c = first; c < first + simplices; ++c) {
      auto cell = whole.cells[c];
      for (Index& i : cell) i = number[i];
      std::shuffle(cell.begin(), cell.end(), random);  // turned either way
      data.cells.push_back(cell);
      data.region.push_back(region);
    }
  }
  for (Index i = 0; i < data.nodes.size(); ++i) {
    const std::vector<int>& regions = regions_at[i];
    const bool inner = regions.size() == (1u << D) &&
                       std::all_of(regions.begin(), regions.end(), [&](int r) { return r == regions[0]; });
    if (!inner) continue;
    for (int k = 0; k < D; ++k)
      data.nodes[i][k] +=
          o.jitter * (o.upper[k] - o.lower[k]) / o.cells[static_cast<std::size_t>(k)] * uniform(random);
  }
  // Cells in random order: neighbours in space are none in number.
  std::vector<std::size_t> order(data.cells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  MeshData<D> shuffled = data;
  for (std::size_t k = 0; k < order.size(); ++k) {
    shuffled.cells[k] = data.cells[order[k]];
    shuffled.region[k] = data.region[order[k]];
  }
  return shuffled;
}

template <int D, real_scalar T = double>
SimplexMesh<D, T> sample_mesh(int n, double jitter = 0.2) {
  SampleMesh<D> o{};
  o.cells.fill(n);
  o.jitter = jitter;
  return SimplexMesh<D, T>(sample_data(o));
}

/// A random position in a cell of either kind of mesh.
template <class M>
typename M::Point random_point(const M& mesh, Index cell, std::mt19937& random) {
  using T = typename M::scalar;
  std::uniform_real_distribution<T> uniform(T(0.001), T(0.999));
  typename M::Point x = M::Point::Zero();
  if constexpr (is_simplex_mesh<M>) {
    std::array<T, M::dimension + 1> b;
    T sum = 0;
    for (T& value : b) sum += value = -std::log(uniform(random));
    for (std::size_t k = 0; k < b.size(); ++k) x += b[k] / sum * mesh.position(mesh.nodes(cell)[k]);
  } else {
    for (int k = 0; k < M::dimension; ++k) x[k] = mesh.corner(cell)[k] + mesh.edge() * uniform(random);
  }
  return x;
}

/// Whether `f` throws `E` with this text in its message.
template <class E = error, class F>
bool throws(F&& f, const std::string& text) {
  try {
    f();
  } catch (const E& e) {
    return std::string(e.what()).find(text) != std::string::npos;
  }
  return false;
}

}  // namespace arenite::test
