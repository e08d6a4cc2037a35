// Loads as parts of scenes: their work, the same bits on threads and after a restored state, portions of a
// mesh, and what is refused. Functions of time.
#include <arenite/tiles.hpp>

#include "catch.hpp"
#include "loaded_bar.hpp"
#include "message.hpp"
#include "state_buffer.hpp"

using namespace arenite;
using test::bar_on_grid, test::bar_on_triangles, test::h, test::on_points;

TEST_CASE("A table of time is linear between its rows and constant outside; a ramp is one of two") {
  const Table table{{1, 2}, {2, 4}, {2, 10}, {4, 0}};
  CHECK(table(0) == 2);
  CHECK(table(1.5) == 3);
  CHECK(table(2) == 10);
  CHECK(table(3) == 5);
  CHECK(table(9) == 0);
  const Ramp ramp{.to = 6, .over = 2, .from = 2, .start = 1};
  CHECK(ramp(0) == 2);
  CHECK(ramp(2) == 4);
  CHECK(ramp(3) == 6);
  CHECK(Ramp{.to = 3, .over = 0}(0) == 3);
  CHECK(test::message<std::exception>([] {
          Table{{0, 1}, {2, 1}, {1, 1}};
        }) == "Table.time[2] = 1: must not lie before the one above, 2");
  CHECK(test::message<std::exception>([] {
          Table{{0, std::nan("")}};
        }) == "Table.value[0] = nan: must be finite");
  CHECK(test::message<std::exception>([] { Table{std::vector<Table::Row>{}}; }) ==
        "Table.rows = 0: must be at least one");
  CHECK(test::message<std::exception>([] { ScalarFunction{Ramp{.to = 1}}; }) ==
        "Ramp.over = nan: must be given, and not negative");
}

namespace {

const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
Triple swirl(const Triple& x, double time) { return {-x[1], x[0] * std::cos(30 * time), 0}; }

/// A block with every kind of load.
template <class M, class N, class... More>
auto loaded(M mesh, N numerics, const More&... more) {
  return Scene{PlaneStrain{},
               std::move(mesh),
               numerics,
               bodies(fill<"block">(Box{{0., 0.}, {1., 0.8}}, rubber, {.per_cell = 4})),
               walls(bottom(roller)),
               driven(left(roller), {1, 0}, Ramp{.to = 0.05, .over = 0.01}),
               traction(surface("block", Box{{0., 0.75}, {1., 0.8}}, {.normal = {0, 1}, .thickness = 0.05}),
                        {0, -4e3}, Table{{0, 0.5}, {0.01, 1}}),
               pressure(bottom(), [](const Triple& x, double) { return 1e3 * x[0]; }),
               body_force(swirl),
               point_load("block", {0.5, 0.4}, {300, 100}),
               gravity({0, -9.81}, Ramp{.over = 0.02}),
               absorbing(right(), {.support = Support::first_reaction}),
               Reactions{},
               TrackEnergy{},
               more...};
}
CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {2, 1}, .cell = 0.05}}; }
MeshData<2> triangles() { return box_mesh<2>({{0, 0}, {1, 1}, {20, 20}}); }
auto on_grid() { return loaded(grid(), Numerics<QuadraticBSpline, Apic, Usl>{}); }

template <class Make>
void check_threads(Make&& make) {
  const int before = threads();
  const auto state = [&](int n) {
    set_threads(n);
    auto scene = make();
    for (int k = 0; k < 20; ++k) step(scene, 0.4 * stable_step(scene));
    return test::StateBuffer(scene);
  };
  const auto one = state(1);
  for (const int n : {2, 3}) CHECK(test::StateBuffer::first_difference(state(n), one) == "");
  set_threads(before);
}

}  // namespace

