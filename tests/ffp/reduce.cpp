// The reduction of a record of deceleration: reading, impact, integration, resistance and correlations,
// against closed forms and published numbers.
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../../examples/ffp/reduce/reduction_files.hpp"
#include "catch.hpp"
#include "reductions.hpp"

using namespace arenite;
using namespace arenite::ffp;

namespace {

constexpr double g = standard_gravity;

/// A drop: at rest until 0.5 s, free fall of `fall` s, then the deceleration a(t), m/s^2, for `braking` s,
/// then rest.
template <class Braking>
std::vector<double> drop_of(double fall, double braking, double step, const Braking& a) {
  std::vector<double> record;
  for (int i = 0;; ++i) {
    const double t = i * step - 0.5;
    if (t > fall + braking + 0.6) return record;
    record.push_back(t < 0 ? 0 : t < fall ? -g : t < fall + braking ? a(t - fall) : 0);
  }
}

std::string table_of(const std::vector<double>& deceleration, double step) {
  std::string text = "time_s,deceleration_m_s2\n";
  for (std::size_t i = 0; i < deceleration.size(); ++i)
    text += joined_text({static_cast<double>(i) * step, ",", deceleration[i], "\n"});
  return text;
}

}  // namespace

TEST_CASE("constant deceleration: velocity, depth and time of a stone's throw") {
  const double fall = 5.6 / g, a = 17 * g, step = 5e-5;
  const auto file =
      written("constant.csv", table_of(drop_of(fall, 5.6 / a, step, [&](double) { return a; }), step));
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{}, {"--impact-velocity", "5.6"}, {"--threshold", "2"}}) {
    const auto r = reduced(file, words);
    REQUIRE(r.motion.velocity_from ==
            (words.size() == 2 && words[0] == "--impact-velocity" ? "given" : "release"));
    REQUIRE(std::abs(r.motion.impact_time - 0.5 - fall) < 1.01 * step);
    REQUIRE(std::abs(r.motion.impact_velocity - 5.6) < 2e-2);
    REQUIRE(std::abs(r.greatest_depth - 5.6 * 5.6 / 2 / a) < 5e-4);
    REQUIRE(r.motion.stop.has_value());
    REQUIRE(std::abs(*r.motion.stop - 5.6 / a) < 2e-4);
    REQUIRE(std::abs(r.peak_g() - 17) < 1e-9);
    REQUIRE(std::abs(*r.motion.velocity_left) < 2e-2);
    REQUIRE(std::abs(*estimate(r, "firmness factor").value - 17 / (5.6 / a * 5.6)) < 1);
  }
}

TEST_CASE("a known motion integrates back to its depth, by the error of the trapezoid") {
  // a = a0 sin(w t) for half a period takes 2 a0 / w of velocity, and goes pi / w of time at its mean.
  const double w = 60, a0 = 5.6 * w / 2, depth = 5.6 * pi / w / 2;
  std::vector<double> errors;
  for (const double step : {1e-3, 5e-4, 2.5e-4}) {
    std::string text = "t [ms];Acceleration (g)\n";
    for (int i = 0; i * step < pi / w; ++i)
      text += joined_text({i * step * 1e3, ";", a0 * std::sin(w * i * step) / g, "\n"});
    const auto r = reduced(written("sine.csv", text), {"--impact-time", "0", "--impact-velocity", "5.6"});
    errors.push_back(
        std::abs(r.motion.depth.back() - (5.6 * r.motion.time.back() - a0 / w * r.motion.time.back() +
                                          a0 / w / w * std::sin(w * r.motion.time.back()))));
    REQUIRE(std::abs(r.motion.depth.back() - depth) < 2e-4);
  }
  REQUIRE(errors[0] < 1e-4);
  REQUIRE(errors[1] < errors[0] / 3.5);  // second order
  REQUIRE(errors[2] < errors[1] / 3.5);
}

