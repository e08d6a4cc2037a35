// The command line of the drop: defaults are the paper's case; whatever is wrong becomes one sentence.
#include "../../examples/ffp/command/values.hpp"

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "read_words.hpp"

using namespace arenite;
using namespace arenite::ffp;

TEST_CASE("without options: the paper's case") {
  const auto o = read({});
  REQUIRE(o.kinematics == Kinematics::axisymmetric);
  REQUIRE(o.device == DeviceKind::rigid);
  REQUIRE(o.delta == 20);
  REQUIRE(o.velocity == 5.6);
  REQUIRE(o.device_mass() == 7.71);
  REQUIRE(o.friction == 40);
  REQUIRE(o.young == 5e6);
  REQUIRE(o.poisson == 0.33);
  REQUIRE(o.unit_weight == 15100);
  REQUIRE(o.cohesion == 0);
  REQUIRE(o.dilatancy == 0);
  REQUIRE(o.device_young == 20e6);
  REQUIRE((o.cell_size() == 0.01 && o.courant_number() == 0.5));
  REQUIRE(o.end == 0.1);
  REQUIRE(std::abs(o.earth_pressure() - 0.33 / 0.67) < 1e-15);
  REQUIRE(o.points_in_element() == 28);
  REQUIRE(read({"--kinematics", "slice"}).points_in_element() == 10);
  REQUIRE((!o.on_grid() && o.contact_kind() == ContactKind::rigid && o.averages() &&
           o.flip_time_constant() == 0));
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
                       "--flip",
                       "0.9",
                       "--flip-time",
                       "0.1",
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
  REQUIRE((o.no_slip && o.quiet && o.averages()));
  REQUIRE(!read({"--anti-locking", "off"}).averages());
  for (const auto& [option, value] : {std::pair{"--device", "elastic"}, {"--contact", "centre-of-mass"}})
    REQUIRE(refusal_of({"drop", "--anti-locking", "off", option, value}) ==
            "--anti-locking = off: needs --device rigid and --contact rigid");
  REQUIRE((o.delta == 40 && o.velocity == 4 && o.mass == 8 && o.friction == 36 && o.young == 6e6 &&
           o.poisson == -0.1));
  REQUIRE((o.unit_weight == 16000 && o.cohesion == 1000 && o.dilatancy == 5 && o.cell == 0.02));
  REQUIRE((o.points_in_element() == 20 && o.flip == 0.9 && o.flip_time == 0.1 && o.courant == 0.25 &&
           o.end == 0.05 && o.threads == 2));
  REQUIRE((o.mesh == "file.msh" && o.fields_every == 0 && o.out == "a b" && o.fillet == 0.02));
  REQUIRE((o.moving_depth == 0.1 && o.earth_pressure() == 0.4 && o.device_young == 1e7 &&
           o.device_poisson == 0.2));
  REQUIRE(read({"--cell", "0.02", "--cell", "0.03"}).cell == 0.03);  // the last one wins, as scripts expect
}

TEST_CASE("a mistake is one sentence with option, value and rule") {
  REQUIRE(refusal_of({"drop", "--poisson", "0.6"}) == "--poisson = 0.6: must lie in (-1, 0.5)");
  REQUIRE(refusal_of({"drop", "--cell", "abc"}) == "--cell = abc: must be a number");
  REQUIRE(refusal_of({"drop", "--cell", "1e-2x"}) == "--cell = 1e-2x: must be a number");
  REQUIRE(refusal_of({"drop", "--cell", "nan"}) == "--cell = nan: must lie in [0.0025, 0.04] m");
  REQUIRE(refusal_of({"drop", "--threads", "2.5"}) == "--threads = 2.5: must be a whole number");
  REQUIRE(refusal_of({"drop", "--device", "soft"}) == "--device = soft: must be rigid or elastic");
  REQUIRE(refusal_of({"drop", "--cell"}) == "--cell = : needs a value");
  REQUIRE(refusal_of({"drop", "--out=", "--quiet"}) == "--out = : needs a value");
  REQUIRE(refusal_of({"drop", "--out", "--quiet"}) == "--out = --quiet: must be a name, not the next option");
  REQUIRE(refusal_of({"drop", "--quiet=maybe"}) == "--quiet = maybe: takes no value");
  REQUIRE(refusal_of({"drop", "--foo", "3"}).find("--foo: no such option") == 0);
  REQUIRE(refusal_of({"drop", "stray"}).find("stray: a word without an option") == 0);
  REQUIRE(refusal_of({}).find("command: must be drop") == 0);
  REQUIRE(refusal_of({"drop", "--poisson", "0.5000000000001"}) ==
          "--poisson = 0.5000000000001: must lie in (-1, 0.5)");
  REQUIRE(refusal_of({"drop", "--poisson", "-0.5"}).find("--poisson = -0.5: must give an earth pressure") ==
          0);
  REQUIRE(read({"--poisson", "-0.5", "--k0", "0.4"}).earth_pressure() == 0.4);
  REQUIRE(refusal_of({"drop", "--young", "1e999"}).find("--young = 1e999: must be a number of") == 0);
  REQUIRE(refusal_of({"drop", "--force=1"}) == "--force = 1: takes no value");
  REQUIRE(refusal_of({"drop", "--mesh", "absent.msh"}) == "--mesh = absent.msh: no such file");
  REQUIRE(refusal_of({"drop", "--points-per-element", "9", "--kinematics", "slice"})
              .find("--points-per-element = 9: must be") == 0);
  REQUIRE(refusal_of({"drop", "--points-per-element", "7"}).find("--points-per-element = 7: must be") == 0);
}

