#include "bluedrop_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include <arenite/core/error.hpp>

#include "../text/json_file.hpp"
#include "../text/words.hpp"

namespace arenite::ffp {

namespace {

/// Place of an accelerometer by its name; throws `error` that names `where`.
std::size_t accelerometer_at(const std::string& where, const std::string& name) {
  for (std::size_t k = 0; k < sample_accelerometers.size(); ++k)
    if (sample_accelerometers[k].name == name) return k;
  throw error(joined_text({where, ": ", shown(name), ": must be 2g, 18g, 50g, 200g or 250g"}));
}

/// Takes "2g=1.62e6,18g=1.6e5" apart.
template <class Take>
void each_assignment(const std::string& option, const std::string& text, const Take& take) {
  std::size_t from = 0;
  while (!text.empty() && from <= text.size()) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string part = text.substr(from, to - from);
    const std::size_t sign = std::min(part.find('='), part.size());
    const auto value = sign < part.size() ? detail::number_of(part.substr(sign + 1)) : std::nullopt;
    const double number = value.value_or(std::numeric_limits<double>::quiet_NaN());
    require(std::isfinite(number), option, shown(text),
            "must be RANGE=NUMBER, .., as in 2g=1.62e6,18g=1.6e5");
    take(accelerometer_at(option, part.substr(0, sign)), number);
    from = to + 1;
  }
}

/// Places of the rows in time: the first column counts them. Missing ones are listed in `notes`. Throws
/// `error` that names the row from which on the integers are not where they belong.
template <class Raw>
std::vector<std::size_t> places_of_rows(const Raw& raw, const std::string& file,
                                        std::vector<std::string>& notes) {
  constexpr std::int32_t values = 1 << 24, most_missing = 1 << 16;
  constexpr std::size_t sure = 100;  // rows
  const auto step = [&](std::size_t row) {
    return ((raw(row, 0) - raw(row - 1, 0)) % values + values) % values;
  };
  const auto goes_on = [&](std::size_t row) { return row >= bluedrop_rows || step(row) == 1; };
  std::vector<std::size_t> places(bluedrop_rows);
  bool counts = true;  // else the first column is another
  for (std::size_t row = 1; row < bluedrop_rows; ++row) {
    places[row] = places[row - 1] + 1;
    if (row < sure) counts = counts && step(row) == 1;
    if (!counts || step(row) == 1) continue;
    const std::int32_t missing = step(row) - 1;
    const std::size_t byte = row * bluedrop_columns * bluedrop_bytes;
    const std::string where = joined_text({"row ", row, " (byte ", byte, "): the first column counts ",
                                           raw(row - 1, 0), " and then ", raw(row, 0), ": "});
    if (missing < 0 || missing > most_missing || !goes_on(row + 1) || !goes_on(row + 2))
      throw error(
          joined_text({file, ": ", where,
                       "an integer is missing or too many before it, and the columns after it are not "
                       "those of the accelerometers"}));
    notes.push_back(joined_text({where, missing, " rows are missing"}));
    places[row] += static_cast<std::size_t>(missing);
  }
  return places;
}

}  // namespace

