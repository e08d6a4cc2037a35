// The paper's cases, and the table that compares their results with the paper's numbers.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "../../examples/ffp/command/read_paper.hpp"
#include "../../examples/ffp/paper/paper_table.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::ffp;

namespace {

PaperOptions options(const std::vector<std::string>& words) {
  std::ostringstream answer;
  const auto o = read_paper(words, answer);
  REQUIRE(o.has_value());
  return *o;
}

/// A run that ends at `depth`, m, on a straight line from 0 at 0 s to 0.1 s.
CaseResult ended(double depth, double peak) {
  CaseResult r;
  r.summary = {{"status", "done"},
               {"final_penetration_m", depth},
               {"max_penetration_m", depth},
               {"peak_deceleration_g", peak},
               {"second_peak_deceleration_g", nullptr}};
  for (int i = 0; i <= 10; ++i) {
    r.time.push_back(i * 0.01);
    r.depth.push_back(depth * i / 10);
    r.step.push_back(i == 0 ? 0 : 0.01);
  }
  return r;
}

const Comparison& line(const std::vector<Comparison>& all, const std::string& model,
                       const std::string& quantity) {
  for (const Comparison& c : all)
    if (c.model == model && c.quantity == quantity) return c;
  throw error("no line " + quantity);
}

}  // namespace

TEST_CASE("cases of the paper: names, folders and what they are given") {
  std::set<std::string> names;
  for (const PaperCase& c : paper_cases(options({"--out", "a"}))) {
    REQUIRE(names.insert(c.name).second);
    REQUIRE(c.options.out == "a/" + c.name);
    REQUIRE_NOTHROW(check(c.options));
    REQUIRE((c.options.resume && c.options.quiet));
    if (c.options.kinematics == Kinematics::slice) REQUIRE(c.options.points_in_element() == 10);
    if (c.options.device == DeviceKind::elastic) REQUIRE(c.options.law.kind == LawKind::mohr_coulomb);
  }
  REQUIRE(names.size() == 18);
  for (const char* name :
       {"rigid-20", "elastic-40", "rigid-32-log-rate", "slice-rigid-20", "slice-elastic-40"})
    REQUIRE(names.count(name) == 1);
  REQUIRE(paper_cases(options({"--quick"})).size() == 14);
  REQUIRE(paper_cases(options({"--quick", "--law", "mohr-coulomb"})).size() == 8);
  int barred = 0;
  for (const PaperCase& c : paper_cases(options({"--error-bar", "--anew"}))) {
    barred += c.options.error_bar;
    REQUIRE(!c.options.resume);
    REQUIRE_NOTHROW(check(c.options));
  }
  REQUIRE(barred == 4);
  REQUIRE_THROWS_WITH(options({"--error-bar", "--cell", "0.03"}),
                      "--cell = 0.03: must be at most 0.02 m with --error-bar");
}

TEST_CASE("the table: differences, bars, and nothing where no case is") {
  const auto o = options({"--quick"});
  CaseResults results{{"rigid-20", ended(0.22, 18)}, {"rigid-40", ended(0.11, 23)}};
  results["rigid-20"].summary["uncertainty"] = {{"final_penetration_m", {{"value", 0.22}, {"u", 0.03}}},
                                                {"peak_deceleration_g", {{"value", 18}, {"u", nullptr}}}};
  const auto all = paper_comparisons(o, results);
  const std::string model = "half-section, mohr-coulomb";
  const auto& depth = line(all, model, "final penetration, delta = 20 deg");
  REQUIRE(std::abs(*depth.ours - 22) < 1e-12);
  REQUIRE(std::abs(*depth.difference() - 2) < 1e-12);
  REQUIRE(std::abs(*depth.bar - 3) < 1e-12);
  REQUIRE(!line(all, model, "peak deceleration, delta = 20 deg").bar);
  REQUIRE(*line(all, model, "fully rough over 20 deg").ours == 0.5);
  REQUIRE(std::abs(*line(all, model, "depth at 25 ms, delta = 20 deg").ours - 5.5) < 1e-12);
  REQUIRE(std::abs(*line(all, model, "20 deg and rough part by 5 mm").ours - 10) < 1e-9);  // 11 mm, 0 before
  REQUIRE(!line(all, model, "peak deceleration, delta = 32 deg").ours);
  REQUIRE(!line(all, model, "greatest depth, elastic over rigid, 20 deg").ours);
  REQUIRE(!line(all, "half-section, log-rate", "final penetration, delta = 20 deg").ours);
  std::ostringstream table;
  print_paper_table(all, table);
  REQUIRE(table.str().find("20       22       +-3     +2 (+10 %)") != std::string::npos);
  results["rigid-20"].summary["status"] = "failed";
  REQUIRE(!line(paper_comparisons(o, results), model, "final penetration, delta = 20 deg").ours);
  const auto j = paper_json(o, paper_cases(o), results);
  REQUIRE((j["cases"][0]["status"] == "failed" && j["cases"][1]["status"] == "not run"));
}

TEST_CASE("a slice's critical step and cost") {
  CaseResults results{{"slice-rigid-20", ended(0.2, 17)}, {"slice-elastic-20", ended(0.2, 17)}};
  results["slice-rigid-20"].summary["wall_s"] = 3600;
  results["slice-elastic-20"].summary["wall_s"] = 7200;
  results["slice-elastic-20"].step[1] = 0.005;
  const auto all = paper_comparisons(options({}), results);
  const std::string model = "slice, mohr-coulomb";
  REQUIRE(std::abs(*line(all, model, "critical time step, rigid").ours - 0.02e6) <
          1e-6);  // over the Courant number
  REQUIRE(std::abs(*line(all, model, "critical time step, elastic").ours - 0.01e6) < 1e-6);
  REQUIRE(*line(all, model, "cost, elastic over rigid").ours == 2);
  REQUIRE(*line(all, model, "cost, rigid").ours == 1);
  // sqrt(E (1 - nu) / ((1 + nu) (1 - 2 nu)) / rho) of the paper's sand.
  REQUIRE(std::abs(arenite::ffp::sand_wave_speed() - 69.4) < 0.1);
}

TEST_CASE("results of a case are read from its folder, as far as it came") {
  std::filesystem::create_directories("case");
  REQUIRE(!result_of_case("nowhere").done());
  std::ofstream{"case/summary.json"} << R"({"status": "done", "steps": 2})";
  std::ofstream{"case/history.csv"}
      << "time_s,velocity_m_s,penetration_m,time_step_s\n0,5,0,0\n0.1,4,0.5,0.1\n0.2,3,0.";
  const auto r = result_of_case("case");
  REQUIRE(r.done());
  REQUIRE(*r.number("steps") == 2);
  REQUIRE(
      (r.time == std::vector<double>{0, 0.1} && r.depth == std::vector<double>{0, 0.5} && r.step[1] == 0.1));
  REQUIRE(!r.depth_at(0.15));
  std::ofstream{"case/history.csv"}  // as a spreadsheet saves it again
      << "\xef\xbb\xbftime_s;penetration_m;time_step_s\r\n0;0;0\r\n0,1;0,5;0,1\r\n";
  REQUIRE(result_of_case("case").depth == r.depth);
  std::ofstream{"case/history.csv"} << "time_s,penetration_m,time_step_s\n0,0,0\n0.1,deep,0.1\n";
  std::string what;
  try {
    result_of_case("case");
  } catch (const arenite::error& e) {
    what = e.what();
  }
  REQUIRE(what == "case/history.csv: line 3, column penetration_m = deep: must be a number");
}
