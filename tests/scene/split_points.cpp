// Points that split: what they carry is kept, and matter that flows into finer cells stays whole.
#include <arenite/arenite.hpp>
#include <numeric>

#include "../../examples/extend/laws/neo_hookean.hpp"
#include "catch.hpp"
#include "meshes.hpp"
#include "state_buffer.hpp"

using namespace arenite;
using test::StateBuffer;

namespace {

const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};

struct Carried {
  double mass = 0, angular = 0, kinetic = 0, strain = 0, volume = 0;
  Eigen::Vector2d momentum = Eigen::Vector2d::Zero(), moment = Eigen::Vector2d::Zero();
};
template <class Body>
Carried carried(const Body& body, double affine_inertia = 0) {
  Carried sum;
  const auto& points = body.points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double m = points.mass[p];
    const Eigen::Vector2d x = points.position[p], v = points.velocity[p];
    sum.mass += m;
    sum.volume += points.volume[p];
    sum.momentum += m * v;
    sum.moment += m * x;
    sum.angular += m * (x[0] * v[1] - x[1] * v[0]);
    sum.kinetic += m * v.squaredNorm() / 2;
    sum.strain += points.volume[p] * body.law.elastic_energy(points.stress[p]);
    if constexpr (std::remove_cvref_t<decltype(points)>::affine) {
      const Eigen::Matrix2d l = points.velocity_gradient[p];
      sum.angular += m * affine_inertia * (l(1, 0) - l(0, 1));
    }
  }
  return sum;
}
void check_kept(const Carried& a, const Carried& b) {
  CHECK(a.mass == Approx(b.mass).epsilon(1e-14));
  CHECK(a.volume == Approx(b.volume).epsilon(1e-14));
  CHECK((a.momentum - b.momentum).norm() <= 1e-13 * b.momentum.norm());
  CHECK((a.moment - b.moment).norm() <= 1e-14 * b.moment.norm());
  CHECK(a.angular == Approx(b.angular).epsilon(1e-13));
  CHECK(a.kinetic == Approx(b.kinetic).epsilon(1e-14));
  CHECK(a.strain == Approx(b.strain).epsilon(1e-13));
}

/// Shears and turns as it flies.
const FillOptions tumbles{.per_cell = 3, .velocity = [](const std::array<double, 3>& x) {
                            return std::array<double, 3>{1 - 8 * x[1], 5 * x[0], 0};
                          }};

}  // namespace

TEST_CASE("A split keeps mass, momentum, angular momentum and energies, on triangles") {
  Scene scene{PlaneStrain{},
              SimplexMesh<2>(test::triangles({0, 0}, {1, 1}, 8, 8)),
              Numerics<LinearSimplex, Flip, Musl>{},
              bodies(fill<"sand">(Box{{0.2, 0.2}, {0.8, 0.8}}, rubber, tumbles)),
              PointIds{},
              TrackEnergy{}};
  for (int k = 0; k < 20; ++k) step(scene, 0.5 * stable_step(scene));
  const auto& body = scene.body();
  const auto before = carried(body);
  const auto residual = energies(scene).residual;
  const double ratio = mean_volume_ratio(body);
  const std::size_t points = body.points.size();
  CHECK(split_points<"sand">(scene, {.per_cell = 1}) == 0);
  const auto split = split_points<"sand">(scene, {.per_cell = 4});
  CHECK(split > points / 2);
  CHECK(body.points.size() == points + 3 * split);
  check_kept(carried(body), before);
  CHECK(energies(scene).residual == Approx(residual).margin(1e-12));
  CHECK(mean_volume_ratio(body) == Approx(ratio).epsilon(1e-14));
  for (Index c = 0; c < scene.mesh.cell_count(); ++c)
    for (const Index p : body.cells[c]) REQUIRE(body.points.cell[p] == c);
  for (int k = 0; k < 20; ++k) step(scene, 0.5 * stable_step(scene));
  CHECK(body.lost == 0);
  CHECK_THROWS_WITH(split_points(scene, {.per_cell = 0.5}),
                    "SplitOptions.per_cell = 0.5: must be at least 1");
}

