// Simplex mesh: triangles (D = 2) or tetrahedra (D = 3), unstructured and graded, with the barycentric frame
// of each cell, its neighbours and a point search that walks from cell to cell.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/map.hpp>
#include <arenite/mesh/adjacency.hpp>
#include <arenite/mesh/cell_bins.hpp>
#include <arenite/mesh/cell_size.hpp>
#include <arenite/mesh/mesh_data.hpp>
#include <arenite/parallel/parallel.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Triangles or tetrahedra over scalar T. Node positions may change (`move`); the topology does not.
template <int D, real_scalar T = double>
class SimplexMesh {
 public:
  static constexpr int dimension = D;
  using scalar = T;
  using Point = Vec<T, D>;
  using CellNodes = std::array<Index, static_cast<std::size_t>(D + 1)>;

  /// Affine frame of a cell: barycentric coordinate k + 1 of x is row k of `inverse` times (x - origin of
  /// the cell). A translation of the cell does not change it.
  struct Frame {
    Mat<T, D> inverse;  ///< rows: gradients of the shape functions of nodes 1 .. D, 1/m
    T volume;           ///< area (D = 2) or volume (D = 3), m^D
    T size;             ///< smallest altitude, m
  };

  /// Throws `error` if a cell has a wrong node number, no volume or a size that T does not allow, or if a
  /// face belongs to more than two cells.
  explicit SimplexMesh(const MeshData<D>& data)
      : region_names_{data.region_names},
        shared_regions_{data.shared_regions},
        node_sets_{data.node_sets},
        region_{data.region} {
    require(!data.cells.empty(), "SimplexMesh.cells", data.cells.size(), "a mesh needs at least one cell");
    if (region_.empty()) region_.assign(data.cells.size(), 0);
    require(region_.size() == data.cells.size(), "SimplexMesh.region", region_.size(),
            "must have one entry a cell");
    position_.reserve(data.nodes.size());
    for (const auto& x : data.nodes) {
      require((x.array().abs() <= static_cast<double>(std::numeric_limits<T>::max())).all(),
              "SimplexMesh.nodes", vector_text(x), "positions must be finite in the scalar of the mesh");
      position_.push_back(x.template cast<T>());
    }
    cells_.reserve(data.cells.size());
    for (std::size_t c = 0; c < data.cells.size(); ++c) add_cell(c, data.cells[c]);
    for (const auto& [name, nodes] : node_sets_)
      for (const Index i : nodes)
        require(i < node_count(), {"SimplexMesh.node_sets[", name, "]"}, i, "must be a node of the mesh");
    frames_.resize(cells_.size());
    for (Index c = 0; c < cell_count(); ++c) refresh(c);
    neighbours_ = simplex_neighbours<D>(cells_);
    node_cells_ = cells_at_nodes(node_count(), cells_);
  }

  Index node_count() const { return static_cast<Index>(position_.size()); }
  Index cell_count() const { return static_cast<Index>(cells_.size()); }
  const Point& position(Index node) const { return position_[node]; }
  const std::vector<Point>& positions() const { return position_; }
  const CellNodes& nodes(Index cell) const { return cells_[cell]; }
  const Frame& frame(Index cell) const { return frames_[cell]; }
  /// Position of node 0 of a cell, m.
  const Point& origin(Index cell) const { return position_[cells_[cell][0]]; }
  /// Area or volume of a cell, m^D.
  T volume(Index cell) const { return frames_[cell].volume; }
  int region(Index cell) const { return region_[cell]; }
  /// Neighbour across the face opposite to local node k, or `none` on the hull.
  Index neighbour(Index cell, int k) const { return neighbours_[cell][static_cast<std::size_t>(k)]; }
  std::span<const Index> cells_at(Index node) const { return node_cells_[node]; }

