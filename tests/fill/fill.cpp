// Filling: volumes, masses, initial stress, regions, and what is refused.
#include "catch.hpp"

#include <arenite/law/linear_elastic.hpp>
#include <arenite/particles/body.hpp>

#include "../mesh/sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

const LinearElastic law{{.density = 2000, .young = 1e6, .poisson = 0.3}};

template <class K, class M, class Region>
auto body_of(const M& mesh, Region region, FillOptions options = {},
             Ground ground = {.gravity = {0, -9.81, 0}}) {
  return make_body<K>(mesh, fill(std::move(region), law, options), ground);
}

template <class B>
double volume(const B& body) {
  double sum = 0;
  for (const auto v : body.points.volume) sum += static_cast<double>(v);
  return sum;
}

const CartesianGrid<2> grid({.lower = {0, 0}, .upper = {2, 1}, .cell = 0.25});

/// Two regions of a mesh over r in [0.5, 1.5]: "low" below y = 0.5, "high" above.
SimplexMesh<2> two_regions() {
  SampleMesh<2> o{};
  o.cells = {4, 4};
  o.lower = {0.5, 0};
  o.upper = {1.5, 1};
  o.region = [](const auto& x) { return x[1] < 0.5 ? 3 : 5; };
  auto data = sample_data(o);
  data.region_names = {{"low", 3}, {"high", 5}};
  return SimplexMesh<2>(data);
}

}  // namespace

TEST_CASE("a cell of several names belongs to the region of each") {
  SampleMesh<2> o{};
  o.cells = {4, 4};
  o.lower = {0, 0};
  o.upper = {1, 1};
  o.region = [](const auto& x) { return x[1] > 0.5 ? 5 : x[0] < 0.25 ? -1 : 3; };
  auto data = sample_data(o);
  data.region_names = {{"low", 3}, {"high", 5}, {"wet", 7}};  // no cell is only wet
  data.shared_regions = {{"low", {-1}}, {"wet", {-1}}};
  const SimplexMesh<2> mesh(data);
  CHECK(volume(body_of<PlaneStrain>(mesh, Cells("low"))) == Approx(0.5));
  CHECK(volume(body_of<PlaneStrain>(mesh, Cells("high"))) == Approx(0.5));
  CHECK(volume(body_of<PlaneStrain>(mesh, Cells("wet"))) == Approx(0.125));
  CHECK(volume(body_of<PlaneStrain>(mesh, Cells(std::vector<std::string>{"low", "wet"}))) == Approx(0.5));
}

TEST_CASE("volumes add up to that of the region") {
  const auto mesh = two_regions();
  for (const int n : {1, 3, 4, 16}) {
    const auto plane = body_of<PlaneStrain>(mesh, Cells("low"), {.per_cell = n});
    REQUIRE(std::abs(volume(plane) - 0.5) < 1e-14);
    REQUIRE(std::abs(plane.initial_volume - 0.5) < 1e-14);
    // Full circle: the integral of 2 pi r over r in [0.5, 1.5] and half a metre.
    const auto round = body_of<Axisymmetric>(mesh, Cells("high"), {.per_cell = n});
    REQUIRE(std::abs(volume(round) - pi * (1.5 * 1.5 - 0.5 * 0.5) / 2) < 1e-13);
    const auto both =
        body_of<Axisymmetric>(mesh, Cells(std::vector<std::string>{"low", "high"}), {.per_cell = n});
    REQUIRE(std::abs(volume(both) - pi * 2) < 1e-13);
    for (std::size_t p = 0; p < both.points.size(); ++p)
      REQUIRE(std::abs(both.points.mass[p] - 2000 * both.points.volume[p]) < 1e-12);
  }
  const auto solid = sample_mesh<3>(2);
  REQUIRE(std::abs(
              volume(body_of<ThreeDimensional>(solid, Box{{-9., -9., -9.}, {9., 9., 9.}}, {.per_cell = 10})) -
              1) < 1e-13);
  REQUIRE(std::abs(volume(body_of<PlaneStrain>(grid, Box{{0., 0.}, {0.5, 0.75}})) - 0.375) < 1e-15);
  REQUIRE(std::abs(volume(body_of<Axisymmetric>(grid, Box{{0., 0.}, {0.5, 1.}})) - pi * 0.25) < 1e-14);
}

