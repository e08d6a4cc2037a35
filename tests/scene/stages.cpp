// Stages of construction in one scene: a column built in lifts and dug out again, against the settlement and
// the heave of linear elasticity; the initial velocity as a function; runs that an observer ends.
#include <arenite/arenite.hpp>
#include <arenite/load/damping.hpp>
#include <arenite/run/settle.hpp>

#include "catch.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

constexpr double height = 1, g = 9.81, density = 2000;
constexpr int lifts = 4;
LinearElastic soil() { return LinearElastic{{.density = density, .young = 1e7, .poisson = 0.25}}; }

/// Settlement, m, of what was placed at height y, when the column stands: what came after it, and its own
/// lift, rest on all below it.
double settlement(double y) {
  const double lift = height / lifts, below = std::floor(y / lift) * lift;
  return density * g / soil().wave_modulus() *
         (below * (height - below) + height * (y - below) - (y * y - below * below) / 2);
}

auto empty_column() {
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.1, 1.2}, .cell = 0.05}},
               Numerics<QuadraticBSpline, Flip, Musl>{},
               bodies(fill<"soil">(Box{{0., 0.}, {0.1, height}}, soil(), {.per_cell = 4})),
               walls(left(roller), right(roller), bottom(roller)),
               gravity({0, -g}),
               LocalDamping{},
               PointIds{},
               TrackEnergy{}};
}

/// An observer that counts.
struct Counts {
  int& shown;
  int& finished;
  template <class Scene>
  void operator()(const Scene&) const {
    ++shown;
  }
  template <class Scene>
  void finish(const Scene&) const {
    ++finished;
  }
};

/// Where each point was placed, by its id.
template <class Scene>
void note_places(const Scene& scene, std::vector<double>& placed) {
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points.id[p] >= placed.size()) placed.resize(points.id[p] + 1, -1);
    if (placed[points.id[p]] < 0) placed[points.id[p]] = points.position[p][1];
  }
}

/// The greatest difference of the points' sinking since they stood at `placed` from `exact(placed)`, m.
template <class Scene, class Exact>
double worst_difference(const Scene& scene, const std::vector<double>& placed, test::Validation& validation,
                        const std::string& curve, Exact&& exact) {
  const auto& points = scene.body().points;
  double worst = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double y = placed[points.id[p]], sunk = y - points.position[p][1];
    worst = std::max(worst, std::abs(sunk - exact(y)));
    validation.point(curve, "height when placed (m)", y, "settlement (mm)", 1e3 * sunk, 1e3 * exact(y));
  }
  return worst;
}

}  // namespace

TEST_CASE("A column built in lifts settles most in its middle; dug out, what is left heaves") {
  auto scene = empty_column();
  remove_points<"soil">(scene, Box{{0., height / lifts}, {0.1, height}});
  test::Validation validation("construction_stages");
  std::vector<double> placed;
  const double lift = height / lifts;
  for (int k = 0; k < lifts; ++k) {
    if (k > 0) {
      const auto brought =
          insert_points<"soil">(scene, Box{{0., k * lift}, {0.1, (k + 1) * lift}}, {.per_cell = 4});
      CHECK(brought.mass == Approx(density * 0.1 * lift));
    }
    note_places(scene, placed);
    settle(scene, {.ratio = 1e-4, .end = scene.time + 3});
  }
  const double greatest = settlement(0.5);
  const double built = worst_difference(scene, placed, validation, "built in four lifts",
                                        [](double y) { return settlement(y); });
  CHECK(built < 0.02 * greatest);
  validation.value("built in four lifts", "greatest difference of settlement over that at half height", "-",
                   built / greatest, 0);

  const double work = energies(scene).external;  // of gravity, until the column stands

  // The upper half is dug out: what is left heaves by its load times its height over M.
  placed.assign(placed.size(), -1);
  note_places(scene, placed);
  const double weight = density * g * 0.1 * height;
  const auto out = remove_points<"soil">(scene, Box{{0., height / 2}, {0.1, 2 * height}});
  CHECK(out.mass * g == Approx(weight / 2).epsilon(0.03));  // whole points
  settle(scene, {.ratio = 1e-4, .end = scene.time + 3});
  const double load = out.mass * g / 0.1;
  const double heave = load * 0.5 / soil().wave_modulus();
  const double dug = worst_difference(scene, placed, validation, "upper half dug out",
                                      [&](double y) { return -load * y / soil().wave_modulus(); });
  CHECK(dug < 0.02 * heave);
  validation.value("upper half dug out", "greatest difference of heave over the greatest heave", "-",
                   dug / heave, 0);
  const double residual = energies(scene).residual;
  CHECK(std::abs(residual) < 0.004 * work);
  validation.value("all stages", "energy out of balance over the work of gravity on what was built", "-",
                   residual / work, 0);
}

TEST_CASE("Initial velocity as a function: a rigid rotation, with its gradient where points carry one") {
  const auto turns = [](const std::array<double, 3>& x) {
    return std::array<double, 3>{-3 * x[1], 3 * x[0], 0};
  };
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {-1, -1}, .upper = {1, 1}, .cell = 0.1}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Ball({0., 0.}, 0.5), soil(), {.velocity = turns}))};
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    REQUIRE((points.velocity[p] - 3 * Vec<double, 2>(-points.position[p][1], points.position[p][0])).norm() <
            1e-15);
    REQUIRE((Mat<double, 2>(points.velocity_gradient[p]) - 3 * Mat<double, 2>{{0, -1}, {1, 0}}).norm() <
            1e-8);
  }
  const auto refused = [&](auto velocity) {
    Scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {-1, -1}, .upper = {1, 1}, .cell = 0.1}},
          Numerics<QuadraticBSpline, Apic>{},
          bodies(fill(Ball({0., 0.}, 0.5), soil(), {.velocity = velocity}))};
  };
  CHECK_THROWS_WITH(refused(InitialVelocity{0, 0, 1}),
                    Catch::Matchers::Contains("FillOptions.velocity = 1: must be zero along an axis"));
  CHECK_THROWS_WITH(refused([](const std::array<double, 3>& x) {
                      return std::array<double, 3>{1 / (x[0] > 0 ? 0.0 : 1.0), 0, 0};
                    }),
                    Catch::Matchers::Contains("FillOptions.velocity at (0.") &&
                        Catch::Matchers::Contains("= inf: must be finite"));
}

TEST_CASE("An observer ends a run; the others are called at its end") {
  int shown = 0, finished = 0;
  auto scene = empty_column();
  run(scene, {.end = 1}, Counts{shown, finished},
      [](const auto& s) { return s.steps < 3 ? RunFlow::go_on : RunFlow::stop; });
  CHECK(scene.steps == 3);
  CHECK(scene.time < 0.01);
  CHECK(shown == 4);
  CHECK(finished == 1);
}