  /// Numbers of a named region: several where it shares cells with others. Throws `error` naming those that
  /// exist.
  std::vector<int> region_numbers(const std::string& name) const {
    std::vector<int> numbers{find(region_names_, name, "region")};
    if (const auto shared = shared_regions_.find(name); shared != shared_regions_.end())
      for (const int number : shared->second) numbers.push_back(number);
    return numbers;
  }
  /// Number of a named region. Throws `error` also if it has several.
  int region_number(const std::string& name) const {
    const auto numbers = region_numbers(name);
    require(numbers.size() == 1, "SimplexMesh: region", name,
            "shares cells with another: see region_numbers");
    return numbers.front();
  }
  /// Whether a cell is of one of these regions.
  bool is_in(Index cell, const std::vector<int>& regions) const {
    return std::ranges::find(regions, region(cell)) != regions.end();
  }
  /// Nodes of a named set, ascending. Throws `error` naming those that exist.
  const std::vector<Index>& node_set(const std::string& name) const {
    return find(node_sets_, name, "node set");
  }
  bool has_node_set(const std::string& name) const { return node_sets_.contains(name); }

  /// Smallest altitude of a cell, m: 1 / the largest gradient of its shape functions.
  T size(Index cell) const { return frames_[cell].size; }

  /// Smallest size of the cells at a node, m.
  T node_size(Index node) const {
    T smallest = std::numeric_limits<T>::infinity();
    for (const Index c : cells_at(node)) smallest = std::min(smallest, size(c));
    return smallest;
  }

  /// Barycentric coordinates of x in a cell; negative ones lie outside.
  Vec<T, D + 1> barycentric(Index cell, const Point& x) const {
    Vec<T, D + 1> b;
    b.template tail<D>().noalias() = frames_[cell].inverse * (x - origin(cell));
    b[0] = 1 - b.template tail<D>().sum();
    return b;
  }

  /// Test for one cell, made once for many positions.
  struct Holder {
    Mat<T, D> inverse;
    Point origin;
    /// Whether positions lie in the cell, its faces included; `P`: T, or a pack of positions.
    template <class P>
    auto holds(const std::array<P, static_cast<std::size_t>(D)>& x) const {
      std::array<P, static_cast<std::size_t>(D)> b;
      P sum(0);
      for (int k = 0; k < D; ++k) {
        P value(0);
        for (int d = 0; d < D; ++d)
          value += P(inverse(k, d)) * (x[static_cast<std::size_t>(d)] - P(origin[d]));
        b[static_cast<std::size_t>(k)] = value;
        sum += value;
      }
      auto inside = sum <= P(1 + tolerance);
      for (const P& value : b) inside = inside && value >= P(-tolerance);
      return inside;
    }
  };
  Holder holder(Index cell) const { return {frames_[cell].inverse, origin(cell)}; }

  /// The cell that contains x, found by walking from `hint`, or `none` where the walk ends: at the hull, or
  /// after `max_walk` cells. A point on a face stays in the first cell found. Costs one test for a point that
  /// stayed.
  Index walk(const Point& x, Index hint) const {
    for (int step = 0; step < max_walk && hint != none; ++step) {
      const auto b = barycentric(hint, x);
      int k;
      if (b.minCoeff(&k) >= -tolerance) return hint;
      hint = neighbour(hint, k);
    }
    return none;
  }

  /// The cell that contains x, or `none` outside of the mesh, without a hint. Correct also on non-convex
  /// meshes, where a walk may end at the hull. Not thread-safe: refreshes its bins after the mesh moved.
  Index search(const Point& x) {
    if (!x.allFinite()) return none;
    if (!bins_fresh_) {
      bins_.build(position_, cells_);
      bins_fresh_ = true;
    }
    Index found = none;
    T best = -tolerance;
    for (const Index c : bins_.at(x)) {
      const T inside = barycentric(c, x).minCoeff();
      if (inside >= best) {
        if (found == none || inside > best) found = c;
        best = std::max(best, inside);
      }
    }
    return found;
  }

