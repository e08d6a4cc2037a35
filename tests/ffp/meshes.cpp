// The meshes of the drop: exact volumes, conforming cells, good shapes at every size, at the start and at
// full depth.
#include <array>
#include <set>

#include <arenite/mesh/simplex_mesh.hpp>

#include "../../examples/ffp/geometry/mesh_grid.hpp"
#include "../../examples/ffp/geometry/mesh_quality.hpp"
#include "../../examples/ffp/geometry/mesh_slice.hpp"
#include "../../examples/ffp/geometry/tilted.hpp"
#include "../../examples/ffp/geometry/tip.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::ffp;

namespace {

constexpr double degree = pi / 180;

bool contains(const std::vector<Index>& set, Index n) {
  return std::binary_search(set.begin(), set.end(), n);
}

template <int D>
void check_sets(const MeshData<D>& mesh, const Device& body = Device{{}}) {
  for (const auto& [name, set] : mesh.node_sets) {
    INFO(name);
    REQUIRE(std::is_sorted(set.begin(), set.end()));
    REQUIRE(std::adjacent_find(set.begin(), set.end()) == set.end());
  }
  const auto in = [&](const char* name, Index n) { return contains(mesh.node_sets.at(name), n); };
  std::set<Index> of_device;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (mesh.region[c] == mesh.region_names.at("device"))
      of_device.insert(mesh.cells[c].begin(), mesh.cells[c].end());
  REQUIRE(std::vector<Index>(of_device.begin(), of_device.end()) == mesh.node_sets.at("device"));
  double flat = 0;  // of the device's nodes at its tip
  for (const Index n : of_device)
    if (mesh.nodes[n][1] == 0) flat = std::max(flat, mesh.nodes[n].norm());
  for (Index n = 0; n < mesh.nodes.size(); ++n) {
    const auto& x = mesh.nodes[n];
    const double r = D == 3 ? std::hypot(x[0], x[D - 1]) : x[0], y = x[1];
    REQUIRE(in("axis", n) == (r == 0));
    REQUIRE(in("wall", n) == (std::abs(r - 0.4) < 1e-12));
    REQUIRE(in("bottom", n) == (y == -0.4));
    REQUIRE(in("top", n) == (y == 0.7));
    const bool on_tip = y == 0 && r <= flat;
    const bool on_side = y > 0 && y <= body.length() && std::abs(r - body.profile(y)) < 1e-12;
    REQUIRE(in("device_surface", n) == (on_tip || on_side));
    if (of_device.contains(n)) REQUIRE((on_tip || r <= body.profile(y) + 1e-12));
  }
}

/// Each region is an exact union of cells: soil below 0, device within its profile.
template <int D>
void check_regions(const MeshData<D>& mesh) {
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const Index n : mesh.cells[c]) {
      const bool below = mesh.nodes[n][1] < 0;
      if (mesh.region[c] == soil) REQUIRE(mesh.nodes[n][1] <= 0);
      if (mesh.region[c] != soil) REQUIRE(!below);
    }
}

}  // namespace

TEST_CASE("half-section: areas are exact, cells turn counter-clockwise and share whole edges") {
  for (const double cell : {0.04, 0.023, 0.01, 0.005}) {
    INFO(cell);
    const auto mesh = mesh_axisymmetric(Device{{}}, {}, {.cell = cell}).data;
    const auto q = mesh_quality(mesh);
    const double h = 0.04375 * std::sqrt(3.0), device_area = 0.04375 * (h / 2 + 0.631 - h);
    REQUIRE(std::abs(q.at("soil").volume - 0.16) < 1e-13);
    REQUIRE(std::abs(q.at("device").volume - device_area) < 1e-13);
    REQUIRE(std::abs(q.at("air").volume - (0.28 - device_area)) < 1e-13);
    for (const auto& [name, region] : q) REQUIRE(region.min_volume > 0);
    // Euler: nodes - edges + cells = 1 for a disc, and a conforming one has 3 cells + hull edges = 2 edges.
    std::set<std::pair<Index, Index>> edges;
    for (const auto& c : mesh.cells)
      for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(c[k], c[(k + 1) % 3]));
    REQUIRE(mesh.nodes.size() + mesh.cells.size() == edges.size() + 1);
    check_sets(mesh);
    check_regions(mesh);
    const SimplexMesh<2> accepted{mesh};
    REQUIRE(accepted.cell_count() == mesh.cells.size());
  }
}