TEST_CASE("exact_volume: points represent the part of their sub-cells that lies in the region") {
  // Total mass and first moment of layers, whatever part of a sub-cell they end in.
  for (const double top : {0.05, 0.1, 0.13, 0.26, 0.4, 0.63})
    for (const bool exact : {false, true}) {
      if (!exact && top < 0.0625) continue;  // no middle of a sub-cell lies in it
      const auto layer = body_of<PlaneStrain>(grid, Box{{0., 0.}, {2., top}}, {.exact_volume = exact});
      CAPTURE(top);
      CHECK(layer.region_volume == Approx(2 * top).epsilon(1e-12));
      if (!exact) continue;
      double moment = 0;
      for (std::size_t p = 0; p < layer.points.size(); ++p) {
        moment += layer.points.volume[p] * layer.points.position[p][1];
        REQUIRE(grid.walk(layer.points.position[p]) == layer.points.cell[p]);
        REQUIRE(layer.points.mass[p] == 2000 * layer.points.volume[p]);
        if (top > 0.2) REQUIRE(layer.points.volume[p] > 0.1 * square(0.125));
      }
      CHECK(volume(layer) == Approx(2 * top).epsilon(1e-12));
      CHECK(moment == Approx(top * top).epsilon(1e-3));  // of the corners, too
      CHECK(layer.initial_volume == Approx(2 * top).epsilon(1e-12));
    }
  CHECK(volume(body_of<PlaneStrain>(grid, Box{{0., 0.}, {2., 0.2}})) == Approx(0.5));  // without it
  // Where the region ends on sub-cells: the same bits.
  const Box<2> fits{{0, 0}, {0.5, 0.625}};
  const auto plain = body_of<Axisymmetric>(grid, fits),
             same = body_of<Axisymmetric>(grid, fits, {.exact_volume = true});
  REQUIRE(plain.points.size() == same.points.size());
  for (std::size_t p = 0; p < plain.points.size(); ++p) {
    REQUIRE(plain.points.position[p] == same.points.position[p]);
    REQUIRE(plain.points.volume[p] == same.points.volume[p]);
  }
  const FillOptions exact{.exact_volume = true};
  const double disc = pi * 0.09;
  CHECK(volume(body_of<PlaneStrain>(grid, Ball({1.03, 0.52}, 0.3), exact)) == Approx(disc).epsilon(0.003));
  CHECK(volume(body_of<Axisymmetric>(grid, Ball({0., 0.52}, 0.3), exact)) ==
        Approx(0.4 * disc).epsilon(0.003));
  const auto test = [](const Vec<double, 2>& x) { return (x - Vec<double, 2>(1.03, 0.52)).norm() < 0.3; };
  struct Disc {
    decltype(test) contains;
  };
  CHECK(volume(body_of<PlaneStrain>(grid, Disc{test}, exact)) == Approx(disc).epsilon(0.02));
  const auto scaled = [](const Vec<double, 2>& x) {
    return 0.1 * ((x - Vec<double, 2>(1.03, 0.52)).norm() - 0.3);
  };
  CHECK(volume(body_of<PlaneStrain>(grid, Inside{scaled}, exact)) == Approx(disc).epsilon(0.003));
  const RectilinearGrid<2> unequal{{.x = {0, 0.3, 0.5, 1, 2}, .y = {0, 0.4, 0.5, 1}}};
  for (const bool even : {false, true})
    CHECK(volume(body_of<PlaneStrain>(unequal, Box{{0., 0.}, {1.31, 0.47}},
                                      {.jitter = 0.5, .even = even, .exact_volume = true})) ==
          Approx(1.31 * 0.47).epsilon(0.002));
  const auto mesh = two_regions();
  for (const int n : {1, 3, 4, 16})
    CHECK(volume(body_of<Axisymmetric>(mesh, Box{{0.5, 0.}, {1.5, 0.63}},
                                       {.per_cell = n, .exact_volume = true})) ==
          Approx(1.26 * pi).epsilon(0.01));
  CHECK(volume(body_of<Axisymmetric>(mesh, Cells("low"), {.per_cell = 3, .exact_volume = true})) ==
        Approx(pi));
  const CartesianGrid<3> space({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 0.25});
  CHECK(volume(body_of<ThreeDimensional>(space, Box{{0., 0., 0.}, {1., 1., 0.64}}, exact)) ==
        Approx(0.64).epsilon(1e-3));
  CHECK(volume(body_of<ThreeDimensional>(sample_mesh<3>(2), Box{{-9., -9., -9.}, {9., 9., 0.64}}, exact)) ==
        Approx(0.64).epsilon(0.02));
}