TEST_CASE("without release the velocity is integrated back from rest; without either it must be given") {
  const double a = 15 * g, step = 5e-4;
  auto record = drop_of(0.3, 5.6 / a, step, [&](double) { return a; });
  record.erase(record.begin(), record.begin() + 1100);  // begins in the fall
  const auto r = reduced(written("from_rest.csv", table_of(record, step)));
  REQUIRE(r.motion.velocity_from == "rest");
  REQUIRE(std::abs(r.motion.impact_velocity - 5.6) < 0.1);
  REQUIRE(std::abs(*r.motion.stop - 5.6 / a) < 2e-3);
  record.resize(static_cast<std::size_t>((0.3 - 0.05 + 0.02) / step));  // ends while it brakes
  REQUIRE(holds(refusal(written("cut.csv", table_of(record, step))), "give --impact-velocity"));
  const auto cut = reduced("cut.csv", {"--impact-velocity", "5.6"});
  REQUIRE(!cut.motion.stop.has_value());
  REQUIRE(!estimate(cut, "firmness factor").value.has_value());
}

TEST_CASE("an accelerometer that reads 1 g at rest, one that is upside down, one that is off") {
  const double a = 17 * g, step = 5e-4;
  const auto net = drop_of(0.5, 0.03, step, [&](double) { return a; });
  const double depth = reduced(written("net.csv", table_of(net, step))).greatest_depth;
  auto other = net;
  for (double& value : other) value += g;
  REQUIRE(
      std::abs(reduced(written("proper.csv", table_of(other, step)), {"--reads", "proper"}).greatest_depth -
               depth) < 1e-9);
  other = net;
  for (double& value : other) value = -value;
  REQUIRE(std::abs(reduced(written("down.csv", table_of(other, step)), {"--invert"}).greatest_depth - depth) <
          1e-12);
  other = net;
  for (double& value : other) value += 0.15 * g;
  const auto off = reduced(written("off.csv", table_of(other, step)), {"--zero-at-rest"});
  REQUIRE(std::abs(off.taken_off - 0.15 * g) < 1e-9);
  REQUIRE(std::abs(off.greatest_depth - depth) < 1e-6);
  REQUIRE(std::abs(reduced("off.csv", {"--threshold", "-0.7"}).greatest_depth - depth) > 1e-3);  // it matters
  auto fall = net;
  fall.erase(fall.begin(), fall.begin() + 1200);
  for (double& value : fall) value += 0.15 * g;  // the rest after the end is left
  const auto after = reduced(written("fall.csv", table_of(fall, step)), {"--zero-at-rest"});
  REQUIRE(std::abs(after.taken_off - 0.15 * g) < 1e-9);
  REQUIRE(after.motion.velocity_from == "rest");
  fall.resize(fall.size() - 1200);
  REQUIRE(holds(refusal(written("fall.csv", table_of(fall, step)), {"--zero-at-rest"}), "--zero-at-rest"));
}

TEST_CASE("bearing resistance: force over area, and its reduction by the rate") {
  const double a = 10 * g, step = 1e-4;
  written("bearing.csv", table_of(drop_of(0.5, 0.05, step, [&](double) { return a; }), step));
  const auto r = reduced("bearing.csv", {"--mass", "8", "--window", "0"});
  const Motion& m = r.motion;
  int seen = 0;
  for (std::size_t i = 0; i < m.time.size(); ++i) {
    if (std::isnan(r.q_dyn[1][i])) {
      REQUIRE((m.depth[i] < 0.02 || m.time[i] > *m.stop));
      continue;
    }
    const double radius = std::min(0.04375, m.depth[i] * std::tan(pi / 6));
    const double force = 8 * (m.deceleration[i] + g);
    REQUIRE(std::abs(r.q_dyn[1][i] / (force / pi / radius / radius / 1e3) - 1) < 1e-9);
    REQUIRE(std::abs(r.q_dyn[0][i] / r.q_dyn[1][i] - 0.5) < 1e-9);  // a cone of 60 deg: twice its base
    for (const QuasiStatic& q : r.quasi_static) {
      if (m.velocity[i] >= 0.02)
        REQUIRE(std::abs(q.columns[1][0][i] * (1 + q.k * std::log10(m.velocity[i] / 0.02)) / r.q_dyn[1][i] -
                         1) < 1e-9);
      REQUIRE(std::abs(q.columns[0][1][i] * (1 + q.k / std::log(10.) * std::asinh(m.velocity[i] / 0.02)) /
                           r.q_dyn[0][i] -
                       1) < 1e-9);
    }
    ++seen;
  }
  REQUIRE(seen > 100);
  REQUIRE(!reduced_by_log(100, 1, 0.019));
  REQUIRE(*reduced_by_asinh(100, 1, 0) == 100);

  const auto wet =
      reduced("bearing.csv", {"--mass", "8", "--window", "0", "--medium", "water", "--water-density", "1000",
                              "--volume", "0.002", "--drag", "0.5", "--threshold", "-0.8"});
  const double area = pi * 0.04375 * 0.04375;
  for (std::size_t i = 0; i < wet.motion.time.size(); ++i)
    if (!std::isnan(wet.q_dyn[1][i]) && wet.motion.depth[i] > 0.08) {
      const double v = wet.motion.velocity[i],
                   force = 8 * 11 * g - 1000 * g * 0.002 - 0.5 * 500 * area * v * v;
      REQUIRE(std::abs(wet.q_dyn[1][i] / (force / area / 1e3) - 1) < 1e-6);
    }
}