TEST_CASE("half-section: triangles stay good from 0.25 to 4 cm, sharp and rounded") {
  for (const double cell : {0.0025, 0.004, 0.005, 0.007, 0.01, 0.013, 0.017, 0.02, 0.03, 0.04})
    for (const double fillet : {0.0, 0.01, 0.02}) {
      INFO("cell " << cell << " fillet " << fillet);
      const auto mesh = mesh_axisymmetric(Device{{.fillet = fillet}}, {}, {.cell = cell}).data;
      const auto q = mesh_quality(mesh);
      REQUIRE(q.at("soil").min_altitude > 0.55 * cell);
      REQUIRE(q.at("soil").min_angle > 22 * degree);
      REQUIRE(q.at("air").min_altitude > (fillet > 0 ? 0.3 : 0.62) * cell);
      REQUIRE(q.at("device").min_altitude > 0.3 * cell);
      for (const auto& [name, region] : q) {
        REQUIRE(region.min_volume > 0);
        REQUIRE(region.max_angle < 110 * degree);
      }
    }
}

TEST_CASE("half-section: cells are as long as asked around the cone and in the zone that moves with it") {
  for (const double cell : {0.0025, 0.005, 0.01, 0.02}) {
    INFO(cell);
    const auto mesh = mesh_axisymmetric(Device{{}}, {}, {.cell = cell}).data;
    const auto& surface = mesh.node_sets.at("device_surface");
    for (std::size_t k = 1; k < surface.size() && mesh.nodes[surface[k]][1] < 0.1; ++k) {
      const double edge = (mesh.nodes[surface[k]] - mesh.nodes[surface[k - 1]]).norm();
      REQUIRE((edge > 0.8 * cell && edge < 1.25 * cell));
    }
    for (const auto& c : mesh.cells)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto &a = mesh.nodes[c[k]], &b = mesh.nodes[c[(k + 1) % 3]];
        const double highest = std::max(a[1], b[1]), lowest = std::min(a[1], b[1]),
                     farthest = std::max(a[0], b[0]);
        if (lowest >= -0.06 && highest < 0.15 && farthest < 0.07) REQUIRE((a - b).norm() < 1.55 * cell);
      }
  }
}

TEST_CASE("half-section: finer cells at the cone, which grow to the others") {
  const Device body{{}};
  for (const double at_cone : {0.005, 0.0025, 0.001}) {
    INFO(at_cone);
    const auto mesh = mesh_axisymmetric(body, {}, {.cell = 0.01, .at_cone = at_cone}).data;
    const auto q = mesh_quality(mesh);
    REQUIRE(std::abs(q.at("soil").volume - 0.16) < 1e-13);
    REQUIRE(q.at("soil").min_altitude > 0.69 * at_cone);
    check_sets(mesh);
    check_regions(mesh);
    const auto& surface = mesh.node_sets.at("device_surface");
    for (std::size_t k = 1; k < surface.size() && mesh.nodes[surface[k]][1] < 0.09; ++k) {
      const double edge = (mesh.nodes[surface[k]] - mesh.nodes[surface[k - 1]]).norm();
      REQUIRE((edge > 0.8 * at_cone && edge < 1.25 * at_cone));
    }
    for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
      if (mesh.region[i] == device) continue;
      const auto& c = mesh.cells[i];
      double nearest = 1, longest = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto &a = mesh.nodes[c[k]], &b = mesh.nodes[c[(k + 1) % 3]];
        nearest = std::min(nearest, std::hypot(a[0] - body.profile(a[1]), std::min(0.0, a[1])));
        longest = std::max(longest, (a - b).norm());
        if (a[1] > 0.09) nearest = 1;
      }
      if (nearest < 0.015) REQUIRE(longest < 1.5 * at_cone);
    }
  }
  const auto plain = mesh_axisymmetric(body, {}, {.cell = 0.01}).data,
             same = mesh_axisymmetric(body, {}, {.cell = 0.01, .at_cone = 0.01}).data;
  REQUIRE(plain.nodes == same.nodes);
}

