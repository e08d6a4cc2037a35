// Raw records of a BlueDrop: reading, ranges that clip, calibration.
#include <cmath>
#include <string>

#include "../../examples/ffp/reduce/bluedrop_file.hpp"
#include "catch.hpp"
#include "reductions.hpp"

using namespace arenite;
using namespace arenite::ffp;

namespace {

constexpr double g = standard_gravity;

/// A BlueDrop's record of a drop: every accelerometer measures it, clipped to its range.
std::string bluedrop_record(double peak_g, double at_rest = 0) {
  const double fall = 0.5, braking = 0.03;
  std::string bytes;
  bytes.reserve(bluedrop_rows * bluedrop_columns * bluedrop_bytes);
  for (std::size_t row = 0; row < bluedrop_rows; ++row) {
    const double t = static_cast<double>(row) / bluedrop_rate - 20;
    const double in_g = at_rest + (t < 0                ? 0
                                   : t < fall           ? -1
                                   : t < fall + braking ? peak_g * std::sin(pi * (t - fall) / braking)
                                                        : 0);
    std::array<std::int32_t, bluedrop_columns> columns{static_cast<std::int32_t>(row)};
    for (const Accelerometer& a : sample_accelerometers)
      columns[a.column] =
          static_cast<std::int32_t>(std::lround(std::clamp(in_g, -a.range, a.range) * a.scale));
    for (const std::int32_t value : columns)
      for (const int shift : {16, 8, 0}) bytes += static_cast<char>((value >> shift) & 0xff);
  }
  return bytes;
}

}  // namespace

TEST_CASE("a BlueDrop's raw record is read back, by the smallest range that does not clip") {
  for (const auto& [peak, name] : {std::pair{1.5, "2g"}, {15.0, "18g"}, {230.0, "250g"}}) {
    INFO(name);
    const auto o = options(written("drop.bin", bluedrop_record(peak)));
    const Measurement m = read_measurement(o);
    REQUIRE(m.time.size() == bluedrop_rows);
    REQUIRE(std::abs(m.time.back() - 59.9995) < 1e-9);
    REQUIRE(holds(m.notes[0], joined_text({"accelerometer of ", name, ","})));
    REQUIRE(holds(m.notes[1], "is a sample that belongs to no probe"));
    REQUIRE(std::abs(m.deceleration[40500] + g) < 1e-3);
    REQUIRE(std::abs(*std::max_element(m.deceleration.begin(), m.deceleration.end()) / g - peak) <
            5e-4 * peak + 1e-3);
  }
  const auto r = reduced(written("drop.bin", bluedrop_record(17, 0.1)), {"--zero-at-rest", "--window", "0"});
  REQUIRE(std::abs(r.taken_off / g - 0.1) < 1e-4);
  REQUIRE(std::abs(r.motion.impact_velocity - 0.5 * g) < 0.01);
  REQUIRE(std::abs(r.peak_g() - 17) < 0.01);
  REQUIRE(std::abs(r.motion.impact_time - 20.5) < 1e-3);
}

TEST_CASE("a BlueDrop's calibration, and records that cannot be used") {
  const auto file = written("drop.bin", bluedrop_record(15));
  const auto twice = reduced(
      file, {"--scale", "18g=3.2e5", "--window", "0", "--impact-time", "20.5", "--impact-velocity", "5"});
  REQUIRE(std::abs(twice.peak_g() - 7.5) < 0.01);
  written("probe.json",
          R"({"probe": "b2", "18g": {"scale": 3.2e5, "offset": 16000}, "50g": {"scale": 64000}})");
  const auto o = options(file, {"--calibration", "probe.json", "--offset", "50g=5"});
  const Calibration c = calibration_of(o);
  REQUIRE((c.accelerometers[1].scale == 3.2e5 && c.accelerometers[1].offset == 16000 && !c.is_sample[1]));
  REQUIRE((c.accelerometers[2].offset == 5 && !c.is_sample[2] && c.is_sample[0]));
  const auto m = read_measurement(o);
  REQUIRE(std::abs(*std::max_element(m.deceleration.begin(), m.deceleration.end()) / g - 7.55) < 0.01);
  REQUIRE(m.notes.size() == 1);
  REQUIRE(holds(refusal(file, {"--scale", "18g"}), "--scale = 18g: must be RANGE=NUMBER"));
  REQUIRE(holds(refusal(file, {"--scale", "19g=3"}), "--scale: 19g: must be 2g, 18g, 50g, 200g or 250g"));
  REQUIRE(holds(refusal(file, {"--scale", "18g=0"}), "--scale = 0: a scale must be"));
  REQUIRE(refusal(file, {"--calibration", "none.json"}) == "--calibration = none.json: no such file");
  written("list.json", "[]");
  REQUIRE(holds(refusal(file, {"--calibration", "list.json"}),
                "--calibration = list.json: must be a JSON object"));
  written("wrong.json", R"({"18g": {"scale": "much"}})");
  REQUIRE(holds(refusal(file, {"--calibration", "wrong.json"}), "18g.scale: must be a number"));
  for (const auto& [text, sentence] :
       {std::pair{R"({"18g": {"Scale": 3.2e5}})", "18g.Scale: must be scale or offset"},
        {R"({"18g": 3.2e5})", "18g = 320000.0: must be {\"scale\": .., \"offset\": ..}"},
        {R"({"18g": {"scale": "3,2e5"}})", "18g.scale: must be a number"},
        {R"({"18g": {"scale": 1, "scale": 2}})", "gives scale twice"}}) {
    written("wrong.json", text);
    REQUIRE(holds(refusal(file, {"--calibration", "wrong.json"}), sentence));
  }
  REQUIRE(holds(refusal(written("clipped.bin", bluedrop_record(400))),
                "every accelerometer clips (2g, 18g, 50g, 200g, 250g)"));
  REQUIRE(holds(refusal(written("cut.bin", std::string(3599999, '\0'))),
                "cut.bin = 3599999 bytes: a BlueDrop's record has 3600000"));
}

TEST_CASE("a BlueDrop's record that lost an integer is refused with its place; rows that it lost are a gap") {
  std::string bytes = bluedrop_record(15);
  bytes.erase(39000 * 30 + 12, 3);
  const auto said = refusal(written("lost.bin", bytes + std::string(3, '\0')));
  REQUIRE(holds(said, "lost.bin: row 39001 (byte 1170030): the first column counts 39000 and then 0: "));
  REQUIRE(holds(said, "an integer is missing"));
  bytes = bluedrop_record(15);
  bytes.erase(39000 * 30, 300);
  for (std::size_t i = 0; i < 10; ++i) bytes += bytes.substr(bytes.size() - 30);
  for (std::size_t row = bluedrop_rows - 10; row < bluedrop_rows; ++row)
    for (std::size_t k = 0; k < 3; ++k)  // in which the count continues
      bytes[row * 30 + k] = static_cast<char>(((row + 10) >> (8 * (2 - k))) & 0xff);
  const Measurement m = read_measurement(options(written("gap.bin", bytes)));
  REQUIRE(
      holds(m.notes[0], "row 39000 (byte 1170000): the first column counts 38999 and then 39010: 10 rows"));
  REQUIRE(std::abs(m.time[39000] - 39010 / bluedrop_rate) < 1e-9);
  REQUIRE(std::abs(reduced("gap.bin").motion.impact_time - 20.5) < 1e-3);
}
