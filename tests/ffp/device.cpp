// Penetrometers of any size: given values, values that follow from them, and refusals.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "../../examples/ffp/drop/results.hpp"
#include "../../examples/ffp/geometry/mesh_grid.hpp"
#include "../../examples/ffp/geometry/mesh_quality.hpp"
#include "../../examples/ffp/options/device_json.hpp"
#include "../../examples/ffp/reduce/reduction_files.hpp"
#include "catch.hpp"
#include "read_words.hpp"
#include "reductions.hpp"

using namespace arenite;
using namespace arenite::ffp;

namespace {

std::string refusal_of_drop(std::vector<std::string> words) {
  words.insert(words.begin(), "drop");
  return refusal_of(std::move(words));
}

}  // namespace

TEST_CASE("without options the penetrometer, its chamber and its mesh are the paper's, to the bit") {
  const DropOptions o = read({});
  const DeviceShape published;
  const DeviceShape shape = o.shape();
  CHECK(
      (shape.radius == published.radius && shape.length == published.length && shape.apex == published.apex));
  const Chamber chamber, told = o.chamber();
  CHECK((told.radius == chamber.radius && told.soil_depth == chamber.soil_depth &&
         told.headroom == chamber.headroom));
  const MeshSizes sizes, of = o.mesh_sizes();
  CHECK((of.cell == sizes.cell && of.at_cone == sizes.at_cone && of.refined == sizes.refined &&
         of.fine_radius == sizes.fine_radius && of.moving_depth == sizes.moving_depth));
  CHECK(o.device_mass() == 7.71);
  CHECK(read({"--tip", "cone-truncated"}).shape().flat == truncated_radius);
  CHECK(read({"--tip", "parabolic"}).shape().parabola == parabola_constant);
  CHECK(read({"--shoulder", "fillet"}).shape().fillet == 0.01);
}

TEST_CASE("standard cones have the areas that they are called by") {
  for (const auto& [name, area] : {std::pair{"cone-10cm2", 10e-4}, {"cone-15cm2", 15e-4}}) {
    const auto o = read({"--penetrometer", name, "--mass", "1"});
    const Device device{o.shape()};
    CHECK(std::abs(device.projected_area(device.length()) / area - 1) < 2e-3);
    CHECK(o.device_name() == name);
    CHECK(std::abs(device.mantle_area(device.length()) / device.projected_area(device.length()) - 2) <
          1e-12);  // 1 / sin(30 deg)
  }
}

TEST_CASE("cells, chamber and zones of the mesh follow the penetrometer") {
  const DropOptions paper = read({}),
                    small = read({"--diameter", "0.021875", "--length", "0.15775", "--mass", "0.12"});
  CHECK(small.size() == 0.25);
  const auto a = mesh_axisymmetric(paper.body(), paper.chamber(), paper.mesh_sizes()).data;
  const auto b = mesh_axisymmetric(small.body(), small.chamber(), small.mesh_sizes()).data;
  REQUIRE(a.nodes.size() == b.nodes.size());
  CHECK(a.cells == b.cells);
  double off = 0;
  for (std::size_t i = 0; i < a.nodes.size(); ++i) off = std::max(off, (a.nodes[i] / 4 - b.nodes[i]).norm());
  CHECK(off < 1e-15);
  const auto lines = grid_lines(small.body(), small.chamber(), small.mesh_sizes());
  CHECK(lines.x.back() == 0.1);
}

TEST_CASE("a penetrometer of any angle, flat end and slenderness has a mesh of good triangles") {
  for (const char* angle : {"20", "30", "60", "90", "120"})
    for (const char* flat : {"", "0.01", "0.04"})
      for (const char* length : {"0.5", "2"})
        for (const char* accuracy : {"coarse", "normal"}) {
          INFO("angle " << angle << ", flat " << flat << ", length " << length << ", " << accuracy);
          std::vector<std::string> words{"--diameter", "0.05",   "--length", length,       "--cone-angle",
                                         angle,        "--mass", "4",        "--accuracy", accuracy};
          if (*flat) words.insert(words.end(), {"--tip", "cone-truncated", "--flat", flat});
          const auto o = read(words);
          const auto mesh = mesh_axisymmetric(o.body(), o.chamber(), o.mesh_sizes()).data;
          const auto q = mesh_quality(mesh);
          CHECK(q.at("soil").min_altitude > 0.3 * o.cell_size());
          CHECK(q.at("air").min_altitude > 0.15 * o.cell_size());
          CHECK(q.at("soil").min_volume > 0);
          CHECK(q.at("device").min_volume > 0);
          CHECK(SimplexMesh<2>{mesh}.cell_count() == mesh.cells.size());
        }
}