TEST_CASE("tips have their own masses and areas") {
  const double a = 10 * g, step = 1e-4;
  written("tips.csv", table_of(drop_of(0.5, 0.05, step, [&](double) { return a; }), step));
  const auto blunt = reduced("tips.csv", {"--tip", "blunt", "--window", "0"}),
             parabolic = reduced("tips.csv", {"--tip", "parabolic", "--window", "0"});
  REQUIRE((blunt.mass == 10.30 && parabolic.mass == 9.15 && reduced("tips.csv").mass == 7.71));
  REQUIRE(reduced("tips.csv", {"--tip", "blunt", "--mass", "8"}).mass == 8);
  const double base = pi * 0.04375 * 0.04375;
  for (std::size_t i = 0; i < blunt.motion.time.size(); ++i) {
    if (std::isnan(blunt.q_dyn[1][i])) continue;
    const double q = 10.30 * (blunt.motion.deceleration[i] + g) / base / 1e3;
    REQUIRE(std::abs(blunt.q_dyn[1][i] / q - 1) < 1e-9);
    REQUIRE(std::abs(blunt.q_dyn[0][i] / q - 1) < 1e-9);  // its mantle is its base
    const double section = pi * 0.024184 * std::min(parabolic.motion.depth[i], 0.04375 * 0.04375 / 0.024184);
    REQUIRE(std::abs(parabolic.q_dyn[1][i] / (9.15 * (blunt.motion.deceleration[i] + g) / section / 1e3) -
                     1) < 1e-9);
  }
}

TEST_CASE("bands of K, and for which drops they are") {
  const auto dry = rate_bands(5.6, Medium::air, Soil::sand), wet = rate_bands(5.6, Medium::water, Soil::sand),
             clay = rate_bands(5.6, Medium::water, Soil::clay);
  REQUIRE(dry.size() == 4);
  REQUIRE((dry[0].low == 0.2 && dry[0].high == 0.4 && dry[1].low == 1 && dry[1].high == 1.5));
  REQUIRE(std::abs(dry[2].low - 1.736) < 1e-12);  // 1.74 at 5.6 m/s
  REQUIRE((!dry[0].within && !dry[1].within && dry[2].within && !dry[3].within));
  REQUIRE((wet[0].within && wet[1].within && !wet[2].within && !wet[3].within));
  REQUIRE((clay[3].within && !clay[0].within));
}