TEST_CASE("half-section: every tip has a mesh, with cells as fine as asked and an offset, too") {
  struct Case {
    Tip tip;
    double soil, air, device;  ///< least altitudes, cells
  };
  for (const Case& c : {Case{Tip::cone_truncated, 0.45, 0.42, 0.4}, Case{Tip::parabolic, 0.45, 0.35, 0.35},
                        Case{Tip::blunt, 0.55, 0.64, 0.6}})
    for (const auto& [cell, at_cone, offset] : {std::array{0.01, 0.0, -0.0025},
                                                {0.02, 0.0, 0.0025},
                                                {0.04, 0.0, 0.0},
                                                {0.01, 0.004, 0.0},
                                                {0.01, 0.002, 0.0025}}) {
      INFO(tip_words[static_cast<std::size_t>(c.tip)].first << " cell " << cell << " at cone " << at_cone
                                                            << " offset " << offset);
      DeviceShape shape = shape_of(c.tip);
      shape.offset = offset;
      if (c.tip == Tip::cone_truncated) shape.fillet = 0.002;
      const Device body{shape};
      const MeshSizes sizes{.cell = cell, .at_cone = at_cone};
      const auto mesh = mesh_axisymmetric(body, {}, sizes).data;
      const auto q = mesh_quality(mesh);
      REQUIRE(std::abs(q.at("soil").volume - 0.16) < 1e-13);
      REQUIRE(std::abs(q.at("device").volume + q.at("air").volume - 0.28) < 1e-13);
      for (const auto& [name, region] : q) REQUIRE(region.min_volume > 0);
      REQUIRE(q.at("soil").min_altitude > c.soil * sizes.cone_cell());
      REQUIRE(q.at("air").min_altitude > c.air * sizes.cone_cell());
      REQUIRE(q.at("device").min_altitude > c.device * sizes.cone_cell());
      check_sets(mesh, body);
      check_regions(mesh);
      const SimplexMesh<2> accepted{mesh};
      double flat = 0;  // of the device in the mesh
      for (const Index n : mesh.node_sets.at("device"))
        if (mesh.nodes[n][1] == 0) flat = std::max(flat, mesh.nodes[n][0]);
      if (c.tip == Tip::parabolic)  // no more than a quarter of a cell too much
        REQUIRE(flat < body.profile(sizes.cone_cell() / 4));
      else
        REQUIRE(flat == (body.flat_radius() < sizes.cone_cell() / 2 ? 0 : body.flat_radius()));
    }
}

TEST_CASE("half-section: the compressed zone keeps its shape to the depth that a drop reaches") {
  const double cell = 0.01, moving = 0.06;
  const auto mesh = mesh_axisymmetric(Device{{}}, {}, {.cell = cell, .moving_depth = moving}).data;
  const auto at = [&](double depth) {
    return mesh_quality(
               mesh,
               [&](Index n) { return mesh.nodes[n][1] - depth * motion_factor(mesh.nodes[n][1], moving); })
        .at("soil");
  };
  REQUIRE(at(0.22).min_altitude > 0.4 * cell);
  REQUIRE(at(0.28).min_altitude > 0.2 * cell);
  REQUIRE(at(0.33).min_volume > 0);
  REQUIRE(at(0.35).min_volume < 0);  // deeper than the zone is high: inside out, and it shows
}

