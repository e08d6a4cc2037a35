// Loads and prescribed motions against closed forms: waves in a bar, compression of a layer, and the balance
// of energy. The bar and the layer write what they computed for docs/validation.md.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>

#include "catch.hpp"
#include "joined_scenes.hpp"
#include "state_buffer.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

template <class F>
std::string message(F&& f) {
  try {
    f();
  } catch (const std::exception& e) {
    return e.what();
  }
  return "nothing thrown";
}

/// From 0 to 1 over the interval [0, 1], its first two derivatives zero at both ends.
double smooth_step(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10 - 15 * s + 6 * s * s);
}

// --- the bar: x in (0, 1) m, loaded at x = 1 m; rollers on its sides leave the axial strain alone

constexpr double load = 10;  // Pa
const LinearElastic steel{{.density = 1000, .young = 1e7, .poisson = 0.25}};
const double speed = std::sqrt(steel.wave_modulus() / steel.density());

constexpr Index cells = 200;
constexpr double h = 1.0 / cells;

const Numerics<QuadraticBSpline, Apic, Usl> apic{};
auto bar_on_grid(const auto& traction) {
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, h}, .cell = h}},
               apic,
               bodies(fill(Box{{0., 0.}, {1., h}}, steel, {.per_cell = 4})),
               walls(left(roller), bottom(roller), top(roller)),
               traction,
               TrackEnergy{}};
}
template <class... Parts>
auto on_triangles(const BoxMesh<2>& box, const LinearElastic& law, const Walls& held, const Parts&... parts) {
  return Scene{PlaneStrain{},
               SimplexMesh<2>(box_mesh<2>(box)),
               Numerics<LinearSimplex, Tpic, Usl>{},
               bodies(fill(Cells("all"), law, {.per_cell = 6})),
               held,
               parts...,
               Reactions{},
               TrackEnergy{}};
}
const BoxMesh<2> bar{{0, 0}, {1, h}, {cells, 1}};
const Walls guided = walls(left(roller), bottom(roller), top(roller));
auto bar_on_triangles(const FaceTraction& traction, VectorFunction force = {0, 0}) {
  return on_triangles(bar, steel, guided, traction, gravity({0, 0}, Ramp{.over = 1}), body_force(force));
}
template <class Region>
auto bar_on_triangles(const PointTraction<Region>& traction) {
  return on_triangles(bar, steel, guided, traction);
}
/// On the points of the last layer: half a cell, or the cells of a row.
auto on_points(double thickness, auto in_time) {
  return traction(surface(Box{{1 - thickness, 0.}, {1., 1.}}, {.normal = {1, 0}, .thickness = thickness}),
                  {-load, 0}, in_time);
}

constexpr double rise = 0.4;  // m: the smooth load takes so long over the wave speed
constexpr double end = 0.7;   // of the time in which a wave runs through