TEST_CASE("long values and values of several lines are shown cut, on one line") {
  const std::string lines = "1\n2\r3\t4", longest(5000, '9');
  for (const std::string& value : {lines, longest})
    for (const char* option :
         {"--cell", "--threads", "--device", "--mesh", "--points-per-element", "--quiet"}) {
      const std::string text = refusal_of({"drop", std::string{option} + "=" + value});
      INFO(text);
      REQUIRE(text.find(std::string{option} + " = ") == 0);
      REQUIRE(text.size() < 300);
      REQUIRE(text.find_first_of("\n\r\t") == std::string::npos);
    }
  REQUIRE(refusal_of({"drop", longest}).size() < 300);
  REQUIRE(refusal_of({"drop", "--" + longest}).size() < 300);
  REQUIRE(refusal_of({longest}).size() < 300);
}

TEST_CASE("any words end in options, help or one short sentence") {
  std::mt19937 random{20240229};
  const auto pick = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>{0, n - 1}(random);
  };
  std::ostringstream help;
  read_command_line({"drop", "--help"}, help);
  std::vector<std::string> options;  // all that the help names
  std::istringstream tokens{help.str()};
  for (std::string word; tokens >> word;)
    if (word.starts_with("--")) options.push_back(word);
  REQUIRE(options.size() > 25);
  const std::vector<std::string> values{
      "0",    "1",    "-1",     "0.1", "28",        "1e-300",  "1e300",   "1e999",
      "nan",  "-inf", "0x10",   "+1",  "1,2",       "",        " ",       "-",
      "--",   "---",  "=",      "on",  "off",       "rigid",   "elastic", "slice",
      "drop", "help", "--help", "-h",  "--version", "--quiet", "\n",      "\xff\xfe",
      "%s%n", "{}",   "[1,2]",  "a=b", "@file",     "--out=",  "-1e3",    "999999999999999999999",
      "."};
  int accepted = 0, refused = 0;
  for (int call = 0; call < 3000; ++call) {
    std::vector<std::string> words;
    if (pick(20) > 0) words.push_back("drop");
    for (std::size_t n = pick(6); n > 0; --n) {
      std::string word = pick(3) > 0 ? options[pick(options.size())] : values[pick(values.size())];
      if (pick(4) == 0) word += "=" + values[pick(values.size())];
      if (pick(10) == 0) word[pick(std::max<std::size_t>(word.size(), 1))] = static_cast<char>(1 + pick(255));
      words.push_back(word);
      if (pick(2) == 0) words.push_back(values[pick(values.size())]);
    }
    std::string shown_words;
    for (const auto& word : words) shown_words += "'" + word + "' ";
    INFO("call " << call << ": " << shown_words);
    std::ostringstream answer;
    try {
      const auto o = read_command_line(words, answer);
      if (o) REQUIRE_NOTHROW(check(std::get<DropOptions>(*o)));
      REQUIRE(o.has_value() == answer.str().empty());
      ++accepted;
    } catch (const error& e) {
      const std::string text = e.what();
      REQUIRE(!text.empty());
      REQUIRE(text.size() < 400);
      for (const char c : text) REQUIRE((static_cast<unsigned char>(c) >= 0x20 && c != 0x7F));
      ++refused;
    }
  }
  REQUIRE(accepted > 100);
  REQUIRE(refused > 1000);
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
                                             Case{"--cell-at-cone", "0.0004", "0.05"},
                                             Case{"--split", "-1", "101"},
                                             Case{"--points-per-element", "0", "100"},
                                             Case{"--jitter", "-0.1", "1.1"},
                                             Case{"--jitter-seed", "-1", "1000000001"},
                                             Case{"--flip", "-0.1", "1.1"},
                                             Case{"--flip-time", "-1", "101"},
                                             Case{"--courant", "0", "1.1"},
                                             Case{"--end", "0", "11"},
                                             Case{"--threads", "-1", "2000"},
                                             Case{"--fields-every", "-1", "11"},
                                             Case{"--moving-depth", "0", "0.4"},
                                             Case{"--fillet", "0.0004", "0.1"},
                                             Case{"--contact-offset", "-0.021", "0.021"},
                                             Case{"--k0", "-0.1", "4"},
                                             Case{"--rate-time", "-1", "2"},
                                             Case{"--rate-smoothing", "-1", "2"},
                                             Case{"--mu-rise", "-1", "11"},
                                             Case{"--mu-inertia", "0", "101"},
                                             Case{"--grain-size", "0", "1"},
                                             Case{"--grain-density", "0", "1e5"},
                                             Case{"--per-decade", "-1", "11"},
                                             Case{"--reference-rate", "0", "1e7"},
                                             Case{"--dilatancy-per-decade", "-1", "11"},
                                             Case{"--residual-friction", "0", "61"},
                                             Case{"--residual-dilatancy", "-1", "61"},
                                             Case{"--decay", "-1", "1001"},
                                             Case{"--decay-cell", "0", "2"},
                                             Case{"--device-young", "0", "1e13"},
                                             Case{"--device-poisson", "-1", "0.5"},
                                             Case{"--watch-energy", "0", "1e7"},
                                             Case{"--watch-volume", "0", "1e7"},
                                             Case{"--watch-lost", "0", "1.1"}}) {
    for (const char* value : {below, above, "nan", "inf", ""}) {
      INFO(option << " " << value);
      const std::string text = refusal_of({"drop", option, value});
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
        "--anti-locking on|off", "--contact rigid|centre-of-mass|points", "--mesh-kind fitted|grid",
        "--quiet", "Exit code"})
    REQUIRE(help.str().find(option) != std::string::npos);
  // Ranges and defaults are those of the checks.
  for (const char* range : {"Angle of friction, in [1, 60] deg (default 40)", "in (0, 50] m/s (default 5.6)",
                            "in (-1, 0.5) (default 0.33)", "Earth pressure at rest", "in [0, 3]",
                            "that of --accuracy, in [0.0025, 0.04] m", "36 or 49 in triangles (default 28)",
                            "cells of a grid (default 9)",
                            "coarse 0.02 and 0.9, normal 0.01 and 0.5, fine 0.005 and 0.5 (default normal)"})
    REQUIRE(help.str().find(range) != std::string::npos);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--version"}, {"drop", "--version"}}) {
    std::ostringstream answer;
    REQUIRE(!read_command_line(words, answer).has_value());
    REQUIRE(answer.str() == std::string{"arenite-ffp "} + std::string(library_version) + "\n");
  }
  std::ostringstream top;
  REQUIRE(!read_command_line({"--help"}, top).has_value());
  for (const char* command : {"drop", "reduce", "paper"})
    REQUIRE(top.str().find(command) != std::string::npos);
}

