// The watch of `run` itself: what it warns a newcomer of, and of what only a run can see.
#include <algorithm>
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "said.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}}; }

/// A column of sand; `run` watches it of itself.
auto newcomer(double young, double gravitation, const FillOptions& options = {},
              const Box<2>& box = {{0., 0.}, {0.1, 0.16}}) {
  const MohrCoulomb sand{{.density = 1540, .young = young, .poisson = 0.3, .friction = 35_deg}};
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.4, 0.2}, .cell = 0.02}},
               Numerics<QuadraticBSpline, Flip>{Flip{.time = 0.02}},
               bodies(fill(box, sand, options)),
               walls(bottom(fixed), left(roller), right(roller)),
               gravity({0, -gravitation})};
}

/// The warnings of a run that speak of `what`.
template <class Scene>
std::size_t told(Scene& scene, const RunOptions& options, const std::string& what) {
  std::size_t count = 0;
  const auto before = on_warning([&](std::string_view text) { count += text.find(what) != text.npos; });
  run(scene, options);
  on_warning(before);
  return count;
}

}  // namespace

TEST_CASE("Typical mistakes are reported by run itself: load, stiffness, speed, a point in all") {
  const auto told = [](auto scene, RunOptions options, const std::string& what, const std::string& with) {
    const Said s = said([&] { run(scene, options); });
    CAPTURE(s.error, s.warnings);
    CHECK(s.error == "");
    CHECK(std::ranges::any_of(s.warnings, [&](const auto& w) {
      return w.find("t = ") == 0 && has(w, what + " = ") && has(w, with) && has(w, "body 0");
    }));
    options.watch = false;
    options.end *= 1.1;
    CHECK(said([&] { run(scene, options); }).warnings.empty());
  };
  CHECK(said([] {
          auto sound = newcomer(1e6, 9.81);
          run(sound, {.end = 0.1});
        }).warnings.empty());
  told(newcomer(1e6, 9810), {.end = 0.0055}, "volume", "above 0.5; body 0: mean V/V0 = 0.");  // 1000 g
  told(newcomer(1e3, 9.81), {.end = 0.25}, "volume", "above 0.5; body 0: mean V/V0 = 0.");    // 1 kPa
  const double wave = std::sqrt(1e6 * 0.7 / (1.3 * 0.4) / 1540);
  const auto fast = newcomer(1e6, 9.81, {.velocity = {0, -6 * wave, 0}}, {{0.1, 0.04}, {0.2, 0.14}});
  told(fast, {.end = 1e-4}, "speed", joined_text({6 * wave, " m/s; waves run at ", wave}));
  CHECK(said([] { newcomer(1e6, 9.81); }).warnings.empty());
  const Said one = said([] { newcomer(1e6, 9.81, {.per_cell = 1}, {{0., 0.}, {0.02, 0.02}}); });
  REQUIRE(one.warnings.size() == 1);
  CHECK(has(one.warnings[0], "body 0 has 1 point: fewer than 3 cannot strain as a body"));
}

TEST_CASE("A Watch of the user's takes the place of that of run") {
  auto scene = newcomer(1e6, 9810);
  Watch watch{{.volume = 0.4}};
  CHECK(
      has(said([&] { run(scene, {.end = 0.0055}, every(0.001, watch)); }).error, "the limit is 0.4; body 0"));
}

TEST_CASE("A run warns of material that falls with local damping on, and not of what settles") {
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
  const auto block = [&](double lower, auto... parts) {
    return Scene{PlaneStrain{},
                 grid(),
                 Numerics<QuadraticBSpline, Flip, Musl>{},
                 bodies(fill(Box{{0., lower}, {1., lower + 0.4}}, rubber, {.per_cell = 4})),
                 walls(bottom(roller), left(roller), right(roller)),
                 gravity({0, -10}),
                 parts...};
  };
  auto falls = block(0.5, LocalDamping{});
  CHECK(told(falls, {.end = 0.35}, "local damping took 70 %") == 1);
  auto switched_off = block(0.5, LocalDamping{});
  switched_off.part<LocalDamping>().switch_off();
  CHECK(told(switched_off, {.end = 0.2}, "local damping") == 0);
  auto free = block(0.5);
  CHECK(told(free, {.end = 0.2}, "local damping") == 0);
  auto stands = block(0, LocalDamping{});
  CHECK(told(stands, {.end = 0.5}, "local damping") == 0);
  auto settles = block(0.4, LocalDamping{});
  std::size_t count = 0;
  const auto before = on_warning([&](std::string_view text) { count += text.find("damping") != text.npos; });
  settle(settles, {.ratio = 0.01, .end = 5});
  on_warning(before);
  CHECK(count == 0);
}

TEST_CASE("A run warns of points that tension has drawn apart, and not of what is loose or pressed") {
  const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
  const auto stretched = [&](int per_cell, double volume, double stress) {
    Scene scene{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Flip, Musl>{},
                bodies(fill(Box{{0.2, 0.2}, {0.6, 0.6}}, rubber, {.per_cell = per_cell}))};
    auto& points = scene.body().points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      points.volume[p] *= volume;
      Sym<double, 2> s;
      s[1] = stress;
      points.stress.set(p, s);
    }
    return told(scene, {.end = 1e-4}, "tension has drawn points");
  };
  CHECK(stretched(4, 1.5, 1e5) == 1);
  CHECK(stretched(4, 1.1, 1e5) == 0);
  CHECK(stretched(9, 1.5, 1e5) == 0);
  CHECK(stretched(4, 1.5, 0) == 0);
  CHECK(stretched(4, 1.5, -1e5) == 0);
}