TEST_CASE("slice: about the paper's number of points, exact mirror symmetry, conforming") {
  const Device body{{}};
  const MeshSizes sizes{};
  const auto section = mesh_axisymmetric(body, {}, sizes);
  const auto mesh = mesh_slice(section, body, {}, sizes);
  const auto q = mesh_quality(mesh);
  const double points =
      10.0 * static_cast<double>(q.at("soil").cells) + static_cast<double>(q.at("device").cells);
  REQUIRE(std::abs(points / 326592 - 1) < 0.005);
  // Chords lose a little of the sector: between nothing and the loss of the shortest chains, 2 %.
  const double soil_volume = pi * 0.16 * 0.4 / 18, device_volume = body.volume() / 18;
  REQUIRE(q.at("soil").volume < soil_volume);
  REQUIRE(q.at("soil").volume > soil_volume * 0.999);
  REQUIRE(q.at("device").volume < device_volume);
  REQUIRE(q.at("device").volume > device_volume * 0.99);
  for (const auto& [name, region] : q) REQUIRE(region.min_volume > 0);
  REQUIRE(q.at("soil").min_altitude > 0.9e-3);
  check_sets(mesh);
  check_regions(mesh);

  const SimplexMesh<3> accepted{mesh};  // refuses a face of three cells
  // Hull faces lie on the two planes, the wall, the bottom or the top, and nowhere inside: the cells share
  // whole faces.
  const auto& sets = mesh.node_sets;
  for (Index c = 0; c < accepted.cell_count(); ++c)
    for (int k = 0; k < 4; ++k) {
      if (accepted.neighbour(c, k) != none) continue;
      bool on_one = false;
      for (const char* name : {"side_minus", "side_plus", "wall", "bottom", "top"}) {
        bool all = true;
        for (int i = 0; i < 4; ++i)
          if (i != k) all = all && contains(sets.at(name), accepted.nodes(c)[static_cast<std::size_t>(i)]);
        on_one = on_one || all;
      }
      REQUIRE(on_one);
    }
  for (const Index n : sets.at("side_plus")) {
    const auto& x = mesh.nodes[n];
    REQUIRE(std::abs(x[2] * std::cos(10 * degree) - x[0] * std::sin(10 * degree)) < 1e-15);
  }
  REQUIRE(sets.at("side_minus").size() == section.data.nodes.size());
  for (std::size_t k = 0; k < sets.at("side_minus").size(); ++k) {
    const auto &a = mesh.nodes[sets.at("side_minus")[k]], &b = mesh.nodes[sets.at("side_plus")[k]];
    REQUIRE((a[0] == b[0] && a[1] == b[1] && a[2] == -b[2]));
  }
}

TEST_CASE("slice: tetrahedra of every size and tip have volume") {
  const auto rounded = [](Tip tip) {
    DeviceShape shape = shape_of(tip);
    shape.fillet = 0.01;
    return shape;
  };
  using Case = std::pair<double, DeviceShape>;
  for (const auto& [cell, shape] :
       {Case{0.04, rounded(Tip::cone)}, Case{0.02, rounded(Tip::cone)}, Case{0.007, rounded(Tip::cone)},
        Case{0.02, shape_of(Tip::parabolic)}, Case{0.02, shape_of(Tip::blunt)},
        Case{0.01, rounded(Tip::cone_truncated)}}) {
    INFO(cell << " flat " << shape.flat);
    const Device body{shape};
    const MeshSizes sizes{.cell = cell};
    const auto mesh = mesh_slice(mesh_axisymmetric(body, {}, sizes), body, {}, sizes);
    for (const auto& [name, region] : mesh_quality(mesh)) {
      REQUIRE(region.min_volume > 0);
      REQUIRE(region.min_altitude > 0.06 * cell);
    }
    const SimplexMesh<3> accepted{mesh};
  }
}