TEST_CASE("what no penetrometer can be is refused, with value, rule and cure") {
  CHECK(holds(refusal_of_drop({"--diameter", "0.05"}), "--mass: must be given for bluedrop, cone, changed"));
  CHECK(holds(refusal_of_drop({"--penetrometer", "cone-10cm2"}), "--mass: must be given for cone-10cm2"));
  const auto light = refusal_of_drop({"--mass", "1.1"});
  CHECK(holds(light, "--mass = 1.1: must give a mean density in [500, 20000] kg/m3, not 31"));
  CHECK(holds(light, "see --diameter and --length"));
  CHECK(holds(refusal_of_drop({"--mass", "900"}), "must give a mean density"));
  CHECK(holds(refusal_of_drop({"--cone-angle", "150", "--mass", "7"}),
              "--cone-angle = 150: must lie in [20, 120] deg"));
  CHECK(holds(refusal_of_drop({"--cone-angle", "60", "--tip", "blunt", "--mass", "7"}),
              "needs --tip cone or cone-truncated"));
  CHECK(holds(refusal_of_drop({"--flat", "0.01", "--mass", "7"}), "needs --tip cone-truncated"));
  CHECK(holds(refusal_of_drop({"--flat", "0.1", "--tip", "cone-truncated", "--mass", "7"}),
              "must be less than the diameter, 0.0875 m"));
  CHECK(holds(refusal_of_drop({"--length", "0.08", "--mass", "1"}),
              "--length = 0.08: must be more than the tip's height"));
  CHECK(
      holds(refusal_of_drop({"--diameter", "0", "--mass", "1"}), "--diameter = 0: must lie in [0.01, 2] m"));
  CHECK(holds(refusal_of_drop({"--diameter", "nan", "--mass", "1"}), "--diameter = nan"));
  CHECK(holds(refusal_of_drop({"--chamber-radius", "0.2"}),
              "must be at least five times the penetrometer's radius, 0.21875 m"));
  CHECK(holds(refusal_of_drop({"--soil-depth", "0.1"}),
              "must be at least --moving-depth and a diameter, 0.1475 m"));
  CHECK(holds(refusal_of_drop({"--diameter", "0.02", "--length", "0.2", "--mass", "0.1", "--cell", "0.01"}),
              "--cell = 0.01: must lie in"));
}