TEST_CASE("points a cell: four, and eight in the cells of a grid in space") {
  CHECK(body_of<PlaneStrain>(grid, Box{{0., 0.}, {2., 1.}}).points.size() == 4 * 32);
  const CartesianGrid<3> space({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 0.5});
  CHECK(body_of<ThreeDimensional>(space, Box{{0., 0., 0.}, {1., 1., 1.}}).points.size() == 8 * 8);
  const auto solid = sample_mesh<3>(2);
  CHECK(body_of<ThreeDimensional>(solid, Box{{-9., -9., -9.}, {9., 9., 9.}}).points.size() ==
        4 * solid.cell_count());
}

TEST_CASE("a signed distance fills what lies inside") {
  const auto disc = [](const auto& x) { return (x - Vec<double, 2>(1, 0.5)).norm() - 0.4; };
  const CartesianGrid<2> fine({.lower = {0, 0}, .upper = {2, 1}, .cell = 0.02});
  const auto body = body_of<PlaneStrain>(fine, Inside{disc}, {.per_cell = 16});
  REQUIRE(std::abs(volume(body) / (pi * 0.16) - 1) < 2e-3);
  for (const auto& x : body.points.position) REQUIRE(disc(x) < 0);
}

TEST_CASE("points know their cell, their velocity and their stress of level ground") {
  const FillOptions options{
      .per_cell = 4, .velocity = {1, -2, 0}, .stress = Geostatic{.surface = 0.5, .k0 = 0.4}};
  const auto body = body_of<PlaneStrain>(grid, Box{{0., 0.}, {2., 1.}}, options);
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const auto& x = body.points.position[p];
    REQUIRE(grid.walk(x) == body.points.cell[p]);
    REQUIRE(body.points.velocity[p] == Vec<double, 2>(1, -2));
    const double vertical = -2000 * 9.81 * std::max(0.0, 0.5 - x[1]);  // nothing above the surface
    const Sym<double, 2> expected{{0.4 * vertical, vertical, 0.4 * vertical, 0}};
    for (std::size_t k = 0; k < 4; ++k) REQUIRE(std::abs(body.points.stress[p][k] - expected[k]) < 1e-10);
  }
  const CartesianGrid<3> box({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 1});
  const auto solid = body_of<ThreeDimensional>(box, Box{{0., 0., 0.}, {1., 1., 1.}},
                                               {.per_cell = 1, .stress = Geostatic{.surface = 1, .k0 = 0.5}},
                                               {.gravity = {0, 0, -10}});
  REQUIRE(std::abs(solid.points.stress[0][2] + 2000 * 10 * 0.5) < 1e-10);
  REQUIRE(std::abs(solid.points.stress[0][0] + 2000 * 5 * 0.5) < 1e-10);
}

TEST_CASE("initial stress is any function of the position") {
  const auto slope = [](const auto& x) {
    return std::array<double, 6>{-1e3 * x[0], -2e3 * x[1], -500, 100 * x[0] * x[1], 0, 0};
  };
  const auto body = body_of<PlaneStrain>(grid, Box<2>{{0, 0}, {2, 1}}, {.per_cell = 4, .stress = slope});
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const Vec<double, 2> x = body.points.position[p];
    const auto stress = body.points.stress[p];
    const auto exact = slope(std::array<double, 3>{x[0], x[1], 0});
    for (std::size_t k = 0; k < 4; ++k) REQUIRE(stress[k] == exact[k]);
  }
  const auto refused = [](auto function) -> std::string {
    try {
      body_of<PlaneStrain>(grid, Box<2>{{0, 0}, {2, 1}}, {.per_cell = 1, .stress = function});
    } catch (const error& e) {
      return e.what();
    }
    return "taken";
  };
  CHECK(refused([](const auto&) { return std::array<double, 6>{0, NAN, 0, 0, 0, 0}; }) ==
        "FillOptions.stress, yy at (0.125, 0.125) m = nan: must be finite");
  CHECK(refused([](const auto&) { return std::array<double, 6>{0, 0, 0, 0, 0, 5}; }) ==
        "FillOptions.stress, zx at (0.125, 0.125) m = 5: must be zero in two dimensions");
}

TEST_CASE("a box contains its lower faces and not its upper ones: neighbours share no point") {
  const CartesianGrid<2> odd({.lower = {0, 0}, .upper = {2, 1}, .cell = 1});
  const auto low = body_of<PlaneStrain>(odd, Box{{0., 0.}, {1.5, 1.}}, {.per_cell = 1});
  const auto high = body_of<PlaneStrain>(odd, Box{{1.5, 0.}, {2., 1.}}, {.per_cell = 1});
  REQUIRE(low.points.size() == 1);
  REQUIRE(high.points.size() == 1);
}