/// d'Alembert: v = -p(t - (1 - x) / c) / (rho c), sigma = -p(..), for any load in time.
struct Errors {
  double velocity = 0, stress = 0;  // of points, over those of the full load
  double inside = 0;                // of stresses more than two layers away from the load
};
template <class Scene>
Errors errors(const Scene& scene, double layer) {
  const auto& points = scene.body().points;
  Errors e;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double x = points.position[p][0], exact = smooth_step((speed * scene.time - (1 - x)) / rise);
    const double v = -points.velocity[p][0] * steel.density() * speed / load, s = -points.stress[p][0] / load;
    e.velocity = std::max(e.velocity, std::abs(v - exact));
    e.stress = std::max(e.stress, std::abs(s - exact));
    if (x < 1 - 3 * layer) e.inside = std::max(e.inside, std::abs(s - exact));
  }
  return e;
}
/// The largest error of mean stresses and velocities over sections of a tenth of the bar, a tenth away from
/// the front of a load that is there at once.
template <class Scene>
double plateau_error(const Scene& scene, const std::string& name, test::Validation& validation) {
  std::array<double, 10> v{}, s{}, n{};
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double x = points.position[p][0], stress = -points.stress[p][0] / load;
    const auto k = static_cast<std::size_t>(10 * x);
    v[k] -= points.velocity[p][0] * steel.density() * speed / load;
    s[k] += stress;
    ++n[k];
    validation.point(name, "position [m]", x, "stress over load", stress, x > 1 - end ? 1 : 0);
  }
  double worst = 0, mean_v = 0, mean_s = 0;
  for (std::size_t k = 0; k < 9; ++k) {  // front: 0.3; the last has the layer of loaded points
    if (k >= 2 && k < 4) continue;
    const double exact = k < 2 ? 0 : 1;
    worst = std::max({worst, std::abs(v[k] / n[k] - exact), std::abs(s[k] / n[k] - exact)});
    mean_v += k < 4 ? 0 : v[k] / n[k] / 5;
    mean_s += k < 4 ? 0 : s[k] / n[k] / 5;
  }
  const double impedance = steel.density() * speed;
  validation.value(name, "stress", "Pa", mean_s * load, load);
  validation.value(name, "particle velocity", "m/s", mean_v * load / impedance, load / impedance);
  return worst;
}

double smoothly(double time) { return smooth_step(speed * time / rise); }

}  // namespace

// Regions and functions are not in the type of a scene: it can be named.
static_assert(std::same_as<decltype(bar_on_grid(on_points(h, smoothly))),
                           Scene<PlaneStrain, CartesianGrid<2>, Numerics<QuadraticBSpline, Apic, Usl>,
                                 Bodies<Fill<LinearElastic>>, Walls, PointTraction<>, TrackEnergy>>);

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
  CHECK(message([] {
          Table{{0, 1}, {2, 1}, {1, 1}};
        }) == "Table.time[2] = 1: must not lie before the one above, 2");
  CHECK(message([] { Table{{0, std::nan("")}}; }) == "Table.value[0] = nan: must be finite");
  CHECK(message([] { Table{std::vector<Table::Row>{}}; }) == "Table.rows = 0: must be at least one");
  CHECK(message([] { ScalarFunction{Ramp{.to = 1}}; }) == "Ramp.over = nan: must be given, and not negative");
}

TEST_CASE("Bar: a smooth load runs through it as d'Alembert has it, for both ways of loading") {
  const auto run_to_end = [](auto scene, double layer) {
    run(scene, {.end = end / speed});
    const Energies e = energies(scene);
    CAPTURE(e.residual, e.external);
    CHECK(std::abs(e.residual) <= 2e-3 * e.external);
    // What a wave carries: half kinetic, half strain.
    CHECK(std::abs(e.kinetic / e.strain - 1) <= 0.02);
    // The impulse is on the bar: the load's, summed from the begin of each step.
    const double impulse = load * h * (end - rise / 2) / speed;
    CHECK(std::abs(-momentum(scene.body())[0] - impulse) <= load * h * scene.time_step);
    return errors(scene, layer);
  };
  const auto face = traction(right(), {-load, 0}, smoothly);
  const auto check = [](const Errors& e, double at_load) {
    CAPTURE(e.velocity, e.stress, e.inside);
    CHECK(e.velocity <= 0.01);
    CHECK(e.inside <= 0.01);
    CHECK(e.stress <= at_load);
  };
  check(run_to_end(bar_on_grid(face), 2 * h), 0.01);
  check(run_to_end(bar_on_triangles(face), 2 * h), 0.01);
  // The points of the layer itself bear from none of the load to all of it.
  check(run_to_end(bar_on_grid(on_points(h / 2, smoothly)), 2 * h), 0.7);
  check(run_to_end(bar_on_triangles(on_points(h, smoothly)), 2 * h), 0.7);
}

