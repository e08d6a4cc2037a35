// A state that was saved and restored in a new scene continues with the same bits, for each family of
// compositions.
#include <arenite/arenite.hpp>
#include <arenite/run/progress.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "state_buffer.hpp"

using namespace arenite;
using test::StateBuffer;

namespace {

LinearElastic rubber() { return LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.3}}; }
template <class Separation>
auto sand(double dilatancy = 0) {
  return MohrCoulomb<Separation>{
      {.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg, .dilatancy = dilatancy}};
}

/// Steps a scene of `make()`, and another one into which its state was put halfway: both must end with the
/// same state. Returns that of the middle.
template <class Make>
StateBuffer check(Make&& make, int before, int after) {
  const int threads_before = threads();
  StateBuffer middle;
  for (const int n : {1, 3}) {
    CAPTURE(n);
    set_threads(n);
    const auto steps = [](auto& scene, int count, auto&... observers) {
      for (int k = 0; k < count; ++k) {
        step(scene, 0.4 * stable_step(scene));
        (observers(std::as_const(scene)), ...);
      }
    };
    int called = 0, called_again = 0;
    auto whole = make();
    Watch watch({.lost = 1, .every = 7});
    auto now_and_then = every(1e-3, [&](const auto&) { ++called; });
    steps(whole, before, watch, now_and_then);
    middle = StateBuffer(whole, watch, now_and_then);
    called = 0;
    steps(whole, after, watch, now_and_then);
    auto restored = make();
    Watch watch_again({.lost = 1, .every = 7});
    auto again = every(1e-3, [&](const auto&) { ++called_again; });
    middle.restore(restored, watch_again, again);
    CHECK(StateBuffer::first_difference(StateBuffer(restored, watch_again, again), middle) == "");
    steps(restored, after, watch_again, again);
    CHECK(StateBuffer::first_difference(StateBuffer(restored, watch_again, again),
                                        StateBuffer(whole, watch, now_and_then)) == "");
    CHECK(called == called_again);
    std::size_t field = 0;
    for (const auto& f : restored.fields) CHECK(f.velocity == whole.fields[field++].velocity);
  }
  set_threads(threads_before);
  return middle;
}

CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {2, 1}, .cell = 0.04}}; }

/// Slows nodes down by their velocity of the step before.
struct Dashpot {
  double rate;
  template <class Scene>
  void add_force(Scene& scene, double) {
    for (auto& field : scene.fields)
      for (std::size_t i = 0; i < field.size(); ++i)
        field.sums[i].add_force(-rate * field.mass[i] * field.velocity[i]);
  }
};

}  // namespace

TEST_CASE(
    "Restored: triangles, FLIP, MUSL, both averages, a law that remembers, a moving mesh, a rigid body") {
  const auto middle = check(
      [] {
        auto data = test::triangles({0, 0}, {1, 1}, 30, 30);
        test::name_region(data, "block", [](const auto& x) { return x[0] < 0.3 && x[1] > 0.5; });
        test::name_region(data, "soil", [](const auto& x) { return x[1] < 0.5; });
        return Scene{Axisymmetric{},
                     SimplexMesh<2>(data),
                     Numerics<LinearSimplex, Flip, Musl, NodalAndElementAverage>{},
                     bodies(fill<"sand">(Cells("soil"), sand<RemembersOpening>(15_deg),
                                         {.per_cell = 3, .stress = Geostatic{.surface = 0.5, .k0 = 0.5}})),
                     walls(on("bottom", fixed), on("right", symmetry({1, 0, 0}))),
                     gravity({0, -9.81}),
                     rigids(rigid<"cone">(MeshSurface{"block"}, Guided{.mass = 100, .velocity = -5},
                                          Friction(20_deg))),
                     MovingMesh<>{.fixed_below = 0.1, .moving_from = 0.5},
                     TrackEnergy{}};
      },
      57, 40);
  for (const char* name :
       {"time", "steps", "bodies/sand/lost", "bodies/sand/points/position/y", "bodies/sand/points/stress/xx",
        "bodies/sand/points/history/opening", "bodies/sand/points/dilation", "bodies/sand/cells/unsorted",
        "rigids/cone/displacement", "mesh_motion/travel", "energy/stress_work"}) {
    CAPTURE(name);
    CHECK(middle.has(name));
  }
  CHECK(!middle.has("nodes/mass"));
  CHECK(middle.size("bodies/sand/cells/unsorted") > 0);
}