  /// Moves each node i in `nodes` to `position(i)` and refreshes the cells in `cells`: every cell must be
  /// among them that has a moved node, unless all of its nodes move by the same vector. Returns the first
  /// cell that lost its volume, or `none`.
  template <class Position>
  Index move(std::span<const Index> nodes, std::span<const Index> cells, Position&& position) {
    bins_fresh_ = false;
    ++moves_;
    parallel_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) position_[nodes[k]] = position(nodes[k]);
    });
    return parallel_reduce(
        cells.size(), none,
        [&](std::size_t begin, std::size_t end) {
          Index bad = none;
          for (std::size_t k = begin; k < end; ++k)
            if (!(refresh(cells[k]) > 0) && bad == none) bad = cells[k];
          return bad;
        },
        [](Index a, Index b) { return a != none ? a : b; });
  }

  /// How often nodes were moved.
  std::size_t moves() const { return moves_; }

  /// Bytes of all arrays.
  std::size_t bytes() const {
    return position_.size() * sizeof(Point) +
           cells_.size() * (sizeof(CellNodes) * 2 + sizeof(Frame) + sizeof(int)) + node_cells_.bytes();
  }

 private:
  static constexpr T tolerance = 64 * std::numeric_limits<T>::epsilon();
  static constexpr int max_walk = 64;

  void add_cell(std::size_t c, CellNodes nodes) {
    for (const Index i : nodes)
      require(i < node_count(), {"SimplexMesh.cells[", c, "]"}, i, "must be a node of the mesh");
    const auto edges = edge_matrix(nodes);
    T longest = 0;
    for (int k = 0; k < D; ++k) {
      const T flat = std::hypot(edges(0, k), edges(1, k));
      longest = std::max(longest, D == 2 ? flat : std::hypot(flat, edges(D - 1, k)));
    }
    if (longest > 0) detail::check_edge<T>(joined_text({"SimplexMesh.cells[", c, "].edge"}), longest);
    const T volume = edges.determinant();
    require(std::abs(volume) > detail::flattest<T> * std::pow(longest, D),
            {"SimplexMesh.cells[", c, "].volume"}, volume, "a cell must not be flat");
    if (volume < 0) std::swap(nodes[D - 1], nodes[D]);
    cells_.push_back(nodes);
  }

  Mat<T, D> edge_matrix(const CellNodes& nodes) const {
    Mat<T, D> edges;
    for (int k = 0; k < D; ++k)
      edges.col(k) = position_[nodes[static_cast<std::size_t>(k + 1)]] - position_[nodes[0]];
    return edges;
  }

  /// Renews the frame of a cell and returns its volume.
  T refresh(Index c) {
    const Mat<T, D> edges = edge_matrix(cells_[c]);
    const Mat<T, D> inverse = edges.inverse();
    T steepest = inverse.colwise().sum().squaredNorm();
    for (int k = 0; k < D; ++k) steepest = std::max(steepest, inverse.row(k).squaredNorm());
    const T volume = edges.determinant() / (D == 2 ? 2 : 6);
    frames_[c] = {inverse, volume, 1 / std::sqrt(steepest)};
    return volume;
  }

  template <class Value>
  static const Value& find(const Map<std::string, Value>& map, const std::string& name, const char* kind) {
    const auto found = map.find(name);
    if (found != map.end()) return found->second;
    std::string known;
    for (const auto& [key, value] : map) known.append(known.empty() ? "" : ", ").append(key);
    throw error(joined_text({"SimplexMesh: ", kind, " = ", name, ": must be one of: ", known}));
  }

  Map<std::string, int> region_names_;
  Map<std::string, std::vector<int>> shared_regions_;
  Map<std::string, std::vector<Index>> node_sets_;
  std::vector<int> region_;
  std::vector<Point> position_;
  std::vector<CellNodes> cells_;
  std::vector<CellNodes> neighbours_;
  std::vector<Frame> frames_;
  Lists node_cells_;
  CellBins<D, T> bins_;
  bool bins_fresh_ = false;
  std::size_t moves_ = 0;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
