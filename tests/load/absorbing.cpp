// Absorbing faces: the reflection of plane waves, the support of a weight, and refused options.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>

#include "catch.hpp"
#include "message.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

const LinearElastic rock{{.density = 2000, .young = 1e8, .poisson = 0.25}};
constexpr Index cells = 100;
constexpr double h = 1.0 / cells;

/// A bar of 1 m along y, two cells wide, between walls that leave it one component of the motion.
template <class K, class M, class N>
auto bar(K kinematics, M mesh, N numerics, const Condition& sides, const AbsorbingOptions& options,
         double g = 0) {
  constexpr int D = M::dimension;
  std::vector<Wall> held{left(sides), right(sides)};
  if constexpr (D == 3) held.insert(held.end(), {front(sides), back(sides)});
  FillOptions of_points{.per_cell = is_simplex_mesh<M> ? 3 : 1 << D};
  if (g > 0) of_points.stress = Geostatic{.surface = 1, .k0 = 1.0 / 3};
  Box<D> all;
  all.upper.fill(std::numeric_limits<double>::infinity());
  all.lower.fill(-all.upper[0]);
  return Scene{kinematics,
               std::move(mesh),
               numerics,
               bodies(fill(all, rock, of_points)),
               Walls{held},
               absorbing(bottom(), options),
               gravity(Triple{0, -g, 0}),
               Reactions{},
               TrackEnergy{}};
}
const double speed_p = std::sqrt(rock.wave_modulus() / rock.density()),
             speed_s = std::sqrt(rock.elasticity().shear() / rock.density());

/// Sends a plane wave of one smooth swing, `length` long, down the bar.
template <class Scene>
void send(Scene& scene, double length, bool shear) {
  auto& points = scene.body().points;
  const double c = shear ? speed_s : speed_p;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double s = (points.position[p][1] - 0.5) / length + 0.5;
    if (s < 0 || s > 1) continue;
    const double v = 1e-3 * (1 - std::cos(2 * pi * s)) / 2, stress = rock.density() * c * v;
    auto velocity = points.velocity[p];
    velocity[shear ? 0 : 1] += v;
    points.velocity.set(p, velocity);
    auto tensor = points.stress[p];
    tensor[shear ? 3 : 1] += stress;
    if (!shear) tensor[0] += stress / 3, tensor[2] += stress / 3;  // nu / (1 - nu)
    points.stress.set(p, tensor);
  }
}
double energy(const auto& scene) { return kinetic_energy(scene.body()) + strain_energy(scene.body()); }

/// Reflected energy of a wave over that which a free end reflects.
template <class Make>
double reflected(Make&& make, double length, bool shear) {
  const Condition sides = shear ? free_along(0) : roller;
  auto absorbs = make(sides, AbsorbingOptions{}),
       free = make(sides, AbsorbingOptions{.pressure_wave = 0, .shear_wave = 0});
  double sent = 0;
  for (auto* scene : {&absorbs, &free}) {
    send(*scene, length, shear);
    sent = energy(*scene);
    run(*scene, {.end = 0.9 / (shear ? speed_s : speed_p), .courant = 0.5});
  }
  CHECK(energy(free) > 0.5 * sent);  // the rest is the loss of the transfer
  // The dashpots absorb the energy that the free end would reflect, except for the loss of the transfer.
  CHECK(energies(absorbs).contact > 0.7 * sent);
  // Within the half of a step that lies between velocities and stresses.
  CHECK(energies(absorbs).contact + energy(absorbs) <= 1.02 * sent);
  CHECK(energies(free).contact == 0);
  return energy(absorbs) / energy(free);
}

CartesianGrid<2> flat_grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {2 * h, 1}, .cell = h}}; }
SimplexMesh<2> triangles(double from = 0) {
  return SimplexMesh<2>(box_mesh<2>({{from, 0}, {from + 2 * h, 1}, {2, cells}}));
}
auto on_grid(const Condition& sides, const AbsorbingOptions& options, double g = 0) {
  return bar(PlaneStrain{}, flat_grid(), Numerics<QuadraticBSpline, Apic, Usl>{}, sides, options, g);
}

}  // namespace

