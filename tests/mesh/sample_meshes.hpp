// Meshes for the tests: boxes of jittered triangles or tetrahedra with cells cut out, in shuffled order and
// turned either way.
#pragma once

#include <algorithm>
#include <arenite/mesh/mesh.hpp>
#include <functional>
#include <map>
#include <numeric>
#include <random>

namespace arenite::test {

template <int D>
struct BoxMesh {
  std::array<int, D> cells;                       ///< boxes along each axis
  Vec<double, D> lower = Vec<double, D>::Zero();  ///< m
  Vec<double, D> upper = Vec<double, D>::Ones();  ///< m
  double jitter = 0.2;                            ///< of inner nodes, in box edges
  std::function<bool(const Vec<double, D>&)> keep = [](const auto&) {
    return true;
  };                                                                                 ///< of a box, by centre
  std::function<int(const Vec<double, D>&)> region = [](const auto&) { return 0; };  ///< of a box, by centre
  unsigned seed = 1;
};

/// Each box is cut along its diagonal into D! simplices (Kuhn 1960). Nodes that touch a box that is not kept,
/// another region or the hull stay where they are.
template <int D>
MeshData<D> box_mesh(const BoxMesh<D>& o) {
  std::mt19937 random(o.seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  MeshData<D> data;
  std::map<std::array<int, D>, Index> number;
  Vec<double, D> edge;
  int total = 1;
  for (int k = 0; k < D; ++k) {
    edge[k] = (o.upper[k] - o.lower[k]) / o.cells[static_cast<std::size_t>(k)];
    total *= o.cells[static_cast<std::size_t>(k)];
  }
  std::map<Index, std::vector<int>> regions_at;
  const auto node = [&](const std::array<int, D>& at) {
    const auto [found, added] = number.emplace(at, static_cast<Index>(data.nodes.size()));
    if (added) {
      Vec<double, D> x = o.lower;
      for (std::size_t k = 0; k < D; ++k)
        x[static_cast<int>(k)] = at[k] == o.cells[k]
                                     ? o.upper[static_cast<int>(k)]
                                     : x[static_cast<int>(k)] + edge[static_cast<int>(k)] * at[k];
      data.nodes.push_back(x);
    }
    return found->second;
  };
  for (int b = 0; b < total; ++b) {
    std::array<int, D> corner{};
    Vec<double, D> centre;
    for (std::size_t k = 0, rest = static_cast<std::size_t>(b); k < D; ++k) {
      corner[k] = static_cast<int>(rest) % o.cells[k];
      rest /= static_cast<std::size_t>(o.cells[k]);
      centre[static_cast<int>(k)] =
          o.lower[static_cast<int>(k)] + edge[static_cast<int>(k)] * (corner[k] + 0.5);
    }
    if (!o.keep(centre)) continue;
    const int region = o.region(centre);
    for (int c = 0; c < (1 << D); ++c) {
      auto at = corner;
      for (std::size_t k = 0; k < D; ++k) at[k] += (c >> k) & 1;
      regions_at[node(at)].push_back(region);
    }
    std::array<std::size_t, D> axes;
    std::iota(axes.begin(), axes.end(), std::size_t{0});
    do {
      std::array<Index, D + 1> cell;
      auto at = corner;
      cell[0] = node(at);
      for (std::size_t k = 0; k < D; ++k) {
        ++at[axes[k]];
        cell[k + 1] = node(at);
      }
      std::shuffle(cell.begin(), cell.end(), random);
      data.cells.push_back(cell);
      data.region.push_back(region);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  for (const auto& entry : regions_at) {
    const std::vector<int>& regions = entry.second;
    const bool inner = regions.size() == (1u << D) &&
                       std::all_of(regions.begin(), regions.end(), [&](int r) { return r == regions[0]; });
    if (!inner) continue;
    for (int k = 0; k < D; ++k) data.nodes[entry.first][k] += o.jitter * edge[k] * uniform(random);
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
  BoxMesh<D> o{};
  o.cells.fill(n);
  o.jitter = jitter;
  return SimplexMesh<D, T>(box_mesh(o));
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