TEST_CASE("Bar: a load that is there at once sends a front at c, with stress p and velocity p / (rho c)") {
  const auto face = traction(right(), {-load, 0}, [](double) { return 1.0; });
  test::Validation validation("stepped_bar");
  const auto worst = [&](auto scene, const std::string& name) {
    run(scene, {.end = end / speed});
    return plateau_error(scene, name, validation);
  };
  const auto at_once = [](double) { return 1.0; };
  CHECK(worst(bar_on_grid(face), "B-splines; load on the face") <= 0.01);
  CHECK(worst(bar_on_grid(on_points(h / 2, at_once)), "B-splines; load on points") <= 0.01);
  CHECK(worst(bar_on_triangles(face), "triangles; load on the face") <= 0.01);
  CHECK(worst(bar_on_triangles(on_points(h, at_once)), "triangles; load on points") <= 0.01);
}

// --- oedometer: a layer under 100 kPa; sigma_h = nu / (1 - nu) sigma_v

namespace {

const LinearElastic soil{{.density = 2000, .young = 10_MPa, .poisson = 0.2}};
const Walls in_a_ring = walls(left(roller), right(roller), bottom(roller));
constexpr double pressed = 100e3, high = 0.5;
const double period = 4 * high / std::sqrt(soil.wave_modulus() / soil.density());
double slowly(double time) { return smooth_step(time / (8 * period)); }

/// The nodes at the top lead the mesh: their mean velocity.
struct LedByTop {
  template <class Scene, class T>
  T travel(const Scene& scene, int axis, T before, T dt) const {
    T momentum = 0, mass = 0;
    for (const Index i : scene.mesh.node_set("top")) {
      momentum += scene.fields[0].mass[i] * scene.fields[0].velocity[i][axis];
      mass += scene.fields[0].mass[i];
    }
    return before + dt * momentum / mass;
  }
};

/// Means over the points in the lower half, Pa, and the relative compression of the layer there.
template <class Scene>
void check_layer(const Scene& scene, double tolerance, const std::string& name,
                 test::Validation& validation) {
  const auto& points = scene.body().points;
  Sym<double, 2> mean{};
  double n = 0, spread = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points.position[p][1] > high / 2) continue;
    mean += points.stress[p];
    ++n;
  }
  for (std::size_t k = 0; k < 4; ++k) mean[k] /= n;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points.position[p][1] <= high / 2)
      spread = std::max(spread, std::abs(points.stress[p][1] / mean[1] - 1));
  const double k0 = 0.2 / 0.8, strain = pressed / soil.wave_modulus();
  double volume = 0, now = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points.position[p][1] > high / 2) continue;
    now += points.volume[p];
    volume += points.mass[p] / soil.density();
  }
  const double measured = -std::log(now / volume);
  CAPTURE(name, mean[0], mean[1], mean[2], measured, spread);
  CHECK(std::abs(mean[1] / -pressed - 1) <= tolerance);
  CHECK(std::abs(mean[0] / (-k0 * pressed) - 1) <= tolerance);
  CHECK(std::abs(mean[2] / (-k0 * pressed) - 1) <= tolerance);
  CHECK(std::abs(strain - 9.0e-3) <= 1e-12);
  CHECK(std::abs(measured / strain - 1) <= tolerance);
  CHECK(spread <= tolerance);
  validation.value(name, "lateral stress", "kPa", -mean[0] / 1e3, k0 * pressed / 1e3);
  validation.value(name, "vertical stress", "kPa", -mean[1] / 1e3, pressed / 1e3);
  validation.value(name, "stress out of plane", "kPa", -mean[2] / 1e3, k0 * pressed / 1e3);
  validation.value(name, "axial strain", "-", measured, strain);
}

}  // namespace