TEST_CASE("Work of loads is what the nodes gain in kinetic energy, to round-off") {
  const auto check = [](auto scene) {
    scene.body().points.velocity.fill({3e-6, 0});
    step(scene, 1e-5);  // without stresses; the wall stops nodes far from the loads
    double gained = 0;
    const auto& f = scene.fields[0];
    for (Index i = 0; i < f.size(); ++i)
      if (decltype(scene)::Shape::node_position(scene.mesh, i)[0] > 0.25)
        gained += f.mass[i] * (f.velocity[i].squaredNorm() - f.start[i].squaredNorm()) / 2;
    CHECK(std::abs(energies(scene).external - gained) <= 1e-12 * std::abs(gained));
    CHECK(gained > 0);
  };
  const auto force = [](const Triple& x, double) { return Triple{x[0] > 0.5 ? -x[0] : 0, 0, 0}; };
  check(bar_on_grid(traction(right(), {-test::load, 0})));
  check(bar_on_grid(on_points(h / 2, [](double) { return 1.0; })));
  check(bar_on_triangles(traction(right(), {-test::load, 0}), force));
}

TEST_CASE("Areas of loaded points turn and stretch with the material") {
  // A disc of points turns by an angle and is stretched: Nanson's a = J F^-T A, integrated step by step.
  const LoadedArea<double, 2> of{
      .body = "", .region = {}, .options = {}, .load = SurfaceLoad(ScalarFunction(0)), .text = ""};
  Vec<double, 2> area(3, 4);
  const Mat<double, 2> gradient = (Mat<double, 2>() << 0.3, -2, 2, 0.3).finished();
  const double dt = 1e-6;
  for (int k = 0; k < 1000000; ++k) area = of.follow(area, gradient, 0, dt);
  const double stretch = std::exp(0.3), angle = 2;  // J F^-T = stretch R
  const Vec<double, 2> exact(stretch * (3 * std::cos(angle) - 4 * std::sin(angle)),
                             stretch * (3 * std::sin(angle) + 4 * std::cos(angle)));
  CHECK((area - exact).norm() <= 1e-4);
}

TEST_CASE(
    "Same bits with every kind of load on 1, 2 and 3 threads; a state restored continues with the same") {
  check_threads(on_grid);
  auto a = on_grid(), b = on_grid();
  for (int k = 0; k < 10; ++k) step(a, 2e-4);
  const test::StateBuffer saved(a);
  saved.restore(b);
  for (int k = 0; k < 10; ++k) {
    step(a, 2e-4);
    step(b, 2e-4);
  }
  CHECK(test::StateBuffer::first_difference(test::StateBuffer(a), test::StateBuffer(b)) == "");
  CHECK(energies(a).external == energies(b).external);
  CHECK(reaction(a, "left").impulse == reaction(b, "left").impulse);
  CHECK(std::abs(energies(a).external) > 0.1);
}