TEST_CASE("Of plane waves at a right angle a thousandth of the energy comes back, from 20 cells a wave on",
          "[heavy]") {
  test::Validation validation("absorbing");
  const auto check = [&](const char* name, auto&& make, std::vector<double> lengths, bool with_shear = true) {
    for (const bool shear : {false, true}) {
      if (shear && !with_shear) continue;
      for (const double length : lengths) {
        const double share = reflected(make, length, shear);
        INFO(name << (shear ? ", S, " : ", P, ") << length / h << " cells");
        CHECK(share <= (length < 0.2 ? 0.04 : 0.002));  // shorter waves also disperse on the way
        validation.value(joined_text({name, shear ? "; S" : "; P"}),
                         joined_text({"energy reflected of a wave of ", length / h, " cells"}), "-", share,
                         0);
      }
    }
  };
  check("B-splines; APIC; USL", [](auto... a) { return on_grid(a...); }, {0.1, 0.2, 0.4});
  check("triangles; FLIP; MUSL",
        [](auto... a) { return bar(PlaneStrain{}, triangles(), Numerics<LinearSimplex>{}, a...); },
        {0.1, 0.2, 0.4});
  check(
      "triangles; axisymmetric; TPIC; USL",
      [](auto... a) {
        return bar(Axisymmetric{}, triangles(0.5), Numerics<LinearSimplex, Tpic, Usl>{}, a...);
      },
      {0.2}, false);
  check("B-splines; space; FLIP; MUSL",
        [](auto... a) {
          return bar(ThreeDimensional{},
                     CartesianGrid<3>{{.lower = {0, 0, 0}, .upper = {2 * h, 1, 2 * h}, .cell = h}},
                     Numerics<QuadraticBSpline, Flip, Musl>{}, a...);
        },
        {0.2});
}

TEST_CASE("Under gravity a supported boundary stays and absorbs; without support it sinks at g H / c",
          "[heavy]") {
  const double g = 10;
  auto sinks = on_grid(roller, {}, g);
  run(sinks, {.end = 8 / speed_p, .courant = 0.5});
  const double terminal = momentum(sinks.body())[1] / mass(sinks.body());
  CHECK(std::abs(terminal / (-g / speed_p) - 1) <= 0.02);  // weight over impedance: rho g H / (rho c)

  auto holds = on_grid(roller, {.support = Support::first_reaction}, g);
  run(holds, {.end = 8 / speed_p, .courant = 0.5});
  const double weight = mass(holds.body()) * g;
  CHECK(std::abs(momentum(holds.body())[1] / mass(holds.body())) <= 1e-3 * -terminal);
  CHECK(std::abs(reaction(holds, "bottom").force[1] / weight - 1) <= 1e-3);
  const double at_rest = energy(holds);
  send(holds, 0.2, false);
  const double sent = kinetic_energy(holds.body());
  run(holds, {.end = 9 / speed_p, .courant = 0.5});
  CHECK(kinetic_energy(holds.body()) <= 0.02 * sent);
  CHECK(std::abs(energy(holds) / at_rest - 1) <= 0.02);
  CHECK(std::abs(energies(holds).residual) <= 1e-3 * at_rest);
}

TEST_CASE("Absorbing faces: dashpots of light nodes stay stable, bad options name value and rule") {
  // One step for mass, one hundred thousand times too long for the dashpot: the velocity dies, and does not
  // change its sign.
  for (const double z : {1e-3, 1.0, 1e5}) {
    const Vec<double, 2> v = dashpot_velocity<double, 2>({1, 0}, {1, 0}, z * Mat<double, 2>::Identity());
    CHECK(v[0] >= 0);
    CHECK(std::abs(v[0] - std::exp(-z)) <= 0.05);
    // A force of z for each unit of time drives it to the velocity 1.
    const Vec<double, 2> driven =
        dashpot_velocity<double, 2>({1, 0}, {1 + z, 0}, z * Mat<double, 2>::Identity());
    CHECK(std::abs(driven[0] - 1) <= 1e-9);
  }
  const auto message = [](const AbsorbingOptions& options) {
    return test::message([&] { on_grid(roller, options); });
  };
  CHECK(message({.density = -1}) == "absorbing(bottom).density = -1: must not be negative");
  CHECK(message({.shear_wave = -5}) == "absorbing(bottom).shear_wave = -5: must not be negative");
}
