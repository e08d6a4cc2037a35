// The half-section of the drop as triangles, fitted to the penetrometer: horizontal rows of nodes, joined by
// strips. No external mesher: the domain is a chamber cut by one convex body, and rows keep the zone that the
// moving mesh compresses in flat layers, which lose height without turning over.
#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <arenite/mesh/mesh_data.hpp>

#include "geometry.hpp"
#include "grading.hpp"

namespace arenite::ffp {

enum Region : int { soil = 0, air = 1, device = 2, lid = 3 };

/// Lengths of the mesh. All follow `cell`, so that a finer mesh is the same mesh, refined.
struct MeshSizes {
  double cell = 0.01;          ///< edge of a cell around the cone and along its path, m
  double at_cone = 0;          ///< the same at the cone, at its tip and its shoulder, m; 0: `cell`
  double refined = 0.02;       ///< cells are as at the cone to this distance from it, m
  double growth = 0.15;        ///< by how much an edge is longer than one that lies a metre nearer, m/m
  double moving_depth = 0.06;  ///< the mesh moves as one from this depth below the tip upward, m
  double fine_radius = 0.07;   ///< cells are `cell` wide to this distance from the axis or the device, m
  double outer_ratio = 1.8;    ///< width of a cell at the wall over `cell`
  /// Height of a layer of the compressed zone over `cell`. A drop of 0.22 m leaves 0.35 of it, one of 0.28 m
  /// 0.18.
  double layer_ratio = 1.3;
  double top_ratio = 3;  ///< height of a cell at the top of the model over `cell`

  double cone_cell() const { return at_cone > 0 ? at_cone : cell; }
  /// Edge of a cell at a distance from the cone, m, where it would be `usual` without refinement.
  double edge(double distance, double usual) const {
    return at_cone > 0 ? std::min(usual, at_cone + growth * std::max(0.0, distance - refined)) : usual;
  }
};

/// Triangles and the rows that they were made from.
struct AxisymmetricMesh {
  MeshData<2> data;  ///< regions soil, air, device; sets axis, wall, bottom, top, device_surface, device
  std::vector<double> row_height;  ///< [rows] y of each row, m, ascending
  std::vector<int> row_of;         ///< [nodes] row of each node
  std::vector<int> place_in_row;   ///< [nodes] place of each node from the axis outward
};

namespace detail {

/// Rows and strips, from the bottom up.
class AxisymmetricMesher {
 public:
  AxisymmetricMesher(const Device& body, const Chamber& chamber, const MeshSizes& sizes)
      : body_{body}, chamber_{chamber}, sizes_{sizes} {
    const auto& s = sizes;
    require(s.cell > 0 && s.cell <= chamber.radius / 4, "MeshSizes.cell", s.cell,
            "must be positive and no more than a quarter of the chamber's radius");
    require(s.at_cone >= 0 && s.at_cone <= s.cell, "MeshSizes.at_cone", s.at_cone,
            "must lie between 0 and MeshSizes.cell");
    require(s.moving_depth > 0 && s.moving_depth < chamber.soil_depth, "MeshSizes.moving_depth",
            s.moving_depth, "must lie between 0 and the depth of the soil");
    require(s.fine_radius >= 0 && s.fine_radius < chamber.radius, "MeshSizes.fine_radius", s.fine_radius,
            "must lie between 0 and the chamber's radius");
    require(s.outer_ratio >= 1, "MeshSizes.outer_ratio", s.outer_ratio, "must be at least 1");
    require(s.layer_ratio > 0, "MeshSizes.layer_ratio", s.layer_ratio, "must be positive");
    require(s.top_ratio >= 1, "MeshSizes.top_ratio", s.top_ratio, "must be at least 1");
    require(chamber.headroom > body.length(), "Chamber.headroom", chamber.headroom,
            "must be more than the device's length");
    require(chamber.embedded >= 0 && chamber.embedded <= body.length(), "Chamber.embedded", chamber.embedded,
            "must lie between 0 and the device's length");
    require(chamber.lid >= 0 && chamber.lid <= chamber.embedded, "Chamber.lid", chamber.lid,
            "must lie between 0 and Chamber.embedded");
  }

  AxisymmetricMesh operator()() {
    mesh_.data.region_names = {{"soil", soil}, {"air", air}, {"device", device}};
    if (chamber_.lid > 0) mesh_.data.region_names.emplace("lid", lid);
    columns_ = graded(0, chamber_.radius, [&](double x) { return width(x); });
    make_row_heights();
    set_tip();
    for (std::size_t j = 0; j < mesh_.row_height.size(); ++j) add_row(static_cast<int>(j));
    for (std::size_t j = 0; j + 1 < rows_.size(); ++j) add_strip(j);
    make_sets();
    return std::move(mesh_);
  }