TEST_CASE("values are the options that words are, and are checked by the same sentences") {
  const auto values = [](const char* text) {
    std::ostringstream answer;
    return command_of_values(parse_json(text, "values"), answer);
  };
  const auto drop = std::get<DropOptions>(*values(
      R"({"command": "drop", "options": {"delta": 40, "cell_at_cone": "0.002", "tip": "blunt", "anti_locking": false,
          "error_bar": true, "force": false, "split": 4, "points_per_element": null, "contact": "rigid"}})"));
  REQUIRE(drop.delta == 40);
  REQUIRE(drop.cell_at_cone == 0.002);
  REQUIRE(drop.tip == Tip::blunt);
  REQUIRE(!drop.averages());
  REQUIRE(drop.error_bar);
  REQUIRE(!drop.force);
  REQUIRE(drop.split == 4);
  REQUIRE(!drop.points_per_element);
  const auto reduce = std::get<ReduceOptions>(
      *values(R"({"command": "reduce", "file": "--a.csv", "options": {"medium": "water", "drag": 0.8}})"));
  REQUIRE(reduce.file == "--a.csv");
  REQUIRE(reduce.drag == 0.8);
  REQUIRE(std::get<PaperOptions>(*values(R"({"command": "paper", "options": {"quick": true}})")).quick);
  for (const auto& [option, value] : {std::pair{"delta", "x"},
                                      {"delta", "61"},
                                      {"delta", "1e999"},
                                      {"delta", ""},
                                      {"threads", "1.5"},
                                      {"tip", "round"},
                                      {"force", "1"},
                                      {"out", "--quiet"},
                                      {"mesh", "absent.msh"},
                                      {"input", "absent.json"}}) {
    const std::string text =
        joined_text({"{\"command\": \"drop\", \"options\": {\"", option, "\": \"", value, "\"}}"});
    REQUIRE_THROWS_WITH(values(text.c_str()), refusal_of({"drop", joined_text({"--", option, "=", value})}));
  }
  REQUIRE_THROWS_WITH(values(R"({"command": "drop", "options": {"detla": "20"}})"),
                      "--detla=20: no such option of drop");  // who gives values has no --help
  std::ostringstream answer;
  REQUIRE(!command_of_values(Json{{"command", "options"}, {"of", "drop"}}, answer));
  REQUIRE(parse_json(answer.str(), "options")[0]["option"] == "--kinematics");
}