TEST_CASE("an outline of lines is the cone that it draws; a ball and a sphere are those of the formulas") {
  const DeviceShape cone;
  const double h = cone.radius / std::tan(cone.apex / 2);
  const auto file =
      written("cone.json", joined_text({R"({"name": "drawn", "source": "a drawing", "mass_kg": 7.71, )",
                                        R"("profile": [[0, 0], [)", exactly(cone.radius), ", ", exactly(h),
                                        "], [", exactly(cone.radius), ", ", exactly(cone.length), "]]}"}));
  const DropOptions drawn = read({"--device-file", file}), plain = read({});
  const Device a = drawn.body(), b = plain.body();
  CHECK((drawn.device_mass() == plain.device_mass() && drawn.device_name() == "drawn"));
  CHECK((a.radius() == b.radius() && a.length() == b.length() && a.tip_end() == b.tip_end()));
  for (const double y : {-0.01, 0.0, 0.01, 0.05, 0.08, 0.3}) {
    CHECK(std::abs(a.profile(y) - b.profile(y)) < 1e-16);
    CHECK(std::abs(a.mantle_area(y) - b.mantle_area(y)) < 1e-16);
    CHECK(std::abs(a.projected_area(y) - b.projected_area(y)) < 1e-17);
  }
  const auto mesh = mesh_axisymmetric(a, drawn.chamber(), drawn.mesh_sizes()).data,
             same = mesh_axisymmetric(b, plain.chamber(), plain.mesh_sizes()).data;
  REQUIRE((mesh.cells == same.cells && mesh.nodes.size() == same.nodes.size()));
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) CHECK((mesh.nodes[n] - same.nodes[n]).norm() < 1e-15);
  for (const double offset : {0.002, -0.002}) {
    DeviceShape one = drawn.shape(), other = plain.shape();
    one.offset = other.offset = offset;
    const Device near{one}, like{other};
    CHECK(std::abs(near.tip_above() - like.tip_above()) < 1e-15);
    for (const double y : {0.02, 0.07, 0.3}) CHECK(std::abs(near.profile(y) - like.profile(y)) < 1e-15);
    CHECK(std::abs(near.length() - like.length()) < 1e-15);
  }

  const Device ball{read({"--penetrometer", "ball-100cm2", "--mass", "5"}).shape()};
  const double r = 0.1128 / 2, rod = 0.0357 / 2, neck = r + std::sqrt(r * r - rod * rod);
  CHECK(std::abs(ball.projected_area(1) / 100e-4 - 1) < 1e-3);
  CHECK(std::abs(ball.projected_area(neck) - pi * r * r) < 1e-17);
  CHECK(std::abs(ball.projected_area(r / 2) / (pi * 0.75 * r * r) - 1) < 4e-4);  // facets of 2 deg
  CHECK(std::abs(ball.mantle_area(1) / (2 * pi * r * r) - 1) < 4e-4);
  const double cut = neck - r, under = 2 * pi / 3 * r * r * r + pi * cut * (r * r - cut * cut / 3);
  CHECK(std::abs(ball.volume() / (under + pi * rod * rod * (ball.length() - neck)) - 1) < 1e-3);
  const Device sphere{read({"--penetrometer", "sphere-25cm", "--mass", "50"}).shape()};
  CHECK(std::abs(sphere.volume() / (pi / 6 * 0.25 * 0.25 * 0.25) - 1) < 1e-3);
  CHECK((sphere.length() == 0.25 && sphere.radius() == 0.125));
  DeviceShape wider = read({"--penetrometer", "sphere-25cm", "--mass", "50"}).shape();
  wider.offset = 0.003;
  CHECK(std::abs(Device{wider}.radius() - 0.128) < 1e-6);
  CHECK(std::abs(Device{wider}.length() - 0.256) < 1e-5);
}

TEST_CASE(
    "an outline parallel to that of a ball on a rod: its own ball, a neck where both intersect, a rod") {
  const double r = 0.1128 / 2, rod = 0.0357 / 2;
  for (const double offset : {-0.005, -0.001, 0.003, 0.01}) {
    CAPTURE(offset);
    DeviceShape shape = read({"--penetrometer", "ball-100cm2", "--mass", "5"}).shape();
    shape.offset = offset;
    const Device met{shape};
    const double ball = r + offset, neck = ball + std::sqrt(ball * ball - square(rod + offset));
    CHECK(std::abs(met.radius() - ball) < 1e-15);
    CHECK(std::abs(met.tip_above() - offset) < 1e-15);
    CHECK(std::abs(met.profile(neck + 1e-9) - (rod + offset)) < 1e-12);
    CHECK(std::abs(met.tip_end() - neck) < 1e-12);
    CHECK(std::abs(met.profile(ball / 2) - std::sqrt(0.75) * ball) < 2e-4 * ball);  // facets of 2 deg
    CHECK(std::abs(met.length() - (met.instrument().length() + 2 * offset)) < 1e-15);
    CHECK(met.instrument().radius() ==
          Device{read({"--penetrometer", "ball-100cm2", "--mass", "5"}).shape()}.radius());
  }
  DeviceShape thin = read({"--penetrometer", "ball-100cm2", "--mass", "5"}).shape();
  thin.offset = -0.02;
  CHECK_THROWS_WITH(Device{thin}, Catch::Matchers::Contains("must leave each piece of the profile"));
}

