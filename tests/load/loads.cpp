// Loads and prescribed motions against closed forms: waves in a bar, compression of a layer, and the balance
// of energy. The bar and the layer write what they computed for docs/validation.md.
#include "catch.hpp"
#include "loaded_bar.hpp"
#include "validation.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

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

TEST_CASE("Bar: a smooth load runs through it as d'Alembert has it, for both ways of loading") {
  const auto run_to_end = [](auto scene, double layer) {
    run(scene, {.end = end / speed});
    const Energies e = energies(scene);
    CAPTURE(e.residual, e.external);
    CHECK(std::abs(e.residual) <= 2e-3 * e.external);
    // Energy of a wave: half kinetic, half strain.
    CHECK(std::abs(e.kinetic / e.strain - 1) <= 0.02);
    // The impulse is on the bar: the load's, summed from the start of each step.
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
  // The points of the layer itself carry from none of the load to all of it.
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
  // The floor carries it, the walls the lateral stress; the work is in the strain.
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
  // The floor carries the weight. Its impulse is the time integral of that minus the momentum, to round-off.
  const auto floor = reaction(scene, "bottom");
  const double weight = mass(scene.body()) * g;
  CHECK(std::abs(floor.force[1] / weight - 1) <= 2e-3);
}
