// Pushes: what theory says, what a resistance is read off, what is refused.
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "../../examples/ffp/command/command_line.hpp"
#include "../../examples/ffp/geometry/mesh_quality.hpp"
#include "../../examples/ffp/push/closed_forms.hpp"
#include "../../examples/ffp/push/profile.hpp"
#include "../../examples/ffp/push/results.hpp"
#include "catch.hpp"
#include "read_words.hpp"

using namespace arenite;
using namespace arenite::ffp;

namespace {

PushOptions read_pushed(const std::vector<std::string>& words) {
  std::ostringstream answer;
  return *read_push(words, answer);
}
std::string refusal_of_push(std::vector<std::string> words) {
  words.insert(words.begin(), "push");
  return refusal_of(std::move(words));
}

/// Limit pressure of a spherical cavity by numerical integration: the fields of an expansion from nothing depend only on xi = r / c, c
/// the radius of the plastic zone. Equilibrium and yield give the stresses; the flow rule, beta e_r + 2 e_t (plastic) = 0, the
/// velocity V(xi) over that of c, from 3 delta at xi = 1 inward to the wall of the cavity, where V = xi.
double integrated_limit(const CavitySoil& s, double p0) {
  const double alpha = (1 + std::sin(s.friction)) / (1 - std::sin(s.friction));
  const double beta = (1 + std::sin(s.dilatancy)) / (1 - std::sin(s.dilatancy));
  const double y = 2 * s.cohesion * std::cos(s.friction) / (1 - std::sin(s.friction));
  const double g = s.young / (2 * (1 + s.poisson)), power = 2 * (alpha - 1) / alpha;
  const double load = y + (alpha - 1) * p0, delta = load / (2 * (2 + alpha) * g);
  const double at_boundary =
      (3 * alpha * p0 + 2 * y) / (2 + alpha);  // radial stress where plastic flow begins
  const double a = at_boundary + y / (alpha - 1);
  const auto radial = [&](double xi) { return a * std::pow(xi, -power) - y / (alpha - 1); };
  const auto slope = [&](double xi, double v) {
    const double r = -power * a * std::pow(xi, -power - 1), t = r / alpha;  // slopes of the stresses
    const double elastic =
        (beta * (r - 2 * s.poisson * t) + 2 * ((1 - s.poisson) * t - s.poisson * r)) / s.young;
    return -(2 * v / xi + (v - xi) * elastic) / beta;
  };
  double xi = 1, v = 3 * delta;
  while (v < xi) {
    const double h = -1e-4 * xi;
    const double k1 = slope(xi, v), k2 = slope(xi + h / 2, v + h / 2 * k1),
                 k3 = slope(xi + h / 2, v + h / 2 * k2), k4 = slope(xi + h, v + h * k3);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    xi += h;
  }
  return radial(xi);
}

/// Rows each twentieth of a diameter of 1 m.
std::vector<PushRow> rows_of(double way, double (*net)(double)) {
  std::vector<PushRow> rows;
  for (int k = 1; k <= std::lround(20 * way); ++k) {
    PushRow row;
    row.pushed_m = k / 20.;
    row.depth_m = 4 + row.pushed_m;
    row.vertical_stress_kPa = 10 * row.depth_m;
    row.q_c_kPa = row.vertical_stress_kPa + net(row.pushed_m);
    row.f_s_kPa = row.pushed_m < 1 ? std::numeric_limits<double>::quiet_NaN() : 3;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

TEST_CASE("the factor of a cone is that of the published formula") {
  // (4/3) (1 + ln 100) (1.3) = 9.716, by hand
  CHECK(teh_houlsby(100, 0, 0, 0) == Approx(9.716).epsilon(1e-4));
  CHECK(teh_houlsby(100, 1, 1, 0) == Approx(9.716 + 2.2).epsilon(1e-4));
  CHECK(teh_houlsby(50, 0, 0, 0.5) == Approx(4. / 3 * 4.912023 * 1.275 - 0.9).epsilon(1e-6));
}

TEST_CASE("a cavity's limit is that of the integrated expansion, and in clay 4/3 (1 + ln Ir)") {
  const double degree = pi / 180;
  for (const auto& [soil, p0] : {std::pair{CavitySoil{20e6, 0.3, 35 * degree, 5 * degree, 100}, 100e3},
                                 {CavitySoil{50e6, 0.2, 40 * degree, 15 * degree, 0}, 50e3},
                                 {CavitySoil{10e6, 0.35, 25 * degree, 0, 5e3}, 200e3},
                                 {CavitySoil{100e6, 0.1, 30 * degree, 30 * degree, 0}, 300e3}}) {
    INFO(soil.young << ' ' << soil.friction);
    CHECK(cavity_limit(soil, p0) == Approx(integrated_limit(soil, p0)).epsilon(0.01));
  }
  const double strength = 20e3, ir = 100, nu = 0.4999;
  const CavitySoil clay{2 * (1 + nu) * ir * strength, nu, 0.002, 0, strength};
  CHECK(cavity_limit(clay, 50e3) == Approx(50e3 + 4. / 3 * (1 + std::log(ir)) * strength).epsilon(0.01));
}

TEST_CASE("a resistance is the mean over the last diameter, and steady where it stands still") {
  const auto still = resistance_of(rows_of(3, [](double x) { return x < 1 ? 100 * x : 100.; }), 1);
  REQUIRE(still);
  CHECK(still->net_kPa == Approx(100));
  CHECK(still->q_c_kPa == Approx(100 + 10 * 6.525));
  CHECK(still->f_s_kPa == Approx(3));
  CHECK(std::abs(still->growth) < 1e-12);
  REQUIRE(still->steady_from_m);
  CHECK(*still->steady_from_m == Approx(4.9).margin(0.15));
  const auto growing = resistance_of(rows_of(3, [](double x) { return 100 + 10 * x; }), 1);
  REQUIRE(growing);
  CHECK(growing->growth == Approx(10 / growing->net_kPa));
  CHECK_FALSE(growing->steady_from_m);
  CHECK_FALSE(resistance_of(rows_of(0.9, [](double) { return 1.; }), 1));
  CHECK_FALSE(resistance_of({}, 1));
}

TEST_CASE("lengths of a push are in diameters, its speed and filter in those of shear waves") {
  const PushOptions o = read_pushed({}),
                    twice = read_pushed({"--diameter", "0.0714", "--length", "0.514896"});
  CHECK(o.device_name() == "cone-10cm2");
  const PushOptions own =
      read_pushed({"--device-file", R"({"name": "probe", "profile": [[0, 0], [0.02, 0.03], [0.02, 0.3]]})"});
  CHECK((own.device_name() == "probe" && own.outer_diameter() == 0.04));
  for (const auto& [one, two] : {std::pair{o.start_depth(), twice.start_depth()},
                                 {o.way(), twice.way()},
                                 {o.cell_size(), twice.cell_size()},
                                 {o.flip_time_constant(), twice.flip_time_constant()},
                                 {o.chamber().radius, twice.chamber().radius},
                                 {o.chamber().soil_depth, twice.chamber().soil_depth}})
    CHECK(two == Approx(2 * one));
  CHECK(o.push_speed() == Approx(0.0075 * std::sqrt(2e6 / (17e3 / 9.81))));
  CHECK(twice.push_speed() == o.push_speed());
  CHECK(o.young_modulus() / (2 * (1 + o.poisson_ratio())) == Approx(100 * 20e3));
}

TEST_CASE(
    "the mesh of a penetrometer in the ground: cells are whole, the lid is the uppermost half diameter") {
  for (const char* name : {"cone-10cm2", "bluedrop"}) {
    const PushOptions o = read_pushed({"--penetrometer", name});
    Chamber chamber = o.chamber();
    chamber.lid = o.outer_diameter() / 2;
    const AxisymmetricMesh made = mesh_axisymmetric(o.body(), chamber, o.mesh_sizes());
    double low = 1e9, high = -1e9, ground = 0, device = 0;
    for (std::size_t c = 0; c < made.data.cells.size(); ++c) {
      const auto& n = made.data.cells[c];
      const Point2 a = made.data.nodes[n[0]], b = made.data.nodes[n[1]], d = made.data.nodes[n[2]];
      const double area = ((b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0])) / 2;
      REQUIRE(area > 0);
      const double volume = 2 * pi * area * (a[0] + b[0] + d[0]) / 3;
      const int region = made.data.region[c];
      if (region == arenite::ffp::device) device += volume;
      if (region == soil || region == lid) ground += volume;
      if (region != lid) continue;
      for (const auto i : n) {
        low = std::min(low, made.data.nodes[i][1]);
        high = std::max(high, made.data.nodes[i][1]);
      }
    }
    CHECK(low == Approx(chamber.embedded - chamber.lid));
    CHECK(high == Approx(chamber.embedded));
    CHECK(device == Approx(o.body().volume()).epsilon(0.02));
    const double whole = pi * chamber.radius * chamber.radius * (chamber.soil_depth + chamber.embedded);
    CHECK(ground < whole);
    CHECK(ground > whole - device);
  }
}

TEST_CASE("what no push can be is refused, with its value and rule") {
  for (const auto& [words, sentence] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--cell", "0.02"}, "--cell = 0.02: must lie in [0.00107"},
           {{"--start-depth", "0.5"},
            "--start-depth = 0.5: must be less than the length of the penetrometer, 0.257"},
           {{"--start-depth", "0.03"},
            "--start-depth = 0.03: must be at least the height of the tip and half a diameter"},
           {{"--distance", "0.01"}, "--distance = 0.01: must be at least a diameter"},
           {{"--speed", "10"}, "--speed = 10: must be at most a tenth of the speed of shear waves, 3.4"},
           {{"--penetrometer", "sphere-25cm"}, "--penetrometer = sphere-25cm: must have a rod"},
           {{"--penetrometer", "ball-100cm2"},
            "--penetrometer = ball-100cm2: must not be wider than its rod"},
           {{"--overburden", "1000"}, "--overburden = 1000: needs --ground sand"},
           {{"--friction", "30"}, "--friction = 30: needs --ground sand"},
           {{"--ground", "sand", "--strength", "1e4"}, "--strength = 10000: needs --ground clay"},
           {{"--ground", "sand", "--roughness", "1"}, "--roughness = 1: needs --ground clay"},
           {{"--roughness", "1.5"}, "--roughness = 1.5: must lie in [0, 1]"},
           {{"--ground", "sand", "--dilatancy", "40"},
            "--dilatancy = 40: must not exceed --friction = 35 deg"},
           {{"--poisson", "0.5"}, "--poisson = 0.5: must lie in [0, 0.49]"},
           {{"--points-per-element", "5"}, "--points-per-element = 5: must be 1, 3"},
           {{"--soil-depth", "0.1"}, "--soil-depth = 0.1: must be at least --distance and 4 diameters"},
           {{"--chamber-radius", "0.1"}, "--chamber-radius = 0.1: must be at least 5 diameters"},
           {{"--error-bar", "--cell", "0.007"}, "--cell = 0.007: must be at most 0.0053"},
           {{"--mass", "3"}, "--mass: no such option; see arenite-ffp push --help"}}) {
    INFO(sentence);
    CHECK(refusal_of_push(words).find(sentence) == 0);
  }
}

TEST_CASE("theory stands beside a push where it fits") {
  const auto forms = [](const std::vector<std::string>& words) {
    const PushOptions o = read_pushed(words);
    return closed_forms(o, o.start_depth() + o.way());
  };
  REQUIRE(forms({}).size() == 1);
  CHECK(forms({})[0].value == Approx(20e3 * teh_houlsby(100, 0, 0, 0)));
  CHECK(forms({"--roughness", "0.5"})[0].value == Approx(20e3 * teh_houlsby(100, 0.5, 0.5, 0)));
  CHECK(forms({"--rigidity-index", "40"}).empty());
  CHECK(forms({"--cone-angle", "90"}).empty());
  const auto sand = forms({"--ground", "sand", "--overburden", "1e5"});
  REQUIRE(sand.size() == 1);
  CHECK(sand[0].is_lower_guide);
  CHECK(sand[0].value > 5e5);
}