TEST_CASE("correlations: published numbers, and nothing outside of what they can say") {
  REQUIRE(std::abs(*firmness_factor(19.4, 0.060, 5.6).value - 57.7) < 0.05);
  REQUIRE(std::abs(*density_of_peak(17).value - 0.17) < 0.005);
  REQUIRE(std::abs(*density_of_peak(23).value - 0.28) < 0.005);
  for (const double peak : {5.0, 74.0, 150.0}) {
    REQUIRE(!density_of_peak(peak).value);
    REQUIRE(!density_of_peak(peak).outside.empty());
  }
  // D = 0.5 at p' = 100 kPa needs q = 300 x 100^0.46 x e^1.48.
  const double q = 300 * std::pow(100, 0.46) * std::exp(0.5 * 2.96);
  const auto inside = density_of_resistance(q, 150, 0.5, "q");
  REQUIRE(std::abs(*inside.value - 0.5) < 1e-12);
  REQUIRE(inside.outside.empty());
  REQUIRE(!density_of_resistance(10, 150, 0.5, "q").value);
  REQUIRE(!density_of_resistance(1e6, 150, 0.5, "q").value);
  REQUIRE(!density_of_resistance(0, 150, 0.5, "q").value);
  const auto shallow = density_of_resistance(1000, 2, 0.5, "q");
  REQUIRE((shallow.value && holds(shallow.outside, "2 kPa")));
  REQUIRE(holds(density_of_resistance(q, 150, 0.2, "q").outside, "K0 = 0.2"));
  const auto angle = friction_angle(inside, 101.325, 3, 2);
  REQUIRE(std::abs(*angle.value - 39) < 1e-12);  // at one atmosphere the logarithm is 0
  REQUIRE(std::abs(*friction_angle(inside, 10.1325, 3, 2).value - 43) < 1e-9);
  REQUIRE(std::abs(*friction_angle(inside, 10.1325, 2, 5).value - 43.5) < 1e-9);
  REQUIRE(holds(friction_angle(inside, 2, 3, 2).outside, "a stress of 2 kPa"));
  REQUIRE(holds(friction_angle(shallow, 20, 3, 2).outside, "outside its own"));
  REQUIRE(!friction_angle(density_of_peak(5), 20, 3, 2).value);
}

TEST_CASE("columns are found by many names; what is missing is said") {
  const double a = 12 * g, step = 1e-3;
  const auto record = drop_of(0.4, 0.03, step, [&](double) { return a; });
  const double depth = reduced(written("plain.csv", table_of(record, step))).greatest_depth;
  const auto with = [&](const std::string& header, double time, double unit, const char* mark) {
    std::string text = header + "\n";
    for (std::size_t i = 0; i < record.size(); ++i)
      text += joined_text(
          {static_cast<double>(i), mark, static_cast<double>(i) * step / time, mark, record[i] / unit, "\n"});
    return written("named.csv", text);
  };
  REQUIRE(std::abs(reduced(with("row,Time (ms),Decel [g]", 1e-3, g, ",")).greatest_depth - depth) < 1e-8);
  REQUIRE(std::abs(reduced(with("# a remark\nn;t_us;\"acceleration (m/s^2)\"", 1e-6, 1, ";")).greatest_depth -
                   depth) < 1e-8);
  REQUIRE(std::abs(reduced(with("BlueDrop 7, site 3\nn\ttime_sec\tacc_g", 1, g, "\t")).greatest_depth -
                   depth) < 1e-8);
  REQUIRE(std::abs(reduced(with("n time_s accel_m_s2\r", 1, 1, " ")).greatest_depth - depth) < 1e-8);
  REQUIRE(holds(refusal(with("n,time,acc_g", 1, g, ",")), "column = time: names no unit; write time_s"));
  REQUIRE(
      std::abs(reduced(with("n,time,acc", 1e-3, g, ","), {"--time-unit", "ms", "--deceleration-unit", "g"})
                   .greatest_depth -
               depth) < 1e-8);
  REQUIRE(holds(refusal(with("n,time_s,acc", 1, g, ",")), "column = acc: names no unit"));
  REQUIRE(refusal(with("n,time_s,pressure_kPa", 1, g, ",")) ==
          "named.csv: has no column of deceleration (deceleration_g, acceleration_m_s2 ..); its columns: n, "
          "time_s, "
          "pressure_kPa; give --column");
  REQUIRE(holds(refusal(with("a,b,c", 1, g, ",")), "has no column of time"));
}

