// Parts of a run's life: words in messages, what a folder's own files are, JSON, the number of steps.
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "../../examples/ffp/drop/drop.hpp"
#include "../../examples/ffp/drop/drop_folder.hpp"
#include "../../examples/ffp/drop/step_count.hpp"
#include "../../examples/ffp/text/json_file.hpp"
#include "../../examples/ffp/text/range.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::ffp;

TEST_CASE("ranges are those of their text") {
  const Range closed{0, 60, "deg"};
  REQUIRE((closed.contains(0) && closed.contains(60) && !closed.contains(-1e-9) && !closed.contains(60.1)));
  REQUIRE(closed.text() == "[0, 60] deg");
  REQUIRE((!above(0, 1).contains(0) && above(0, 1).contains(1)));
  REQUIRE(above(0, 50, "m/s").text() == "(0, 50] m/s");
  REQUIRE(
      (!between(-1, 0.5).contains(-1) && !between(-1, 0.5).contains(0.5) && between(-1, 0.5).contains(0)));
  for (const Range& r : {closed, above(0, 1), between(0, 1)})
    REQUIRE(!r.contains(std::numeric_limits<double>::quiet_NaN()));
}

TEST_CASE("text in messages is one line and not long") {
  REQUIRE(shown("a name") == "a name");
  REQUIRE(shown("two\nlines\tand\x1b[31m red\x7f") == "two lines and [31m red ");
  REQUIRE(shown(std::string(500, 'x'), 20) == "xxxxxxxxxx .. xxxxxxxxxx");
  const std::string umlauts = "\xc3\xa4\xc3\xb6\xc3\xbc\xc3\xa4\xc3\xb6\xc3\xbc";  // six of two bytes
  REQUIRE(shown(umlauts, 6) == "\xc3\xa4 .. \xc3\xbc");
  REQUIRE(shown("", 20).empty());
}

TEST_CASE("numbers in messages") {
  REQUIRE(exactly(0.499999999999) == "0.499999999999");
  REQUIRE(rounded(1955) == "1960");
  REQUIRE(rounded(-123456) == "-123000");
  REQUIRE(rounded(9.7725e11) == "9.77e+11");
  REQUIRE(rounded(0.19579) == "0.196");
  REQUIRE(rounded(0) == "0");
  REQUIRE((duration(2.2) == "3 s" && duration(600) == "10 min" && duration(7200) == "2 h" &&
           duration(36000) == "10 h" && duration(1e6) == "12 days"));
}

TEST_CASE("what a drop writes, and nothing else, is a result") {
  for (const char* own :
       {"summary.json", "history.csv", "fields.pvd", "fields_soil_0000.vtu", "fields_device_points_0012.vtu",
        "fields_mesh_12345.vtu", "fields_device_0003.vtu", "history.csv.part", "fields_soil_0000.vtu.part",
        "histories.png", "strain.png", "checkpoint.state", "checkpoint.state.part"})
    REQUIRE(is_result(own));
  for (const char* foreign : {"notes.txt", "history.csv.bak", "my_history.csv", "fields_soil_.vtu",
                              "fields_soil_00x0.vtu", "fields_soil_000.vtu", "fields_sand_0000.vtu",
                              "summary.json~", ".arenite-ffp.lock", "plot.png", ".part", ""})
    REQUIRE(!is_result(foreign));
}

TEST_CASE("JSON: what is none, is nested too deeply or gives a name twice is refused in a sentence") {
  Json j{{"whole", 20}, {"real", 20.0}, {"tenth", 0.1}, {"none", nullptr}};
  j["nan"] = std::numeric_limits<double>::quiet_NaN();
  j["absent"] = or_null({});
  j["bytes"] = "\xff-";  // no UTF-8
  REQUIRE(json_text(j) ==
          "{\"whole\":20,\"real\":20.0,\"tenth\":0.1,\"none\":null,\"nan\":null,\"absent\":null,"
          "\"bytes\":\"\xEF\xBF\xBD-\"}");
  for (const int indent : {-1, 0, 2})
    REQUIRE(json_text(parse_json(json_text(j, indent), "text")) == json_text(j));
  for (const char* text : {"", "{", "[1,]", "{\"a\"}", "01", "NaN", "1e999", "\"\xff\"", "1 1", "[1]]"})
    REQUIRE_THROWS_WITH(parse_json(text, "text"), Catch::Matchers::StartsWith("text: is no JSON ("));
  const auto nested = [](int levels) {
    return std::string(static_cast<std::size_t>(levels), '[') +
           std::string(static_cast<std::size_t>(levels), ']');
  };
  REQUIRE_NOTHROW(parse_json(nested(most_json_levels), "text"));
  for (const auto& deep : {nested(most_json_levels + 1), std::string(1000000, '[')})
    REQUIRE_THROWS_WITH(parse_json(deep, "text"), "text: is nested deeper than 64 levels");
  REQUIRE_NOTHROW(parse_json(R"([{"a": {"a": 1}}, {"a": 2}])", "text"));
  REQUIRE_THROWS_WITH(parse_json(R"([{"b": {"a": 1}, "b": 2}])", "text"), "text: gives b twice");
  Json wide = Json::object();
  for (std::size_t k = 0; k < most_json_names; ++k) wide[std::to_string(k)] = k;
  REQUIRE_NOTHROW(parse_json(json_text(wide), "text"));
  wide["more"] = 1;
  REQUIRE_THROWS_WITH(parse_json(json_text(wide), "text"), "text: has an object of more than 1000 names");
  std::mt19937 random{5};
  const std::string good = R"({"a": [1, 2.5e-3, "x\u00e9\n", true, null], "b": {"c": {}}})";
  for (int k = 0; k < 20000; ++k) {  // cut or damaged anywhere: a value, or a sentence
    std::string text = good.substr(0, random() % (good.size() + 1));
    if (!text.empty()) text[random() % text.size()] = static_cast<char>(random());
    try {
      parse_json(text, "text");
    } catch (const error&) {
    }
  }
}