TEST_CASE("Bad loads name value and rule, when the scene is made or at run time") {
  CHECK(test::message<std::exception>([] {
          traction(top(), {0, std::nan("")});
        }) == "component 1 = nan: must be finite");
  CHECK(test::message<std::exception>([] {
          gravity({0, -9.81}, [](const Triple&, double) { return 1.0; });
        }) == "gravity: factor = f(x, t): must be a function of time alone; use body_force");
  const auto make = [](const auto& part) { return bar_on_grid(part); };
  CHECK(test::message<std::exception>([&] {
          make(traction(front(), {0, 0, 1}));
        }) == "MeshFaces.axis = 2: must be an axis of the scene");
  CHECK(test::message<std::exception>([&] {
          make(traction(on("crown"), {0, 1}));
        }) == "MeshFaces.set = crown: a Cartesian grid has no node sets; use sides or where(test)");
  CHECK(test::message<std::exception>([&] {
          make(traction(where([](const Triple&) { return false; }), {0, 1}));
        }) == "traction on where: faces = 0: must be at least one face of the mesh's hull");
  const auto on = [&](Box<2> box, double thickness, std::initializer_list<double> normal) {
    return test::message<std::exception>([&] {
      make(traction(surface(box, {.normal = VectorFunction(normal), .thickness = thickness}), {0, 1}));
    });
  };
  CHECK(on({{0, 0}, {1, 1}}, std::nan(""), {0, 1}) ==
        "SurfaceOptions.thickness = nan: must be given, and positive");
  CHECK(on({{0, 0}, {1, 1}}, 0.1, {0, 0}) == "SurfaceOptions.normal = (0, 0): must be given");
  CHECK(on({{1.5, 0}, {2, 1}}, 0.1, {0, 1}) ==
        "traction on the surface of a body: points = 0: must be at least one point of the body");
  const auto at_run_time = [&](auto part) {
    return test::message<std::exception>([&] {
      auto scene = make(part);
      step(scene, 1e-5);
      step(scene, 1e-5);
    });
  };
  const auto breaks = [](double t) { return t > 0 ? std::nan("") : 1.0; };
  CHECK(at_run_time(traction(bottom(), {0, 1}, breaks)) ==
        "t = 1e-05 s: traction on bottom = (nan, nan): must be finite");
  CHECK(at_run_time(pressure(right(), [](const Triple& x, double t) {
          return t > 0 && x[1] < h / 2 ? std::nan("") : 1.0;
        })) == joined_text({"t = 1e-05 s: pressure on right at (1, ", h / 4, ") m = nan: must be finite"}));
  CHECK(test::message<std::exception>([&] {
          BoundGravityInTime<double, 2>{gravity({0, -1}, breaks).g}.acceleration(2);
        }) == "t = 2 s: gravity = (nan, nan): must be finite");
}

namespace {

/// Sums over a scene, or over all portions together.
struct Sums {
  Vec<double, 2> momentum = {0, 0}, wall = {0, 0};
  double external = 0, residual = 0;
};
template <class Scene>
Sums sums(const Scene& scene) {
  Sums all;
  all.momentum = momentum(scene.body());
  sum_over(scene.communicator(), all.momentum);
  all.wall = reaction(scene, "left").impulse;
  const Energies e = energies(scene);
  all.external = e.external;
  all.residual = e.residual;
  return all;
}

}  // namespace

TEST_CASE("Portions of a mesh carry every kind of load as the whole does") {
  const auto data = triangles();
  const Numerics<LinearSimplex, Flip, Musl> numerics{};
  auto whole = loaded(SimplexMesh<2>(data), numerics);
  const double dt = 0.3 * stable_step(whole);
  constexpr int steps = 100;
  for (int k = 0; k < steps; ++k) step(whole, dt);
  const Sums expected = sums(whole);

  std::vector<int> owner;  // two halves, cut across surface, walls and the point load's cell
  for (const auto& cell : data.cells) {
    double x = 0;
    for (const Index i : cell) x += data.nodes[i][0] / 3;
    owner.push_back(x < 0.5 ? 0 : 1);
  }
  OneRank here;
  auto tiled = distribute(here, data, {.tile = owner},
                          [&](auto mesh, auto portion) { return loaded(mesh, numerics, portion); });
  std::array<Sums, 2> found;
  tiled.together([&](auto& scene) {
    for (int k = 0; k < steps; ++k) step(scene, dt);
    found[static_cast<std::size_t>(scene.portion().number)] = sums(scene);
  });
  for (std::size_t s = 0; s < 2; ++s) {
    CAPTURE(s, expected.external, found[s].external);
    CHECK((found[s].momentum - expected.momentum).norm() <= 1e-11 * expected.momentum.norm());
    CHECK((found[s].wall - expected.wall).norm() <= 1e-11 * expected.wall.norm());
    CHECK(std::abs(found[s].external / expected.external - 1) <= 1e-11);
    CHECK(std::abs(found[s].residual - expected.residual) <= 1e-11 * expected.external);
  }
}