TEST_CASE("quality: figures of a right triangle and of the corner of a cube") {
  MeshData<2> triangle{{{0, 0}, {3, 0}, {0, 4}}, {{0, 1, 2}}, {0}, {{"only", 0}}, {}};
  const auto t = mesh_quality(triangle).at("only");
  REQUIRE(std::abs(t.volume - 6) < 1e-14);
  REQUIRE(std::abs(t.min_altitude - 2.4) < 1e-14);
  REQUIRE(std::abs(t.min_angle - std::atan(0.75)) < 1e-14);
  REQUIRE(std::abs(t.max_angle - pi / 2) < 1e-14);
  REQUIRE(std::abs(t.mean_edge - 4) < 1e-14);
  MeshData<3> corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}, {0}, {{"only", 0}}, {}};
  const auto c = mesh_quality(corner).at("only");
  REQUIRE(std::abs(c.volume - 1.0 / 6) < 1e-15);
  REQUIRE(std::abs(c.min_altitude - 1 / std::sqrt(3.0)) < 1e-15);
  REQUIRE(std::abs(c.max_angle - pi / 2) < 1e-14);
  REQUIRE(std::abs(c.min_angle - std::acos(1 / std::sqrt(3.0))) < 1e-14);
}

TEST_CASE("sizes that do not fit the chamber are refused") {
  const Device body{{}};
  REQUIRE_THROWS_AS(mesh_axisymmetric(body, {}, {.cell = 0}), error);
  REQUIRE_THROWS_AS(mesh_axisymmetric(body, {}, {.cell = 0.2}), error);
  REQUIRE_THROWS_AS(mesh_axisymmetric(body, {}, {.moving_depth = 0.4}), error);
  REQUIRE_THROWS_AS(mesh_axisymmetric(body, {}, {.outer_ratio = 0.5}), error);
  REQUIRE_THROWS_AS(mesh_axisymmetric(body, {.headroom = 0.5}), error);
}

TEST_CASE("the grid: lines where sand and moving zone begin, cells of the wanted size at the cone") {
  const Chamber chamber;
  const Device body{{.fillet = 0.01}};
  for (const double cell : {0.04, 0.01, 0.0025})
    for (const double share : {0.0, 0.5, 0.25}) {
      const MeshSizes sizes{.cell = cell, .at_cone = share * cell};
      const auto lines = grid_lines(body, chamber, sizes);
      CAPTURE(cell, share);
      REQUIRE((lines.x.front() == 0 && lines.x.back() == chamber.radius));
      REQUIRE((lines.y.front() == -chamber.soil_depth && lines.y.back() == chamber.headroom));
      for (const double y : {0.0, -sizes.moving_depth}) REQUIRE(std::ranges::count(lines.y, y) == 1);
      const double wanted = sizes.cone_cell();
      for (const auto* all : {&lines.x, &lines.y})
        for (std::size_t i = 1; i < all->size(); ++i) {
          const double edge = (*all)[i] - (*all)[i - 1], at = (*all)[i - 1];
          REQUIRE(edge > 0.6 * wanted);
          REQUIRE(edge < 3.2 * cell);
          const double end = all == &lines.x ? body.radius() : body.tip_end();
          if (at >= 0 && at + edge <= end + sizes.refined) REQUIRE(edge < 1.3 * wanted);
        }
    }
}

TEST_CASE("the section on both sides: the axis is no surface") {
  const Device body{{}};
  const auto section = whole_section(body);
  for (const double r : {0.0, 0.001, 0.01}) {
    const double y = body.tip_end() / 2, half = 30 * pi / 180;
    const double to_flank = (y * std::tan(half) - r) * std::cos(half);
    REQUIRE(std::abs(section({r, y}) + to_flank) < 1e-15);
    REQUIRE(std::abs(section({r, 0.4}) + body.radius() - r) < 1e-15);
    REQUIRE(std::abs(section({r, -0.1}) - std::hypot(r, 0.1)) < 1e-15);
  }
  REQUIRE(std::abs(section({0.06, 0.4}) - 0.06 + body.radius()) < 1e-15);
}