Calibration calibration_of(const ReduceOptions& o) {
  Calibration c;
  const auto set_scale = [&](const std::string& where, std::size_t k, double scale) {
    require(scale != 0 && std::isfinite(scale), where, scale,
            "a scale must be a number of counts a g, and not 0");
    c.accelerometers[k].scale = scale;
    c.is_sample[k] = false;
  };
  if (!o.calibration.empty()) {
    const std::string file = shown(o.calibration);
    const Json all = read_json(o.calibration, "--calibration");
    require(all.is_object(), "--calibration", file,
            "must be a JSON object: {\"2g\": {\"scale\": 1.62e6, \"offset\": 0}, ..}");
    for (const auto& [name, value] : all.items()) {
      if (value.is_string()) continue;  // a word about probe or date
      const std::string where = joined_text({"--calibration = ", file});
      const std::size_t k = accelerometer_at(where, name);
      require(value.is_object(), where + ": " + name, shown(json_text(value)),
              "must be {\"scale\": .., \"offset\": ..}");
      for (const auto& [key, number] : value.items()) {
        const std::string entry = joined_text({where, ": ", name, ".", shown(key)});
        if (key != "scale" && key != "offset") throw error(entry + ": must be scale or offset");
        if (!number.is_number()) throw error(entry + ": must be a number");
      }
      if (value.contains("scale")) set_scale(where + ": " + name + ".scale", k, value["scale"].get<double>());
      if (value.contains("offset")) c.accelerometers[k].offset = value["offset"].get<double>();
    }
  }
  each_assignment("--scale", o.scale, [&](std::size_t k, double value) { set_scale("--scale", k, value); });
  each_assignment("--offset", o.offset,
                  [&](std::size_t k, double value) { c.accelerometers[k].offset = value; });
  return c;
}

Measurement read_bluedrop(const std::filesystem::path& path, const ReduceOptions& o, double gravity) {
  const std::string file = shown(path.string());
  constexpr std::size_t wanted = bluedrop_rows * bluedrop_columns * bluedrop_bytes;
  const std::uintmax_t size =
      arenite::shared_detail::check_input(path, "FILE", arenite::shared_detail::any_size, file);
  require(size == wanted, file, joined_text({size, " bytes"}),
          {"a BlueDrop's record has ", wanted, ": ", bluedrop_rows, " rows of ", bluedrop_columns,
           " integers of ", bluedrop_bytes, " bytes"});
  const std::string bytes = arenite::shared_detail::read_input(path, "FILE", wanted, file);
  require(bytes.size() == wanted, "FILE", file, "cannot be read");
  const auto raw = [&](std::size_t row, std::size_t column) {
    const std::size_t at = (row * bluedrop_columns + column) * bluedrop_bytes;
    const auto byte = [&](std::size_t k) {
      return static_cast<std::int32_t>(static_cast<unsigned char>(bytes[at + k]));
    };
    const std::int32_t value = (byte(0) << 16) | (byte(1) << 8) | byte(2);
    return value >= (1 << 23) ? value - (1 << 24) : value;
  };
  constexpr std::int32_t top = (1 << 23) - 1;
  const Calibration calibration = calibration_of(o);
  Measurement m;
  const auto places = places_of_rows(raw, file, m.notes);
  std::string clipped;
  for (std::size_t k = 0; k < calibration.accelerometers.size(); ++k) {
    const Accelerometer& a = calibration.accelerometers[k];
    m.deceleration.clear();
    bool clips = false;
    for (std::size_t row = 0; row < bluedrop_rows && !clips; ++row) {
      const std::int32_t value = raw(row, a.column);
      const double in_g = (value + a.offset) / a.scale;
      clips = std::abs(in_g) >= a.range || value >= top || value <= -top - 1;
      m.deceleration.push_back(in_g * gravity);
    }
    if (clips) {
      clipped += (clipped.empty() ? "" : ", ") + std::string{a.name};
      continue;
    }
    for (std::size_t row = 0; row < bluedrop_rows; ++row)
      m.time.push_back(static_cast<double>(places[row]) / bluedrop_rate);
    m.notes.push_back(joined_text({"accelerometer of ", a.name, ", the smallest that does not clip",
                                   clipped.empty() ? "" : " (clipped: " + clipped + ")", "; scale ", a.scale,
                                   " counts a g, offset ", a.offset}));
    if (calibration.is_sample[k])
      m.notes.push_back(joined_text(
          {"the scale of ", a.name, " is a sample that belongs to no probe; give --calibration or --scale"}));
    return m;
  }
  throw error(joined_text(
      {file, ": every accelerometer clips (", clipped, "); are scales and offsets those of the probe?"}));
}

}  // namespace arenite::ffp