TEST_CASE("jitter moves points within their sub-cells, by its own numbers") {
  const FillOptions even{.per_cell = 4}, moved{.per_cell = 4, .jitter = 1, .seed = 3};
  const Box<2> all{{0, 0}, {2, 1}};
  const auto lattice = body_of<PlaneStrain>(grid, all, even), body = body_of<PlaneStrain>(grid, all, moved);
  REQUIRE(body.points.size() == lattice.points.size());
  Vec<double, 2> mean = Vec<double, 2>::Zero(), farthest = mean;
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const Vec<double, 2> by = body.points.position[p] - lattice.points.position[p];
    REQUIRE(by.cwiseAbs().maxCoeff() <= 0.25 / 4);
    mean += by / static_cast<double>(body.points.size());
    farthest = farthest.cwiseMax(by.cwiseAbs());
  }
  CHECK(mean.norm() < 0.01);
  CHECK(farthest.minCoeff() > 0.06);
  // The numbers themselves: splitmix64 of seed, cell and point, computed elsewhere.
  CHECK(body.points.position[0][0] == Approx(0.09686229371849937).epsilon(1e-14));
  CHECK(body.points.position[0][1] == Approx(0.10412966552482308).epsilon(1e-14));
  const auto half = body_of<PlaneStrain>(grid, Box<2>{{1, 0}, {2, 1}}, moved);  // the same points again
  std::size_t same = 0;
  for (const auto& x : half.points.position)
    for (const auto& y : body.points.position) same += x == y;
  CHECK(same == half.points.size());

  const auto mesh = two_regions();
  for (const int n : {1, 3, 6, 10, 16}) {
    const auto in_cells = body_of<PlaneStrain>(
        mesh, Cells("low"), {.per_cell = n, .jitter = 1, .seed = static_cast<std::uint64_t>(n)});
    CHECK(volume(in_cells) == Approx(0.5));
    for (std::size_t p = 0; p < in_cells.points.size(); ++p)
      REQUIRE(mesh.barycentric(in_cells.points.cell[p], in_cells.points.position[p]).minCoeff() > -1e-14);
  }
  // One point in each cell: its mean place is the centroid, its variance that of the cell.
  MeshData<2> triangle;
  triangle.nodes = {{0, 0}, {1, 0}, {0, 1}};
  triangle.cells = {{0, 1, 2}};
  triangle.region = {0};
  const SimplexMesh<2> one(triangle);
  double sum = 0, square_sum = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    const auto single = body_of<PlaneStrain>(one, all, {.per_cell = 1, .jitter = 1, .seed = seed});
    sum += single.points.position[0][0] / 4000;
    square_sum += square(single.points.position[0][0]) / 4000;
  }
  CHECK(sum == Approx(1.0 / 3).epsilon(0.03));
  CHECK(square_sum - sum * sum == Approx(1.0 / 18).epsilon(0.1));
}

TEST_CASE("what cannot be filled is refused") {
  const Box<2> all{{0, 0}, {2, 1}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [&](FillOptions o, const std::string& text) {
    return throws([&] { body_of<PlaneStrain>(grid, all, o); }, text);
  };
  REQUIRE(refuses({.jitter = 1.5}, "FillOptions.jitter = 1.5: must lie in [0, 1]"));
  REQUIRE(throws(
      [] {
        body_of<PlaneStrain>(grid, Box{{5., 5.}, {6., 6.}});
      },
      "fill: points = 0: the region holds no point of the mesh"));
  REQUIRE(throws([] { body_of<PlaneStrain>(two_regions(), Cells("middle")); },
                 "region = middle: must be one of: high, low"));
  REQUIRE(refuses({.per_cell = 3}, "per_cell = 3: must be a square"));
  REQUIRE(refuses({.per_cell = 0}, "FillOptions.per_cell = 0: must be at least 1"));
  REQUIRE(refuses({.stress = Geostatic{}}, "Geostatic.surface = nan: must be given"));
  REQUIRE(
      refuses({.stress = Geostatic{.surface = 0}}, "Geostatic.k0 = nan: must be given, and not negative"));
  REQUIRE(refuses({.stress = Geostatic{.surface = 0, .k0 = -1}},
                  "Geostatic.k0 = -1: must be given, and not negative"));
  REQUIRE(refuses({.stress = Geostatic{.surface = 0, .k0 = 1, .surcharge = -1}},
                  "Geostatic.surcharge = -1: must be finite, and not negative"));
  REQUIRE(refuses({.velocity = {nan, 0, 0}}, "FillOptions.velocity = nan: must be finite"));
  REQUIRE(refuses({.velocity = {0, 0, 1}},
                  "FillOptions.velocity = 1: must be zero along an axis that the scene does not have"));
}
