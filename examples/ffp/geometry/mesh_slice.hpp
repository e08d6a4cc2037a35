// The slice of the drop as tetrahedra: the half-section swept about the axis. Each node of the section
// becomes a chain of nodes on its arc, with as many pieces as the arc is long; a triangle then sweeps over
// its three chains piece by piece, one tetrahedron a piece. With equal chains that is the usual prism cut in
// three; unequal chains spare the slivers that a fixed number of layers would make near the axis, where they
// would decide the time step.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "mesh_axisymmetric.hpp"

namespace arenite::ffp {

/// The slice lies between two planes through the axis (y), at -angle/2 and +angle/2: x = r cos a, z = r sin
/// a.
struct SliceShape {
  double angle = 20 * pi / 180;  ///< rad; the paper's. The slice is angle / (2 pi) of the whole, 1/18
  double arc_ratio = 0.89;       ///< longest piece of an arc over the width of the section's cells there
  int device_pieces = 2;         ///< fewest pieces of an arc at half the device's radius and beyond
};

namespace detail {

/// Chains of the nodes of a section, and the tetrahedra between them.
class SliceMesher {
 public:
  SliceMesher(const AxisymmetricMesh& section, const Device& body, const Chamber& chamber,
              const MeshSizes& sizes, const SliceShape& shape)
      : section_{section}, shape_{shape} {
    require(shape.angle > 0 && shape.angle <= pi / 2, "SliceShape.angle", shape.angle,
            "must lie in (0, pi/2]");
    require(shape.arc_ratio > 0, "SliceShape.arc_ratio", shape.arc_ratio, "must be positive");
    require(shape.device_pieces >= 1, "SliceShape.device_pieces", shape.device_pieces, "must be at least 1");
    for (const Point2& x : section.data.nodes) {
      const double beyond = std::max(0.0, x[0] - sizes.fine_radius) / (chamber.radius - sizes.fine_radius);
      const double width = sizes.cell * (1 + (sizes.outer_ratio - 1) * beyond);
      const int wanted = static_cast<int>(std::ceil(shape.angle * x[0] / (shape.arc_ratio * width) - 1e-9));
      const int least = x[0] >= body.radius() / 2 ? shape.device_pieces : 1;
      pieces_.push_back(x[0] > 0 ? std::max(least, wanted) : 0);
    }
  }

  MeshData<3> operator()() {
    mesh_.region_names = section_.data.region_names;
    for (std::size_t n = 0; n < pieces_.size(); ++n) add_chain(n);
    for (std::size_t c = 0; c < section_.data.cells.size(); ++c)
      sweep(section_.data.cells[c], section_.data.region[c]);
    for (const auto& [name, nodes] : section_.data.node_sets)
      for (const Index n : nodes)
        for (int k = 0; k <= pieces_[n]; ++k)
          mesh_.node_sets[name].push_back(first_[n] + static_cast<Index>(k));
    for (std::size_t n = 0; n < pieces_.size(); ++n) {
      mesh_.node_sets["side_minus"].push_back(first_[n]);
      mesh_.node_sets["side_plus"].push_back(first_[n] + static_cast<Index>(pieces_[n]));
    }
    return std::move(mesh_);
  }

 private:
  void add_chain(std::size_t n) {
    first_.push_back(static_cast<Index>(mesh_.nodes.size()));
    const Point2& x = section_.data.nodes[n];
    if (pieces_[n] == 0) mesh_.nodes.emplace_back(0, x[1], 0);
    for (int k = 0; pieces_[n] > 0 && k <= pieces_[n]; ++k) {
      const double a =
          shape_.angle * (2.0 * k - pieces_[n]) / (2.0 * pieces_[n]);  // odd in k: exact mirror symmetry
      mesh_.nodes.emplace_back(x[0] * std::cos(a), x[1], x[0] * std::sin(a));
    }
  }

  /// Whether the sweep passes piece ka of chain a before piece kb of chain b: a strict order of all pieces,
  /// the same for every triangle, so that two triangles cut the face that they share alike. First the angle
  /// of the piece's middle, then the colour of a chequerboard, so that the diagonals alternate, then the
  /// node's number.
  bool before(Index a, int ka, Index b, int kb) const {
    const int left = (2 * ka + 1) * pieces_[b], right = (2 * kb + 1) * pieces_[a];
    if (left != right) return left < right;
    const int colour_a = (section_.row_of[a] + section_.place_in_row[a] + ka) % 2;
    const int colour_b = (section_.row_of[b] + section_.place_in_row[b] + kb) % 2;
    return colour_a != colour_b ? colour_a < colour_b : a < b;
  }

  void sweep(const std::array<Index, 3>& triangle, int region) {
    std::array<int, 3> at{0, 0, 0};
    const auto node = [&](std::size_t i) { return first_[triangle[i]] + static_cast<Index>(at[i]); };
    for (;;) {
      std::size_t next = 3;
      for (std::size_t i = 0; i < 3; ++i)
        if (at[i] < pieces_[triangle[i]] &&
            (next == 3 || before(triangle[i], at[i], triangle[next], at[next])))
          next = i;
      if (next == 3) return;
      // Counter-clockwise below, the new node above: positive.
      std::array<Index, 4> cell{node(0), node(1), node(2), 0};
      ++at[next];
      cell[3] = node(next);
      mesh_.cells.push_back(cell);
      mesh_.region.push_back(region);
    }
  }

  const AxisymmetricMesh& section_;
  SliceShape shape_;
  std::vector<int> pieces_;   ///< [section nodes] pieces of the arc; 0 on the axis
  std::vector<Index> first_;  ///< [section nodes] first node of the chain
  MeshData<3> mesh_;
};

}  // namespace detail

/// Tetrahedra of the slice, positively oriented. Regions and node sets of the section, and "side_minus",
/// "side_plus": the nodes on the two planes (those on the axis are on both). Arcs are chords: a chain of k
/// pieces loses 1 - sin(angle/k)/(angle/k) of its sector's area (0.5 % at the device with two pieces).
inline MeshData<3> mesh_slice(const AxisymmetricMesh& section, const Device& body,
                              const Chamber& chamber = {}, const MeshSizes& sizes = {},
                              const SliceShape& shape = {}) {
  return detail::SliceMesher{section, body, chamber, sizes, shape}();
}

}  // namespace arenite::ffp