TEST_CASE("a folder is made, cleaned only of results, and can be used again") {
  namespace fs = std::filesystem;
  fs::remove_all("folder");
  const auto write = [](const char* name) { std::ofstream{name} << "old\n"; };
  { const RunFolder made = drop_folder("folder/in/folder"); }
  REQUIRE(fs::is_directory("folder/in/folder"));
  for (const char* name : {"folder/summary.json", "folder/history.csv", "folder/fields_soil_0007.vtu",
                           "folder/notes.txt", "folder/fields.txt"})
    write(name);
  fs::create_directory("folder/fields_mesh_0000.vtu");  // not what a drop writes
  for (int again = 0; again < 2; ++again) {
    RunFolder taken = drop_folder("folder");
    REQUIRE((!fs::exists("folder/summary.json") && !fs::exists("folder/history.csv") &&
             !fs::exists("folder/fields_soil_0007.vtu")));
    REQUIRE((fs::exists("folder/notes.txt") && fs::exists("folder/fields.txt") &&
             fs::exists("folder/fields_mesh_0000.vtu")));
    REQUIRE(fs::file_size("folder/.arenite-ffp.lock") > 0);  // space for the summary of a full disk
    taken.free_reserve();
    REQUIRE(fs::file_size("folder/.arenite-ffp.lock") == 0);
  }
  write("a_file");
  REQUIRE_THROWS_WITH(drop_folder("a_file"), Catch::Contains("--out = a_file: "));
  REQUIRE_THROWS_WITH(drop_folder("a_file/below"), Catch::Contains("--out = a_file/below: "));
}

TEST_CASE("too many steps: the option is named that makes them") {
  const auto cause = [](auto change) {
    DropOptions o;
    change(o);
    return cause_of_steps(o, 1e-9);
  };
  REQUIRE(cause([](DropOptions& o) { o.courant = 1e-9; }) == "--courant = 1e-09");
  REQUIRE(cause([](DropOptions& o) { o.poisson = 0.499999999999; }) == "--poisson = 0.499999999999");
  REQUIRE(cause([](DropOptions& o) { o.poisson = -0.9999999; }) == "--poisson = -0.9999999");
  REQUIRE(cause([](DropOptions& o) { o.young = 1e10; }) == "--young = 1e+10");
  REQUIRE(cause([](DropOptions& o) { o.end = 10; }) == "--end = 10");
  REQUIRE(cause([](DropOptions& o) { o.unit_weight = 1000; }) == "--unit-weight = 1000");
  REQUIRE(cause([](DropOptions& o) { o.mesh = "slivers.msh"; }) ==
          "--mesh = slivers.msh (smallest cell 1e-09 m)");
  // A rigid penetrometer's modulus does not matter.
  REQUIRE(cause([](DropOptions& o) { o.device_young = 1e12, o.courant = 0.1; }) == "--courant = 0.1");
  REQUIRE(cause([](DropOptions& o) { o.device_young = 1e12, o.device = DeviceKind::elastic; }) ==
          "--device-young = 1e+12");
}

TEST_CASE("a drop names the unit that computes it") {
  DropOptions o;
  REQUIRE(unit_of(o) == "default");
  o.delta = 40;  // a number
  REQUIRE(unit_of(o) == "default");
  o.kinematics = Kinematics::slice;
  REQUIRE(unit_of(o) == "slice");
  o.law.kind = LawKind::softening;
  REQUIRE(unit_of(o) == "slice-law");
  o = {};
  o.device = DeviceKind::elastic;
  REQUIRE(unit_of(o) == "axisymmetric-elastic");
  o = {};
  o.contact = ContactKind::centre_of_mass;
  REQUIRE(unit_of(o) == "axisymmetric-centre-of-mass");
  o = {};
  o.anti_locking = false;
  REQUIRE(unit_of(o) == "axisymmetric-no-averages");
  o.mesh_kind = MeshKind::grid;  // whose law and contact are chosen at run time
  o.law.kind = LawKind::mu_i;
  REQUIRE(unit_of(o) == "grid");
  o.kinematics = Kinematics::space;
  REQUIRE(unit_of(o) == "space");
}
