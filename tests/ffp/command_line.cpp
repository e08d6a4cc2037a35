// The command line of the drop: defaults are the paper's case; whatever is wrong becomes one sentence.
#include "../../examples/ffp/command_line.hpp"

#include <fstream>
#include <sstream>

#include "catch.hpp"

using namespace arenite;
using namespace arenite::ffp;

namespace {

DropOptions read(std::vector<std::string> words) {
  words.insert(words.begin(), "drop");
  std::ostringstream help;
  auto options = read_command_line(std::move(words), help);
  REQUIRE(options.has_value());
  REQUIRE(help.str().empty());
  return *options;
}

std::string refusal(std::vector<std::string> words) {
  std::ostringstream help;
  try {
    read_command_line(std::move(words), help);
  } catch (const error& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("without options: the paper's case") {
  const auto o = read({});
  REQUIRE(o.kinematics == Kinematics::axisymmetric);
  REQUIRE(o.device == DeviceKind::rigid);
  REQUIRE(o.delta == 20);
  REQUIRE(o.velocity == 5.6);
  REQUIRE(o.mass == 7.71);
  REQUIRE(o.friction == 40);
  REQUIRE(o.young == 5e6);
  REQUIRE(o.poisson == 0.33);
  REQUIRE(o.unit_weight == 15100);
  REQUIRE(o.cohesion == 0);
  REQUIRE(o.dilatancy == 0);
  REQUIRE(o.device_young == 20e6);
  REQUIRE(o.cell == 0.01);
  REQUIRE(o.end == 0.1);
  REQUIRE(std::abs(o.earth_pressure() - 0.33 / 0.67) < 1e-15);
  REQUIRE(o.points_in_element() == 28);
  REQUIRE(read({"--kinematics", "slice"}).points_in_element() == 10);
}

TEST_CASE("every option reaches its value") {
  std::ofstream{"file.msh"} << "$MeshFormat\n";
  const auto o = read({"--kinematics",
                       "slice",
                       "--device",
                       "elastic",
                       "--delta",
                       "40",
                       "--no-slip",
                       "--velocity",
                       "4",
                       "--mass",
                       "8",
                       "--friction",
                       "36",
                       "--young",
                       "6e6",
                       "--poisson",
                       "-0.1",
                       "--unit-weight",
                       "16000",
                       "--cohesion",
                       "1000",
                       "--dilatancy",
                       "5",
                       "--cell=0.02",
                       "--points-per-element",
                       "20",
                       "--contact",
                       "centre-of-mass",
                       "--anti-locking",
                       "off",
                       "--flip",
                       "0.9",
                       "--courant",
                       "0.25",
                       "--end",
                       "0.05",
                       "--threads",
                       "2",
                       "--mesh",
                       "file.msh",
                       "--fields-every",
                       "0",
                       "--out",
                       "a b",
                       "--quiet",
                       "--shoulder",
                       "fillet",
                       "--fillet",
                       "0.02",
                       "--moving-depth",
                       "0.1",
                       "--k0",
                       "0.4",
                       "--device-young",
                       "1e7",
                       "--device-poisson",
                       "0.2"});
  REQUIRE(o.kinematics == Kinematics::slice);
  REQUIRE(o.device == DeviceKind::elastic);
  REQUIRE(o.contact == ContactKind::centre_of_mass);
  REQUIRE(o.shoulder == Shoulder::fillet);
  REQUIRE((o.no_slip && o.quiet && !o.anti_locking));
  REQUIRE((o.delta == 40 && o.velocity == 4 && o.mass == 8 && o.friction == 36 && o.young == 6e6 &&
           o.poisson == -0.1));
  REQUIRE((o.unit_weight == 16000 && o.cohesion == 1000 && o.dilatancy == 5 && o.cell == 0.02));
  REQUIRE(
      (o.points_in_element() == 20 && o.flip == 0.9 && o.courant == 0.25 && o.end == 0.05 && o.threads == 2));
  REQUIRE((o.mesh == "file.msh" && o.fields_every == 0 && o.out == "a b" && o.fillet == 0.02));
  REQUIRE((o.moving_depth == 0.1 && o.earth_pressure() == 0.4 && o.device_young == 1e7 &&
           o.device_poisson == 0.2));
  REQUIRE(read({"--cell", "0.02", "--cell", "0.03"}).cell == 0.03);  // the last one wins, as scripts expect
}

TEST_CASE("a mistake is one sentence with option, value and rule") {
  REQUIRE(refusal({"drop", "--poisson", "0.6"}) == "--poisson = 0.6: must lie in (-1, 0.5)");
  REQUIRE(refusal({"drop", "--cell", "abc"}) == "--cell = abc: must be a number");
  REQUIRE(refusal({"drop", "--cell", "1e-2x"}) == "--cell = 1e-2x: must be a number");
  REQUIRE(refusal({"drop", "--cell", "nan"}) == "--cell = nan: must lie in [0.0025, 0.04] m");
  REQUIRE(refusal({"drop", "--threads", "2.5"}) == "--threads = 2.5: must be a whole number");
  REQUIRE(refusal({"drop", "--device", "soft"}) == "--device = soft: must be rigid or elastic");
  REQUIRE(refusal({"drop", "--cell"}) == "--cell = : needs a value");
  REQUIRE(refusal({"drop", "--out=", "--quiet"}) == "--out = : needs a value");
  REQUIRE(refusal({"drop", "--out", "--quiet"}) == "--out = --quiet: must be a name, not the next option");
  REQUIRE(refusal({"drop", "--quiet=maybe"}) == "--quiet = maybe: takes no value");
  REQUIRE(refusal({"drop", "--foo", "3"}).find("--foo: no such option") == 0);
  REQUIRE(refusal({"drop", "stray"}).find("stray: a word without an option") == 0);
  REQUIRE(refusal({}).find("command: must be drop") == 0);
  REQUIRE(refusal({"drop", "--mesh", "absent.msh"}) ==
          "--mesh = absent.msh: must be a file that can be read");
  REQUIRE(refusal({"drop", "--points-per-element", "9", "--kinematics", "slice"})
              .find("--points-per-element = 9: must be") == 0);
  REQUIRE(refusal({"drop", "--points-per-element", "7"}).find("--points-per-element = 7: must be") == 0);
}

TEST_CASE("every range has both ends") {
  using Case = std::array<const char*, 3>;
  for (const auto& [option, below, above] : {Case{"--delta", "-1", "61"},
                                             Case{"--velocity", "0", "51"},
                                             Case{"--mass", "0", "1e6"},
                                             Case{"--friction", "0", "61"},
                                             Case{"--young", "0", "1e11"},
                                             Case{"--poisson", "-1", "0.5"},
                                             Case{"--unit-weight", "0", "1e6"},
                                             Case{"--cohesion", "-1", "1e7"},
                                             Case{"--dilatancy", "-1", "41"},
                                             Case{"--cell", "0.002", "0.05"},
                                             Case{"--points-per-element", "0", "100"},
                                             Case{"--flip", "-0.1", "1.1"},
                                             Case{"--courant", "0", "1.1"},
                                             Case{"--end", "0", "11"},
                                             Case{"--threads", "-1", "2000"},
                                             Case{"--fields-every", "-1", "11"},
                                             Case{"--moving-depth", "0", "0.4"},
                                             Case{"--fillet", "0", "0.1"},
                                             Case{"--k0", "-0.1", "4"},
                                             Case{"--device-young", "0", "1e13"},
                                             Case{"--device-poisson", "-1", "0.5"}}) {
    for (const char* value : {below, above, "nan", "inf", ""}) {
      INFO(option << " " << value);
      const std::string text = refusal({"drop", option, value});
      REQUIRE(text.rfind(std::string{option} + " = ", 0) == 0);
      REQUIRE(text.find(": must ") != std::string::npos);
      REQUIRE(text.find('\n') == std::string::npos);
    }
  }
}

TEST_CASE("help goes to the stream and names every option") {
  std::ostringstream help;
  REQUIRE(!read_command_line({"drop", "--help"}, help).has_value());
  for (const char* option :
       {"--kinematics axisymmetric|slice", "--delta DEG", "--points-per-element N", "--mesh FILE.msh",
        "--anti-locking on|off", "--contact rigid|centre-of-mass", "--quiet", "Exit code"})
    REQUIRE(help.str().find(option) != std::string::npos);
  std::ostringstream top;
  REQUIRE(!read_command_line({"--help"}, top).has_value());
  REQUIRE(top.str().find("drop") != std::string::npos);
}