TEST_CASE("Oedometer by traction: 100 kPa on E = 10 MPa, nu = 0.2 give (25, 100, 25) kPa and 0.9 %") {
  auto triangles = on_triangles({{0, 0}, {0.1, high}, {1, 5}}, soil, in_a_ring,
                                pressure(on("top"), [](double t) { return pressed * slowly(t); }),
                                MovingMesh<LedByTop>{.fixed_below = 0, .moving_from = high});
  run(triangles, {.end = 9 * period});
  test::Validation validation("oedometer");
  check_layer(triangles, 2e-3, "triangles that move with the layer; load on the face", validation);
  // The floor bears it, the walls the lateral stress; work is in the strain.
  const double width = 0.1;
  const Vec<double, 2> floor = reaction(triangles, "bottom").force, wall = reaction(triangles, "left").force;
  CAPTURE(floor, wall);
  CHECK(std::abs(floor[1] / (pressed * width) - 1) <= 0.01);
  const double height = high * std::exp(-9e-3);
  CHECK(std::abs(wall[0] / (pressed / 4 * height) - 1) <= 0.01);
  const Energies e = energies(triangles);
  CAPTURE(e.external, e.strain, e.kinetic, e.residual);
  // Work of the load p(e) = M e on a layer of the height h exp(-e).
  const double m = soil.wave_modulus(), eps = 9e-3,
               work = width * high * m * (1 - (1 + eps) * std::exp(-eps));
  CHECK(std::abs(e.external / work - 1) <= 2e-3);
  CHECK(std::abs(e.residual) <= 2e-3 * e.external);

  const double cell = 0.05;
  Scene grid{
      PlaneStrain{},
      CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.1, high + 2 * cell}, .cell = cell}},
      apic,
      bodies(fill(Box{{0., 0.}, {0.1, high}}, soil, {.per_cell = 4})),
      in_a_ring,
      pressure(surface(Box{{0., high - cell / 2}, {0.1, high}}, {.normal = {0, 1}, .thickness = cell / 2}),
               [](double t) { return pressed * slowly(t); }),
      TrackEnergy{}};
  run(grid, {.end = 9 * period});
  check_layer(grid, 5e-3, "B-splines; load on points", validation);
}

// --- other loads

TEST_CASE("A ramp of gravity loads a column to rho g (h - y), and its work is the fall of the weight") {
  const double g = 9.81;
  auto scene = on_triangles({{0, 0}, {0.1, high}, {1, 10}}, soil, in_a_ring, traction(top(), {0, 0}),
                            gravity({0, -g}, slowly), body_force({0, 0}));
  run(scene, {.end = 9 * period});
  const auto& points = scene.body().points;
  double worst = 0;
  const double bottom_stress = soil.density() * g * high;
  for (std::size_t p = 0; p < points.size(); ++p)
    worst =
        std::max(worst, std::abs(-points.stress[p][1] / bottom_stress - (1 - points.position[p][1] / high)));
  CHECK(worst <= 0.05 + 0.002);  // the stress of a cell is that of its middle, half a cell off: 1 / 20
  // The floor bears the weight. Its impulse is the time integral of that, to round-off, less the momentum.
  const auto floor = reaction(scene, "bottom");
  const double weight = mass(scene.body()) * g;
  CHECK(std::abs(floor.force[1] / weight - 1) <= 2e-3);
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
  check(bar_on_grid(traction(right(), {-load, 0})));
  check(bar_on_grid(on_points(h / 2, [](double) { return 1.0; })));
  check(bar_on_triangles(traction(right(), {-load, 0}), force));
}