TEST_CASE("meshes of balls and spheres: whole cells at every size") {
  for (const char* name : {"ball-100cm2", "sphere-25cm"})
    for (const double share : {0.04, 0.01, 0.005})
      for (const double refined : {0.0, 0.4}) {
        const double scale = name[0] == 'b' ? 0.1128 / 0.0875 : 0.25 / 0.0875;
        std::vector<std::string> words{
            "--penetrometer", name, "--mass", name[0] == 'b' ? "5" : "50", "--cell", exactly(share * scale)};
        if (refined > 0) words.insert(words.end(), {"--cell-at-cone", exactly(refined * share * scale)});
        const DropOptions o = read(words);
        CAPTURE(name, share, refined);
        const auto mesh = mesh_axisymmetric(o.body(), o.chamber(), o.mesh_sizes()).data;
        const auto q = mesh_quality(mesh);
        const double cell = o.mesh_sizes().cone_cell();
        for (const char* region : {"soil", "air", "device"}) {
          CAPTURE(region);
          CHECK(q.at(region).min_volume > 0);
          CHECK(q.at(region).min_altitude > 0.15 * cell);
        }
        CHECK(SimplexMesh<2>{mesh}.cell_count() == mesh.cells.size());
      }
}

TEST_CASE("a file of a penetrometer that cannot be one is refused, with its name and the cure") {
  const auto refused = [](const std::string& text) {
    return refusal_of_drop({"--mass", "5", "--device-file", written("bad.json", text)});
  };
  const std::string open = R"({"name": "x", "profile": )";
  CHECK(holds(refused("{}"), "--device-file = bad.json: profile = (none): must be given"));
  CHECK(holds(refused(R"({"profile": [[0, 0], [1, 1]]})"), "name = (none): must be a text"));
  CHECK(
      holds(refused(open + "[[0, 0], [0.03, 0.05]], \"weight\": 3}"), "no such key; there are name, source"));
  CHECK(holds(refused(open + "[[0.01, 0], [0.03, 0.05]]}"), "must begin at the tip, [0, 0]"));
  CHECK(
      holds(refused(open + "[[0, 0], [0.03, 0.05], [0.03, 0.04]]}"), "must not lie below the point before"));
  CHECK(holds(refused(open + "[[0, 0], [-0.03, 0.05]]}"), "must have a radius of at least 0"));
  CHECK(holds(refused(open + "[[0, 0], [0.03]]}"), "must be a point [radius, height] in m"));
  CHECK(holds(refused(open + "[[0, 0], {\"to\": [0.05, 0.05], \"arc\": 0.01}]}"),
              "must be at least half the distance of its ends"));
  CHECK(holds(refused(open + "[[0, 0], [0.03, 0.05], [0.03, 0.4]], \"mass_kg\": -1}"),
              "must be a number above 0"));
  CHECK(holds(refused(open + "[[0, 0], [0.03, 0.05], [0.03, 0.4]], \"gyration_m\": 2}"),
              "must be less than the length"));
  CHECK(holds(refused(open + "[[0, 0], [0.03, 0.05], [0.03, 0.1], [0.05, 0.1], [0.05, 0.4]]}"),
              "take --mesh-kind grid"));
  CHECK(holds(refusal_of_drop({"--device-file", "none.json"}), "none.json"));
  const auto good = written("good.json", open + "[[0, 0], [0.03, 0.05], [0.03, 0.4]]}");
  CHECK(holds(refusal_of_drop({"--device-file", good}), "--mass: must be given for x"));
  CHECK(holds(refusal_of_drop({"--device-file", good, "--mass", "5", "--diameter", "0.05"}),
              "--diameter: goes without --device-file, which tells its whole outline"));
  CHECK(holds(refusal_of_drop({"--penetrometer", "sphere-25cm", "--tip", "blunt", "--mass", "50"}),
              "--tip: goes without --penetrometer sphere-25cm"));
  CHECK(holds(refusal_of_drop({"--penetrometer", "sphere-25cm", "--length", "0.3", "--mass", "50"}),
              "--length: goes without --penetrometer sphere-25cm"));
  CHECK(holds(refusal_of_drop({"--penetrometer", "ball-100cm2", "--length", "0.1", "--mass", "5"}),
              "--length = 0.1: must be more than the diameter of the ball, 0.1128 m"));
  CHECK(read({"--penetrometer", "sphere-25cm", "--diameter", "0.1", "--mass", "3"}).body().length() == 0.1);
}