TEST_CASE("Restored: B-splines, APIC, MUSL, two bodies in contact and a rigid one; points get lost") {
  const auto middle = check(
      [] {
        return Scene{
            PlaneStrain{},
            grid(),
            Numerics<QuadraticBSpline, Apic>{},
            bodies(
                fill<"above">(Box{{1.6, 0.52}, {2., 0.8}}, rubber(), {.per_cell = 4, .velocity = {4, -3, 0}}),
                fill(Box{{0., 0.}, {2., 0.52}}, rubber())),
            walls(bottom(fixed)),
            gravity({0, -9.81}),
            Coulomb{Friction(10_deg)},
            rigids(
                rigid(DistanceSurface{[](const auto& x) { return std::hypot(x[0] - 0.5, x[1] - 0.7) - 0.2; }},
                      Guided{.mass = 50, .velocity = -2}, Friction(20_deg)))};
      },
      30, 20);
  CHECK(middle.has("bodies/above/points/velocity_gradient/xy"));
  CHECK(middle.has("bodies/1/points/mass"));
  CHECK(middle.has("rigids/0/impulse"));
  CHECK(middle.has("contact/dissipated"));
  CHECK(middle.size("bodies/above/points/mass") < 70 * 4 * sizeof(double));  // filled with 70 cells
}

TEST_CASE("Restored: a block that vibrates on a rigid surface, with the gaps of nodes") {
  const auto middle = check(
      [] {
        return Scene{
            PlaneStrain{},
            grid(),
            Numerics<QuadraticBSpline, Apic>{},
            bodies(fill(Box{{0.5, 0.42}, {1., 0.7}}, rubber(), {.per_cell = 4, .velocity = {0, -1, 0}})),
            gravity({3, -9.81}),
            rigid(DistanceSurface{Box{{-1, -1}, {3, 0.4}}}, Guided{.mass = 1e3}, Friction(20_deg),
                  NodalGap{})};
      },
      60, 40);
  CHECK(middle.size("rigids/0/gaps/gap") > 0);
}

TEST_CASE("Restored: triangles, FLIP, MUSL, elastic bodies in contact, centred stresses") {
  check(
      [] {
        return Scene{
            PlaneStrain{},
            SimplexMesh<2>(test::triangles({0, 0}, {1, 1}, 30, 30)),
            Numerics<LinearSimplex, Flip, Musl>{},
            bodies(fill(Box{{0.2, 0.42}, {0.8, 0.8}}, rubber(), {.per_cell = 3, .velocity = {0.5, -3, 0}}),
                   fill(Box{{0., 0.}, {1., 0.4}}, rubber(), {.per_cell = 3})),
            walls(bottom(fixed)),
            gravity({0, -9.81}),
            Coulomb{Friction(10_deg)},
            TrackEnergy{}};
      },
      30, 30);
}

TEST_CASE("Restored: tetrahedra, TPIC, a history of several members, a part that reads the step before") {
  const auto middle = check(
      [] {
        return Scene{
            ThreeDimensional{},
            SimplexMesh<3>(test::tetrahedra({0, 0, 0}, {1, 1, 1}, {6, 6, 6})),
            Numerics<LinearSimplex, Tpic, Usl, ElementAverage>{},
            bodies(fill(Box{{0., 0., 0.}, {1., 1., 0.5}}, WithDeviatoricStrain{sand<RemembersOpening>()},
                        {.per_cell = 4, .velocity = {0, -0.5, 0.1}})),
            walls(bottom(fixed)),
            gravity({0, -9.81, 0}),
            Dashpot{3}};
      },
      20, 20);
  CHECK(middle.has("nodes/velocity"));
}

TEST_CASE("Restored: what is no state of the scene is refused") {
  const auto make = [] {
    return Scene{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Apic>{},
                 bodies(fill<"a">(Box{{0., 0.}, {1., 0.52}}, rubber())), walls(bottom(fixed))};
  };
  auto scene = make();
  StateBuffer state(scene);
  auto& mass = state.of("bodies/a/points/mass");
  mass.erase(mass.begin(), mass.begin() + sizeof(double));
  CHECK_THROWS_WITH(state.restore(scene),
                    Catch::Matchers::Contains("state: bodies/a/points/position/x = 1300 numbers"));
  scene = make();
  state = StateBuffer(scene);
  auto& runs = state.of("bodies/a/cells/runs");
  ++runs[3 * sizeof(Index)];
  CHECK_THROWS_WITH(state.restore(scene), Catch::Matchers::Contains("state: cells"));
}

TEST_CASE("Restored: observers by their own state") {
  Progress progress(1, {.stream = stderr, .tenths = false});
  std::vector<std::string> names;
  visit_state_of(progress, "progress", [&](std::string_view name, const auto&) { names.emplace_back(name); });
  CHECK(names == std::vector<std::string>{"progress/tenth", "progress/spent"});
}
