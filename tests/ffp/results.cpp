// Filter, peaks, history and summary of a drop, against closed forms.
#include "../../examples/ffp/drop/results.hpp"
#include "../../examples/ffp/drop/peaks.hpp"
#include "../../examples/ffp/drop/summary_file.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "catch.hpp"

using namespace arenite;
using namespace arenite::ffp;

namespace {

/// Uneven times from 0 to `end`.
std::vector<double> uneven_times(double end, double step) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> factor{0.3, 1.7};
  std::vector<double> t{0};
  while (t.back() < end) t.push_back(t.back() + step * factor(random));
  return t;
}

}  // namespace

TEST_CASE("moving average: the change of velocity over the window, exactly, at uneven steps") {
  const auto t = uneven_times(0.05, 1e-4);
  std::vector<double> v, a(1, 0.0);  // v = sin(100 t) at the times, and the step accelerations that make it
  for (const double s : t) v.push_back(std::sin(100 * s));
  for (std::size_t i = 1; i < t.size(); ++i) a.push_back((v[i] - v[i - 1]) / (t[i] - t[i - 1]));
  const auto velocity = [&](double s) {
    const auto i = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), s) - t.begin());
    return v[i - 1] + (v[i] - v[i - 1]) * (s - t[i - 1]) / (t[i] - t[i - 1]);
  };
  const auto mean = moving_average(t, a, 2e-3);
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t[i] < 1.1e-3 || t[i] > t.back() - 1.1e-3) continue;
    REQUIRE(std::abs(mean[i] - (velocity(t[i] + 1e-3) - velocity(t[i] - 1e-3)) / 2e-3) < 1e-9);
  }
}

TEST_CASE("moving average: a constant stays, a ramp stays inside, a sine shrinks by sin(x)/x") {
  const auto t = uneven_times(0.1, 2e-5);
  std::vector<double> constant(t.size(), 3.0), ramp(1, 0.0), sine(1, 0.0);
  const double w = 300;  // rad/s
  for (std::size_t i = 1; i < t.size(); ++i) {
    ramp.push_back((t[i] + t[i - 1]) / 2);  // means of each step
    sine.push_back((std::cos(w * t[i - 1]) - std::cos(w * t[i])) / (w * (t[i] - t[i - 1])));
  }
  const double window = 2e-3, shrink = std::sin(w * window / 2) / (w * window / 2);
  const auto c = moving_average(t, constant, window), r = moving_average(t, ramp, window);
  const auto s = moving_average(t, sine, window);
  for (std::size_t i = 0; i < t.size(); ++i) {
    REQUIRE(std::abs(c[i] - 3) < 1e-11);
    if (t[i] < 1.1e-3 || t[i] > t.back() - 1.1e-3) continue;
    REQUIRE(std::abs(r[i] - t[i]) <
            1e-6);  // the window's ends cut steps: an error of a step squared over the window
    REQUIRE(std::abs(s[i] - shrink * std::sin(w * t[i])) < 1e-3);
  }
  // A single spike of one step of 20 us and 100 g is 1 g over 2 ms.
  const std::vector<double> times{0, 0.01, 0.01002, 0.02}, spike{0, 0, 100, 0};
  REQUIRE(std::abs(moving_average(times, spike, 2e-3)[2] - 1) < 1e-12);
}

TEST_CASE("moving average: what does not fit is refused") {
  REQUIRE_THROWS_AS(moving_average({0, 1}, {0}, 1), error);
  REQUIRE_THROWS_AS(moving_average({0, 0}, {0, 1}, 1), error);
  REQUIRE_THROWS_AS(moving_average({0, 1}, {0, 1}, 0), error);
  REQUIRE(moving_average({0}, {5}, 1) == std::vector<double>{5});
}

TEST_CASE("peaks: the second one follows a valley; wiggles are none") {
  const auto two = find_peaks({0, 5, 16, 15.5, 16, 9, 2, 3, 8, 4, -1, 1, 0});
  REQUIRE(two.first == 2);
  REQUIRE(two.second.has_value());
  REQUIRE(*two.second == 8);
  const auto one = find_peaks({0, 5, 16, 15, 15.9, 9, 2, 2.5, 1, 0});
  REQUIRE(one.first == 2);
  REQUIRE(!one.second.has_value());
  REQUIRE_THROWS_AS(find_peaks({}), error);
}