TEST_CASE("Areas of loaded points turn and stretch with the matter") {
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

TEST_CASE("Same bits with every kind of load on 1, 2 and 3 threads; a state restored goes on with the same") {
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
  CHECK(message([] { traction(top(), {0, std::nan("")}); }) == "component 1 = nan: must be finite");
  CHECK(message([] {
          gravity({0, -9.81}, [](const Triple&, double) { return 1.0; });
        }) == "gravity: factor = f(x, t): must be a function of time alone; use body_force");
  const auto make = [](const auto& part) { return bar_on_grid(part); };
  CHECK(message([&] {
          make(traction(front(), {0, 0, 1}));
        }) == "MeshFaces.axis = 2: must be an axis of the scene");
  CHECK(message([&] {
          make(traction(on("crown"), {0, 1}));
        }) == "MeshFaces.set = crown: a Cartesian grid has no node sets; use sides or where(test)");
  CHECK(message([&] {
          make(traction(where([](const Triple&) { return false; }), {0, 1}));
        }) == "traction on where: faces = 0: must be at least one face of the mesh's hull");
  const auto on = [&](Box<2> box, double thickness, std::initializer_list<double> normal) {
    return message([&] {
      make(traction(surface(box, {.normal = VectorFunction(normal), .thickness = thickness}), {0, 1}));
    });
  };
  CHECK(on({{0, 0}, {1, 1}}, std::nan(""), {0, 1}) ==
        "SurfaceOptions.thickness = nan: must be given, and positive");
  CHECK(on({{0, 0}, {1, 1}}, 0.1, {0, 0}) == "SurfaceOptions.normal = (0, 0): must be given");
  CHECK(on({{1.5, 0}, {2, 1}}, 0.1, {0, 1}) ==
        "traction on the surface of a body: points = 0: must be at least one point of the body");
  const auto at_run_time = [&](auto part) {
    return message([&] {
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
        })) == joined_text("t = 1e-05 s: pressure on right at (1, ", h / 4, ") m = nan: must be finite"));
  CHECK(message([&] {
          BoundGravityInTime<double, 2>{gravity({0, -1}, breaks).g}.acceleration(2);
        }) == "t = 2 s: gravity = (nan, nan): must be finite");
}

namespace {

/// What a scene, or all portions together, come to.
struct Sums {
  Vec<double, 2> momentum = {0, 0}, wall = {0, 0};
  double external = 0, residual = 0;
};
template <class Scene, class Others = const Alone>
Sums sums(const Scene& scene, Others& others = no_others) {
  Sums all;
  all.momentum = momentum(scene.body());
  sum_over(others, all.momentum);
  all.wall = reaction(scene, "left", others).impulse;
  const Energies e = energies(scene, others);
  all.external = e.external;
  all.residual = e.residual;
  return all;
}

}  // namespace

TEST_CASE("Portions of a mesh bear every kind of load as the whole does") {
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
  using Part = decltype(loaded(SimplexMesh<2>(data), numerics, MeshPortion<2>{}));
  std::vector<Part> scenes;
  std::vector<MeshPortion<2>> portions;
  for (int k = 0; k < 2; ++k) {
    auto [mesh, portion] = split_mesh(data, owner, k);
    portions.push_back(portion);
    scenes.push_back(loaded(SimplexMesh<2>(mesh), numerics, portion));
  }
  test::Table<Part> table(portions);
  std::array<Sums, 2> found;
  std::array<std::string, 2> thrown;
  std::vector<std::thread> threads;
  for (std::size_t s = 0; s < 2; ++s)
    threads.emplace_back([&, s] {
      test::Joined<Part> others(table, s);
      try {
        for (int k = 0; k < steps; ++k) step(scenes[s], dt, others);
        found[s] = sums(scenes[s], others);
      } catch (const std::exception& e) {
        others.fail(e.what());
        thrown[s] = e.what();
      }
    });
  for (auto& thread : threads) thread.join();
  for (std::size_t s = 0; s < 2; ++s) {
    CAPTURE(s, thrown[s], expected.external, found[s].external);
    CHECK(thrown[s] == "");
    CHECK((found[s].momentum - expected.momentum).norm() <= 1e-11 * expected.momentum.norm());
    CHECK((found[s].wall - expected.wall).norm() <= 1e-11 * expected.wall.norm());
    CHECK(std::abs(found[s].external / expected.external - 1) <= 1e-11);
    CHECK(std::abs(found[s].residual - expected.residual) <= 1e-11 * expected.external);
  }
}