TEST_CASE("what is written of a penetrometer gives it back") {
  const auto probe = written("probe.json", R"({"name": "probe", "source": "drawing 12", "mass_kg": 5.2,
      "profile": [[0, 0], [0.03, 0.05], {"to": [0.035, 0.06], "arc": 0.02}, [0.035, 0.4]],
      "centre_of_mass_m": 0.19, "gyration_m": 0.11})");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{},
        {"--tip", "parabolic"},
        {"--tip", "blunt"},
        {"--shoulder", "fillet"},
        {"--penetrometer", "cone-15cm2", "--mass", "2"},
        {"--penetrometer", "ball-100cm2", "--mass", "5", "--length", "1"},
        {"--device-file", probe},
        {"--diameter", "0.05", "--length", "0.4", "--cone-angle", "90", "--tip", "cone-truncated", "--flat",
         "0.01", "--mass", "3"}}) {
    const DropOptions o = read(words);
    const DeviceOptions back = device_in(inputs_of(o));
    const DeviceShape a = o.shape(), b = back.shape();
    CHECK((a.radius == b.radius && a.length == b.length && a.apex == b.apex && a.flat == b.flat &&
           a.parabola == b.parabola && a.fillet == b.fillet));
    CHECK(back.device_mass() == o.device_mass());
    REQUIRE(a.profile.has_value() == b.profile.has_value());
    if (a.profile) CHECK(Device{a}.outline() == Device{b}.outline());
    const Json told = json_of(o, o.device_mass());
    CHECK(told.at("diameter_m") == 2 * a.radius);
    CHECK(std::abs(told.at("mean_density_kg_m3").get<double>() * told.at("volume_m3").get<double>() /
                       o.device_mass() -
                   1) < 1e-12);
  }
}

TEST_CASE("the same record under three penetrometers: force over the area of each") {
  std::string text = "time_s,deceleration_m_s2\n";
  for (int i = 0; i <= 1600; ++i) {
    const double t = i * 1e-3;
    text += joined_text({t, ",", t < 0.5 || t > 1.1 ? 0. : t < 1 ? -standard_gravity : 49.05, "\n"});
  }
  const auto file = written("three.csv", text);
  struct Found {
    double force, pressure;  ///< kN, kPa, by the section where it comes to rest
    Reduction of;
  };
  const auto found = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--from-depth", "0"});
    Reduction r = reduced(file, words);
    std::size_t last = 0;
    for (std::size_t i = 0; i < r.q_dyn[1].size(); ++i)
      if (!std::isnan(r.q_dyn[1][i])) last = i;
    const double pressure = r.q_dyn[1][last];
    return Found{pressure * Device{r.device.shape()}.projected_area(r.motion.depth[last]), pressure,
                 std::move(r)};
  };
  const auto paper = found({"--mass", "7.71"});
  const auto cone = found({"--penetrometer", "cone-15cm2", "--length", "2", "--mass", "7.71"});
  const auto third = found({"--diameter", "0.05", "--length", "1", "--cone-angle", "90", "--mass", "7.71"});
  CHECK(std::abs(cone.force / paper.force - 1) < 1e-12);
  CHECK(std::abs(third.force / paper.force - 1) < 1e-12);
  CHECK(std::abs(cone.pressure / paper.pressure - std::pow(0.0875 / 0.0437, 2)) < 1e-9);
  CHECK(std::abs(third.pressure / paper.pressure - std::pow(0.0875 / 0.05, 2)) < 1e-9);
  CHECK(holds(text_of(third.of.device, 7.71), "bluedrop, cone, changed: 5 cm wide, 100 cm long, 7.71 kg"));
  CHECK(holds(refusal(file, {"--diameter", "0.05"}), "--mass: must be given"));
  CHECK(holds(refusal(file, {"--mass", "1"}), "must give a mean density"));
}