TEST_CASE("bad records are refused in a sentence") {
  REQUIRE(refusal(written("empty.csv", "")) == "empty.csv: must be a file that can be read and is not empty");
  REQUIRE(refusal("absent.csv") == "FILE = absent.csv: there is no such file or folder");
  REQUIRE(holds(refusal(written("numbers.csv", "0,1\n1,2\n")), "line 1 is a row of numbers, and no header"));
  REQUIRE(holds(refusal(written("one.csv", "time_s,acc_g\n0,1\n")), "a record needs at least two"));
  REQUIRE(holds(refusal(written("back.csv", "time_s,acc_g\n0,-1\n0.1,2\n0.1,3\n")),
                "back.csv: line 4, column time_s = 0.1: must be greater than the time before, 0.1"));
  REQUIRE(refusal(written("word.csv", "time_s,acc_g\n0,-1\n0.1,much\n")) ==
          "word.csv: line 3, column acc_g = much: must be a number");
  REQUIRE(holds(refusal(written("short.csv", "time_s,acc_g\n0,-1\n0.1\n")),
                "line 3, number of fields = 1: must be 2"));
  REQUIRE(holds(refusal(written("nan.csv", "time_s,acc_g\n0,-1\n0.1,nan\n")), "must be a number"));
  REQUIRE(holds(refusal(written("down.csv", "time_s,acc_g\n0,1\n0.1,-4\n0.2,-1\n"),
                        {"--window", "0", "--threshold", "-0.9"}),
                "no sample before the peak lies at or below -0.9 g"));
  REQUIRE(holds(refusal(written("fast.csv", "time_s,acc_g\n0,-1\n0.1,-4\n0.2,-1\n")), "--invert"));
  REQUIRE(holds(refusal(written("late.csv", "time_s,acc_g\n0,-1\n0.1,4\n"), {"--impact-time", "0.1"}),
                "--impact-time = 0.1: must lie in the record, [0, 0.1) s"));
  std::filesystem::remove_all("no_drop");
  std::filesystem::create_directories("no_drop");
  REQUIRE(holds(refusal("no_drop"),
                "must hold summary.json and history.csv of a drop: summary.json cannot be read"));
  written("no_drop/summary.json", "{}");
  REQUIRE(holds(refusal("no_drop"), "there is no history.csv"));
  written("no_drop/history.csv", "time_s,acceleration_m_s2\n0,1\n");
  REQUIRE(holds(refusal("no_drop"), "summary.json is none"));
}

TEST_CASE("options of a reduction") {
  const auto o =
      options("a.csv", {"--medium", "water", "--soil", "clay", "--area", "projected", "--mass", "9.15"});
  REQUIRE(
      (o.file == "a.csv" && o.medium == Medium::water && o.soil == Soil::clay && o.area == Area::projected));
  REQUIRE((o.mass == 9.15 && o.impact_threshold() == 0.5 && options("a").impact_threshold() == -0.8));
  REQUIRE(refusal("a.csv", {"--mass", "0"}) == "--mass = 0: must lie in [0.001, 100000] kg");
  REQUIRE(refusal("a.csv", {"--drag", "1"}) == "--drag = 1: needs --medium water");
  REQUIRE(refusal("a.csv", {"--wings"}) == "--wings: no such option; see arenite-ffp reduce --help");
  REQUIRE(holds(refusal("a.csv", {"b.csv"}), "b.csv: a word without an option"));
  std::ostringstream help;
  REQUIRE(!read_reduce({"--help"}, help).has_value());
  for (const char* part :
       {"--medium air|water", "--impact-velocity M_S", "BlueDrop (.bin)", "Exit code", "(default 0.002)"})
    REQUIRE(holds(help.str(), part));
  REQUIRE_THROWS_WITH(read_reduce({}, help), Catch::Matchers::StartsWith("FILE = (none): must be given"));
}