TEST_CASE("figures and summary of a braking that is known: v = 5.6 cos(w t), so a = 5.6 w sin(w t)") {
  const double w = 30, g = standard_gravity;
  std::vector<HistoryRow> history;
  for (int i = 0; i <= 4000; ++i) {
    const double t = i * 2e-5, dt = 2e-5;
    HistoryRow row{
        .time_s = t, .penetration_m = 5.6 / w * std::sin(w * t), .velocity_m_s = 5.6 * std::cos(w * t)};
    if (i > 0) row.acceleration_m_s2 = 5.6 * (std::cos(w * (t - dt)) - std::cos(w * t)) / dt;
    row.kinetic_energy_J = 7.71 / 2 * square(row.velocity_m_s);
    row.external_work_J = 7.71 * g * row.penetration_m;
    row.transfer_loss_J = 3e-3 * t;
    row.wall_loss_J = 2e-3 * t;
    row.energy_residual_J = 1e-3 * t;
    history.push_back(row);
  }
  const auto f = figures_of(history);
  const double shrink = std::sin(w * 1e-3) / (w * 1e-3);
  REQUIRE(std::abs(f.peak.value_g - 5.6 * w / g * shrink) < 1e-4 * f.peak.value_g);
  REQUIRE(std::abs(f.peak.time_s - pi / 2 / w) < 3e-5);
  REQUIRE(std::abs(f.peak.penetration_m - 5.6 / w) < 1e-6);
  REQUIRE(std::abs(f.raw_peak.value_g - 5.6 * w / g) < 1e-4 * f.raw_peak.value_g);
  REQUIRE(std::isnan(f.second.value_g));
  REQUIRE(std::abs(f.max_penetration_m - 5.6 / w) < 1e-6);
  REQUIRE(f.final_penetration_m == history.back().penetration_m);
  REQUIRE(std::abs(f.dt_min_s - 2e-5) < 1e-12);
  const double in = 7.71 / 2 * 5.6 * 5.6 + 7.71 * g * f.final_penetration_m;
  REQUIRE(std::abs(f.energy_transfer - 24e-5 / in) < 1e-12);
  REQUIRE(std::abs(f.energy_walls - 16e-5 / in) < 1e-12);
  REQUIRE(std::abs(f.energy_residual - 8e-5 / in) < 1e-12);

  DropOptions options;
  options.kinematics = Kinematics::slice;
  const auto j =
      summary_of(options, f, {.points = 10, .steps = 4000, .wall_s = 2, .point_steps = 40000, .threads = 2});
  for (const char* key : {"final_penetration_m",
                          "max_penetration_m",
                          "peak_deceleration_g",
                          "peak_time_s",
                          "peak_penetration_m",
                          "raw_peak_deceleration_g",
                          "points",
                          "steps",
                          "dt_min_s",
                          "dt_max_s",
                          "wall_s",
                          "point_steps_per_s",
                          "threads",
                          "lost_points",
                          "energy_transfer",
                          "energy_walls",
                          "energy_residual",
                          "inputs",
                          "peak_filter",
                          "status"})
    REQUIRE(j.contains(key));
  REQUIRE(j["point_steps_per_s"] == 20000);
  REQUIRE(j["inputs"]["kinematics"] == "slice");
  REQUIRE(j["inputs"]["points_per_element"] == 10);
  REQUIRE(json_text(j).find("\"second_peak_deceleration_g\":null") != std::string::npos);
  REQUIRE(j["status"] == "done");
  REQUIRE(j["version"] == library_version);
  // Before the first row: how it stands, and the inputs.
  const auto running = summary_of(options, std::nullopt, {.status = "running", .process = 7});
  REQUIRE(running["status"] == "running");
  REQUIRE(running["process_id"] == 7);
  REQUIRE(running["inputs"] == j["inputs"]);
  REQUIRE(!running.contains("final_penetration_m"));
  // The hash distinguishes inputs, and the content of a mesh.
  REQUIRE(running["inputs_hash"] == j["inputs_hash"]);
  REQUIRE(j["inputs_hash"].get<std::string>().size() == 16);
  std::set<std::string> hashes{hash_of_inputs({}), hash_of_inputs(options)};
  options.mesh = "hashed.msh";
  for (const char* content : {"a", "b"}) {
    std::ofstream{options.mesh} << content;
    hashes.insert(hash_of_inputs(options));
  }
  REQUIRE(hashes.size() == 4);
  options.mesh = "\xff\xfe.msh";  // no UTF-8
  REQUIRE(json_text(inputs_of(options)).find("\"mesh\":\"\xEF\xBF\xBD\xEF\xBF\xBD.msh\"") !=
          std::string::npos);
  DropOptions told;
  told.out = "out/a";
  REQUIRE(sentence_of(f, told).ends_with("Files: out/a"));
  REQUIRE(sentence_of(f, told).find("tilted") == std::string::npos);
  told.kinematics = Kinematics::space;
  DropFigures leaning = f;
  leaning.final_tilt_deg = 12;
  leaning.final_aside_m = 0.031;
  REQUIRE(sentence_of(leaning, told)
              .find(" ms, tilted by 12 deg and 0.031 m to the side that it pointed to (deepest") !=
          std::string::npos);
  write_json("summary.json", j);
  REQUIRE(summary_in(".") == parse_json(json_text(j), "text"));
  REQUIRE(summary_in(".")["steps"] == 4000);
  REQUIRE_THROWS_AS(figures_of({}), error);
}

TEST_CASE("history file: the header that everybody relies on, and rows") {
  {
    HistoryFile file{"history.csv", false};
    file.write({.time_s = 0.5, .penetration_m = 0.25, .reaction_N = 2, .mean_volume_ratio = 1.5});
  }
  std::ifstream file{"history.csv"};
  std::string header, row;
  std::getline(file, header);
  std::getline(file, row);
  REQUIRE(header.rfind("time_s,penetration_m,velocity_m_s,acceleration_m_s2,reaction_N,", 0) == 0);
  REQUIRE(row == "0.5,0.25,0,0,2,0,0,0,0,0,0,0,0,0,0,0,0,1.5");
  {
    HistoryFile without{"history.csv", false};  // nothing touches: an empty field
    without.write({.fill_ratio = std::numeric_limits<double>::quiet_NaN()});
  }
  std::ifstream again{"history.csv"};
  std::getline(again, header);
  std::getline(again, row);
  REQUIRE(row == "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,,1");
  REQUIRE_THROWS_AS((HistoryFile{"no/such/folder/history.csv", false}), error);
}