 private:
  struct Row {
    std::vector<Index>
        inside;  ///< nodes from the axis to the device's surface, both included; empty below the tip
    std::vector<Index> outside;  ///< nodes from the axis or the device's surface to the wall
  };

  double width(double x) const {
    const double beyond = std::max(0.0, x - sizes_.fine_radius) / (chamber_.radius - sizes_.fine_radius);
    return sizes_.edge(x, sizes_.cell * (1 + (sizes_.outer_ratio - 1) * beyond));
  }

  void append(const std::vector<double>& heights) {
    auto& all = mesh_.row_height;
    all.insert(all.end(), heights.begin() + (all.empty() ? 0 : 1), heights.end());
  }

  void make_row_heights() {
    const double h = sizes_.cell, deep = -sizes_.moving_depth;
    append(even(-chamber_.soil_depth, deep, sizes_.layer_ratio * h));
    append(graded(deep, 0, [&](double y) { return sizes_.edge(-y, h); }));
    const double from =
        chamber_.embedded + chamber_.soil_depth / 2;  // the soil that rises around the cylinder stays below
    const auto marks = body_.marks(sizes_.cone_cell() / 2);
    const double tip_end = *std::prev(std::upper_bound(marks.begin(), marks.end(), body_.tip_end()));
    const auto height = [&](double y) {
      const double usual =
          h * (1 + (sizes_.top_ratio - 1) * (y > from ? (y - from) / (chamber_.headroom - from) : 0));
      return sizes_.edge(y - tip_end, usual);
    };
    // Edges along the tip are one cell long, and longer where it is so blunt that rows would be too thin.
    double at = 0;
    for (const double mark : marks) {
      if (mark > at)
        append(graded(at, mark, [&](double y) {
          return (mark <= tip_end ? sizes_.cone_cell() : height(y)) * std::max(0.5, body_.rise(y));
        }));
      at = mark;
    }
    for (const double mark : {chamber_.embedded - chamber_.lid, chamber_.embedded})
      if (mark > at && mark < body_.length()) {
        append(graded(at, mark, height));
        at = mark;
      }
    append(graded(at, body_.length(), height));
    append(graded(body_.length(), chamber_.headroom, height));
  }

  /// The row at the tip has nodes on the device as far as its flat end reaches, unless that is less than half
  /// a cell: then a facet leads from the axis to the next row. A parabola, too, is flat in the mesh where
  /// such a facet would leave the sand at less than 30 deg; the mesh has up to a quarter of a cell too much
  /// of it there. So may be the top.
  void set_tip() {
    const auto& rows = mesh_.row_height;
    const double next = *std::upper_bound(rows.begin(), rows.end(), 0.0);
    const double blunt = std::max(body_.flat_radius(), body_.profile(next) - next / std::tan(pi / 6));
    tip_radius_ = blunt < sizes_.cone_cell() / 2 ? 0 : blunt;
    const double top = *std::lower_bound(rows.begin(), rows.end(), body_.length());
    const double last = *std::prev(std::lower_bound(rows.begin(), rows.end(), body_.length()));
    top_radius_ = std::max(body_.profile(top), body_.profile(last) - (top - last) / std::tan(pi / 6));
  }

  /// Radius from which the columns of a row fan out, m: that of the device, and below it that of its flat
  /// end, so that rows match.
  double fan_start(double y) const {
    return y >= body_.length() ? top_radius_ : y > 0 ? body_.profile(y) : tip_radius_;
  }
  /// Edge of the cells inside the device, m.
  double inner_cell(double y) const {
    return tip_radius_ > 0 ? std::min(sizes_.cell, sizes_.cone_cell() + std::max(0.0, y) / 2) : sizes_.cell;
  }

  Index add_node(double r, double y, int row, int place) {
    mesh_.data.nodes.emplace_back(r, y);
    mesh_.row_of.push_back(row);
    mesh_.place_in_row.push_back(place);
    return static_cast<Index>(mesh_.data.nodes.size() - 1);
  }