TEST_CASE("a drop's folder: its inputs, its depth, its peak") {
  // One step after the other, each deceleration the mean over its step, as a run writes them.
  std::filesystem::create_directories("of_a_drop");
  std::string text = "time_s,penetration_m,velocity_m_s,acceleration_m_s2\n0,0,5,-9.81\n";
  double t = 0, v = 5, depth = 0;
  std::vector<double> time{0}, deceleration{-g};
  for (int i = 1; v > 0; ++i) {
    const double dt = (i % 3 + 1) * 2e-5, a = 150 * (1 - std::exp(-t / 5e-3)) + 20 * (i % 2);
    t += dt;
    v -= a * dt;
    depth += v * dt;
    time.push_back(t);
    deceleration.push_back(a);
    text += joined_text({exactly(t), ",", exactly(depth), ",", exactly(v), ",", exactly(a), "\n"});
  }
  written("of_a_drop/history.csv", text + "0.5,0.");  // a row that was cut
  written("of_a_drop/summary.json", R"({"inputs": {"velocity_m_s": 5, "mass_kg": 9, "gravity_m_s2": 9.81,
      "unit_weight_N_m3": 15000, "k0": 0.4, "fillet_m": 0, "tip": "parabolic"}})");
  const auto r = reduced("of_a_drop");
  REQUIRE((r.mass == 9 && r.k0 == 0.4 && r.unit_weight == 15000 && r.motion.impact_velocity == 5));
  REQUIRE(r.device.tip == Tip::parabolic);
  REQUIRE(std::abs(r.motion.velocity.back() - v) < 1e-9);
  REQUIRE(std::abs(r.motion.depth.back() - depth) < 2e-4);  // half a step of the velocity
  const auto mean = moving_average(time, deceleration, 2e-3);
  REQUIRE(r.peak_g() == *std::max_element(mean.begin(), mean.end()) / g);
  const auto other = reduced("of_a_drop", {"--mass", "8", "--gravity", "9.8"});
  REQUIRE((other.mass == 8 && other.gravity == 9.8));
  REQUIRE(holds(refusal("of_a_drop", {"--reads", "proper"}),
                "--reads = proper: goes without the folder of a drop"));
  REQUIRE(holds(refusal("of_a_drop", {"--invert"}), "--invert: goes without the folder of a drop"));

  const auto o = options("of_a_drop");
  write_reduced_csv("reduced.csv", r, o);
  const auto j = json_of(r, o);
  std::ifstream in{"reduced.csv"};
  std::string line;
  std::getline(in, line);
  REQUIRE(line.starts_with(
      "time_s,depth_m,velocity_m_s,deceleration_g,filtered_deceleration_g,q_dyn_mantle_kPa,"
      "q_dyn_projected_kPa,q_sbc_K0.2_kPa,q_sbc_K0.4_kPa,q_sbc_K1_kPa,q_sbc_K1.5_kPa,q_sbc_Kair_kPa,"));
  const auto commas = std::count(line.begin(), line.end(), ',');
  std::size_t rows = 0;
  for (; std::getline(in, line); ++rows) REQUIRE(std::count(line.begin(), line.end(), ',') == commas);
  REQUIRE(rows == r.motion.time.size());
  REQUIRE(j["peak_deceleration_g"] == r.peak_g());
  REQUIRE(j["depth_cm"] == r.greatest_depth * 100);
  REQUIRE(j["q_sbc"].size() == 7);
  REQUIRE(j["q_sbc"][4]["within_range"] == true);
  REQUIRE(j["q_dyn"]["mantle"]["largest_kPa"].get<double>() > 0);
  std::ostringstream table;
  print_table(r, o, table);
  for (const char* part : {"peak deceleration", "q_sbc, K = 1.55", "Mulukutla 2011", "outside the range"})
    REQUIRE(holds(table.str(), part));
}

TEST_CASE("the depth of a drop that turns is its tip's, not that of its centre of mass") {
  std::string text = "time_s,penetration_m,velocity_m_s,acceleration_m_s2\n0,0,5,-9.81\n";
  const double dt = 1e-3, v = 5, a = 40;
  for (int i = 1; i <= 125; ++i) {
    const double t = i * dt, centre = v * t - a * t * t / 2;
    text +=
        joined_text({exactly(t), ",", exactly(0.9 * centre), ",", exactly(v - a * t), ",", exactly(a), "\n"});
  }
  std::filesystem::create_directories("turning");
  written("turning/history.csv", text);
  const std::string inputs = R"("inputs": {"velocity_m_s": 5, "mass_kg": 7.71, "gravity_m_s2": 9.81,
      "unit_weight_N_m3": 15000, "k0": 0.4, "fillet_m": 0, "tip": "cone", "kinematics": ")";
  written("turning/summary.json",
          "{\"final_tilt_deg\": 12, \"final_aside_m\": 0.031, " + inputs + "space\"}}");
  const auto turning = reduced("turning");
  REQUIRE(turning.motion.depth.back() == Approx(0.9 * v * v / (2 * a)).epsilon(1e-12));
  REQUIRE(holds(turning.notes.back(), "tilted by 12 deg and 3.1 cm aside"));
  written("turning/summary.json", "{" + inputs + "axisymmetric\"}}");
  REQUIRE(reduced("turning").motion.depth.back() == Approx(v * v / (2 * a)).epsilon(1e-3));
}