namespace {

/// A block that flies out of cells of 10 cm into cells of 2.5 cm.
template <class... Parts>
auto block_into_finer_cells(const Parts&... parts) {
  std::vector<double> x;
  for (int i = 0; i <= 10; ++i) x.push_back(0.1 * i);
  for (int i = 1; i <= 40; ++i) x.push_back(1 + 0.025 * i);
  std::vector<double> y;
  for (int i = 0; i <= 10; ++i) y.push_back(0.1 * i);
  return Scene{
      PlaneStrain{},
      RectilinearGrid<2>{{.x = x, .y = y}},
      Numerics<QuadraticBSpline, Apic, Usl>{},
      bodies(fill<"block">(Box{{0.2, 0.2}, {0.7, 0.8}}, rubber, {.per_cell = 4, .velocity = {10, 0, 0}})),
      parts...,
      TrackEnergy{}};
}
/// Greatest difference of the nodes' masses inside the block from the density times a cell, over that.
template <class Scene>
double unevenness(const Scene& scene) {
  double worst = 0;
  const double whole = 1000 * 0.025 * 0.1, end = 0.7 + 10 * scene.time;
  int seen = 0;
  for (Index i = 0; i < QuadraticBSpline::node_count(scene.mesh); ++i) {
    const auto x = QuadraticBSpline::node_position(scene.mesh, i);
    if (x[0] < end - 0.4 || x[0] > end - 0.1 || x[1] < 0.4 || x[1] > 0.6) continue;
    worst = std::max(worst, std::abs(scene.fields[0].sums[i].mass() / whole - 1));
    ++seen;
  }
  REQUIRE(seen > 20);
  return worst;
}

}  // namespace

TEST_CASE("Material that flows into finer cells stays whole where its points split") {
  auto whole = block_into_finer_cells(SplitPoints<"block">{{.per_cell = 4}});
  auto thin = block_into_finer_cells();
  const double end = 0.095;  // s: inside the fine cells
  run(whole, {.end = end, .courant = 0.5});
  run(thin, {.end = end, .courant = 0.5});
  CHECK(whole.part<SplitPoints<"block">>().split == thin.body().points.size());
  CHECK(whole.body().points.size() == 4 * thin.body().points.size());
  double of_whole = 0, of_thin = 0;  // at any place of the points in the cells
  for (int k = 0; k < 20; ++k) {
    step(whole, 2e-4);
    step(thin, 2e-4);
    of_whole = std::max(of_whole, unevenness(whole));
    of_thin = std::max(of_thin, unevenness(thin));
  }
  CHECK(of_thin > 0.4);
  CHECK(of_whole < 0.05);
  // Nothing but flies on: no stress came of it.
  for (const auto& stress : {whole.body().points.stress[0], whole.body().points.stress[100]})
    for (const double s : stress.c) CHECK(std::abs(s) < 1e-6 * 1e6);
  CHECK(std::abs(energies(whole).residual) < 1e-9 * energies(whole).kinetic);
  CHECK(mass(whole.body()) == Approx(mass(thin.body())).epsilon(1e-13));
}

TEST_CASE("Splits are the same bits on any number of threads, and where a run continues") {
  const auto at_end = [](int threads) {
    set_threads(threads);
    auto scene = block_into_finer_cells(SplitPoints<"block">{{.per_cell = 4}});
    for (int k = 0; k < 150; ++k) step(scene, 4e-4);
    return scene;
  };
  const auto one = at_end(1);
  CHECK(StateBuffer::first_difference(StateBuffer(at_end(3)), StateBuffer(one)) == "");
  auto first = block_into_finer_cells(SplitPoints<"block">{{.per_cell = 4}}), second = first;
  for (int k = 0; k < 97; ++k) step(first, 4e-4);
  StateBuffer(first).restore(second);
  for (int k = 97; k < 150; ++k) step(second, 4e-4);
  CHECK(StateBuffer::first_difference(StateBuffer(second), StateBuffer(one)) == "");
  CHECK(one.part<SplitPoints<"block">>().split > 0);
}

TEST_CASE("A bar that is stretched to 2.1 parts from its wall, after a warning, unless its points split",
          "[limit]") {
  const Elasticity elasticity("NeoHookean", 1000, 1e6, 0.3);
  const double stretch = 2.1, shear = elasticity.shear(), lame = elasticity.lame();
  const double stress =
      (shear * (stretch * stretch - 1) + lame * std::log(stretch)) / stretch;  // at the wall
  std::size_t warned = 0;
  const auto before =
      on_warning([&](std::string_view text) { warned += text.find("drawn points") != text.npos; });
  const auto reaction_over_weight = [&](auto... parts) {
    Scene scene{PlaneStrain{},
                CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.2, 4}, .cell = 0.1}},
                Numerics<QuadraticBSpline, Flip, Musl>{},
                bodies(fill(Box<2>{{0., 0.}, {0.2, 1.}}, NeoHookean(elasticity), {.per_cell = 4})),
                walls(left(roller), right(roller), bottom(fixed)),
                gravity({0, stress / 1000}, Ramp{.over = 1}),
                LocalDamping{},
                Reactions{},
                parts...};
    run(scene, {.end = 1.1});
    return -reaction(scene, "bottom").force[1] / (0.2 * stress);
  };
  CHECK(reaction_over_weight() < 0.5);
  CHECK(warned == 1);
  CHECK(reaction_over_weight(SplitPoints<>{{.per_cell = 16}}) == Approx(1).margin(0.15));
  CHECK(warned == 1);
  on_warning(before);
}