  void add_row(int j) {
    const double y = mesh_.row_height[static_cast<std::size_t>(j)];
    const double surface = fan_start(y);
    Row row;
    int place = 0;
    if (surface > 0) {
      const int pieces = std::max(1, static_cast<int>(std::lround(surface / inner_cell(y))));
      for (int i = 0; i < pieces; ++i) row.inside.push_back(add_node(surface * i / pieces, y, j, place++));
    }
    for (const double s :
         columns_) {  // columns start on the surface and fan back to their own radius at the wall
      const bool wall = s == columns_.back();
      row.outside.push_back(
          add_node(wall ? s : surface + s * (1 - surface / chamber_.radius), y, j, place++));
    }
    if (y >= 0) {
      row.inside.push_back(row.outside.front());
    } else {
      row.outside.insert(row.outside.begin(), row.inside.begin(), row.inside.end());
      row.inside.clear();
    }
    rows_.push_back(std::move(row));
  }

  /// Of the cells beside the device whose row ends at a height.
  Region region_at(double above) const {
    if (above > chamber_.embedded) return air;
    return above > chamber_.embedded - chamber_.lid ? lid : soil;
  }

  void add_strip(std::size_t j) {
    const double below = mesh_.row_height[j], above = mesh_.row_height[j + 1];
    join(rows_[j].outside, above == 0 ? whole(rows_[j + 1]) : rows_[j + 1].outside, region_at(above), j);
    if (below >= 0) join(rows_[j].inside, rows_[j + 1].inside, above <= body_.length() ? device : air, j);
  }

  /// All nodes of a row at the device, from the axis to the wall.
  static std::vector<Index> whole(const Row& row) {
    auto nodes = row.inside;
    nodes.insert(nodes.end(), row.outside.begin() + 1, row.outside.end());
    return nodes;
  }

  double distance(Index a, Index b) const { return (mesh_.data.nodes[a] - mesh_.data.nodes[b]).norm(); }

  /// Fills the strip between two rows. Of the two diagonals the much shorter one, which in the sheared cells
  /// along the cone makes nearly equilateral triangles; where they are about equal they alternate (union
  /// jack), without bias.
  void join(const std::vector<Index>& low, const std::vector<Index>& high, Region region, std::size_t j) {
    constexpr double about_equal = 1.1;
    std::size_t a = 0, b = 0;
    while (a + 1 < low.size() || b + 1 < high.size()) {
      bool advance_low = b + 1 == high.size();
      if (!advance_low && a + 1 < low.size()) {
        const double falling = distance(low[a + 1], high[b]), rising = distance(low[a], high[b + 1]);
        advance_low = falling < rising;
        if (a == b && std::max(falling, rising) < about_equal * std::min(falling, rising))
          advance_low = (a + j) % 2 == 0;
      }
      add_cell(
          advance_low ? std::array{low[a], low[a + 1], high[b]} : std::array{low[a], high[b + 1], high[b]},
          region);
      ++(advance_low ? a : b);
    }
  }

  void add_cell(const std::array<Index, 3>& nodes, Region region) {
    mesh_.data.cells.push_back(nodes);
    mesh_.data.region.push_back(region);
  }

  void make_sets() {
    auto& sets = mesh_.data.node_sets;
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      const Row& row = rows_[j];
      const double y = mesh_.row_height[j];
      sets["axis"].push_back(row.inside.empty() ? row.outside.front() : row.inside.front());
      sets["wall"].push_back(row.outside.back());
      if (y < 0 || y > body_.length()) continue;
      if (y == 0)
        sets["device_surface"] = row.inside;
      else
        sets["device_surface"].push_back(row.outside.front());
      sets["device"].insert(sets["device"].end(), row.inside.begin(), row.inside.end());
    }
    sets["bottom"] = rows_.front().outside;
    sets["top"] = rows_.back().inside;
    sets["top"].insert(sets["top"].end(), rows_.back().outside.begin() + 1, rows_.back().outside.end());
  }

  Device body_;
  Chamber chamber_;
  MeshSizes sizes_;
  double tip_radius_ = 0,
         top_radius_ = 0;  ///< how far the device reaches in the rows at its tip and its top, m
  std::vector<double> columns_;
  std::vector<Row> rows_;
  AxisymmetricMesh mesh_;
};

}  // namespace detail

/// Triangles of the half-section r >= 0, counter-clockwise, fitted to the device with its tip at the origin.
/// Regions: "soil", of it "lid" where the chamber has one, "device", "air" (the rest). Node sets: "axis", "wall", "bottom", "top", "device"
/// (all nodes of device cells), "device_surface" (tip and cylinder; the flat top's inner nodes, which soil
/// never touches, are left out). Throws `error` if the sizes do not fit the chamber.
inline AxisymmetricMesh mesh_axisymmetric(const Device& body, const Chamber& chamber = {},
                                          const MeshSizes& sizes = {}) {
  return detail::AxisymmetricMesher{body, chamber, sizes}();
}

}  // namespace arenite::ffp
