// A record of deceleration as a table of text: columns found by their names, whoever wrote them.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/io/input_file.hpp>

#include "measurement.hpp"
#include "reduce_options.hpp"
#include "words.hpp"

namespace arenite::ffp {

/// Largest record as a table: ten minutes at 50 kHz. Largest history: 1e8 steps, as many as a drop takes
/// without --force. Both are read row by row.
inline constexpr std::uintmax_t most_table_bytes = std::uintmax_t{1} << 30,
                                most_history_bytes = std::uintmax_t{64} << 30;
/// Longest row, bytes.
inline constexpr std::size_t most_row_bytes = std::size_t{1} << 20;

namespace detail {

/// The next line, without its end, as `std::getline`. Throws `error` for one that is too long to be a row.
inline bool next_row(std::istream& in, std::string& line, const std::string& file) {
  line.clear();
  constexpr int end = std::char_traits<char>::eof();
  for (int c = in.get(); c != end; c = in.get()) {
    if (c == '\n') return true;
    line += static_cast<char>(c);
    if (line.size() > most_row_bytes)
      throw error(joined_text(file, ": has a row of more than ",
                              arenite::shared_detail::size_text(most_row_bytes), ": is no table"));
  }
  if (!line.empty()) in.clear(std::ios::eofbit);
  return !line.empty();
}

/// Fields of a line: between commas, semicolons or tabs, else between blanks; without blanks and quotes
/// around them.
inline std::vector<std::string> fields_of(const std::string& line) {
  const char* marks = line.find_first_of(",;\t") != std::string::npos ? ",;\t" : " ";
  std::vector<std::string> fields;
  std::size_t from = 0;
  while (from <= line.size()) {
    const std::size_t to = std::min(line.find_first_of(marks, from), line.size());
    std::string_view field{line.data() + from, to - from};
    const auto is_margin = [](char c) { return c == ' ' || c == '"' || c == '\r'; };
    while (!field.empty() && is_margin(field.front())) field.remove_prefix(1);
    while (!field.empty() && is_margin(field.back())) field.remove_suffix(1);
    if (*marks != ' ' || !field.empty()) fields.emplace_back(field);
    from = to + 1;
  }
  return fields;
}

inline std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [at, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || at != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "Acceleration [m/s^2]" as its words: {"acceleration", "m", "s2"}.
inline std::vector<std::string> words_of_name(const std::string& name) {
  std::vector<std::string> words{""};
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)))
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (c != '^' && !words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

/// What a column's name says: whether it is the quantity, and how many seconds or m/s^2 its unit has; NaN: no
/// unit.
struct NamedColumn {
  bool is_quantity = false;
  double unit = std::numeric_limits<double>::quiet_NaN();
  std::size_t place = 0;  ///< in the header
};

inline NamedColumn time_column(const std::string& name) {
  const auto words = words_of_name(name);
  NamedColumn found;
  if (words.empty() || (words[0] != "time" && words[0] != "t" && words[0] != "zeit")) return found;
  found.is_quantity = true;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto& w = words[i];
    if (w == "s" || w == "sec" || w == "secs" || w == "seconds" || w == "second") found.unit = 1;
    if (w == "ms" || w == "msec" || w == "milliseconds") found.unit = 1e-3;
    if (w == "us" || w == "usec" || w == "microseconds") found.unit = 1e-6;
  }
  return found;
}

inline NamedColumn deceleration_column(const std::string& name, double gravity) {
  const auto words = words_of_name(name);
  NamedColumn found;
  if (words.empty()) return found;
  const auto& first = words[0];
  if (!first.starts_with("decel") && !first.starts_with("accel") && first != "acc" && first != "a")
    return found;
  found.is_quantity = true;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto& w = words[i];
    if (w == "g" || w == "gs") found.unit = gravity;
    const bool squared = w == "s2" || (w == "s" && i + 1 < words.size() && words[i + 1] == "2");
    if (squared && words[i - 1] == "m") found.unit = 1;
    if (w == "ms2" || w == "mps2") found.unit = 1;
  }
  return found;
}

/// The one column of a header that is the quantity: the first that names a unit, else the first at all.
template <class Column>
NamedColumn pick_column(const std::vector<std::string>& header, const Column& column) {
  NamedColumn found;
  for (std::size_t i = 0; i < header.size(); ++i) {
    NamedColumn c = column(header[i]);
    c.place = i;
    if (c.is_quantity && (!found.is_quantity || (std::isnan(found.unit) && !std::isnan(c.unit)))) found = c;
  }
  return found;
}

inline std::string joined_names(const std::vector<std::string>& names) {
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : ", ") + name;
  return shown(all);
}

}  // namespace detail

/// Reads a table. `whole_lines`: a last line without line break is cut, and left out. Throws `error` that
/// names the file and what is missing in it.
inline Measurement read_measurement_table(const std::filesystem::path& path, const ReduceOptions& o,
                                          double gravity, bool whole_lines = false) {
  const std::string file = shown(path.string());
  std::ifstream in = arenite::shared_detail::open_input(
      path, "FILE", whole_lines ? most_history_bytes : most_table_bytes, file);
  if (in.peek() == std::ifstream::traits_type::eof())
    throw error(joined_text(file, ": must be a file that can be read and is not empty"));
  Measurement m;
  std::vector<std::string> header;
  detail::NamedColumn time, deceleration;
  std::string line;
  std::size_t row = 0;
  while (detail::next_row(in, line, file)) {
    ++row;
    if (whole_lines && in.eof()) break;
    if (row == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);  // a byte order mark
    const auto fields = detail::fields_of(line);
    if (fields.empty() || fields[0].starts_with('#') || (fields.size() == 1 && fields[0].empty())) continue;
    if (header.empty()) {
      if (detail::number_of(fields[0]))
        throw error(joined_text(file, ": row ", row,
                                " is a row of numbers, and no header names the columns; put a line such as "
                                "\"time_s,deceleration_g\" first"));
      time = detail::pick_column(fields, detail::time_column);
      deceleration = detail::pick_column(
          fields, [&](const std::string& name) { return detail::deceleration_column(name, gravity); });
      if (!time.is_quantity && !deceleration.is_quantity) continue;  // a title above the header
      header = fields;
      continue;
    }
    const auto value = [&](std::size_t column) -> double {
      const auto found = column < fields.size() ? detail::number_of(fields[column]) : std::nullopt;
      if (!found || !std::isfinite(*found))
        throw error(joined_text(file, ": row ", row, ", column ", shown(header[column]), " = ",
                                column < fields.size() ? shown(fields[column]) : "(none)",
                                ": must be a number"));
      return *found;
    };
    if (!time.is_quantity || !deceleration.is_quantity) break;
    m.time.push_back(value(time.place));
    m.deceleration.push_back(value(deceleration.place));
  }
  if (!time.is_quantity || !deceleration.is_quantity)
    throw error(
        joined_text(file, ": has no column of ", !time.is_quantity ? "time (time_s, time_ms, t ..)" : "",
                    !time.is_quantity && !deceleration.is_quantity ? " nor one of " : "",
                    !deceleration.is_quantity ? "deceleration (deceleration_g, acceleration_m_s2 ..)" : "",
                    header.empty() ? "" : "; its columns: ", detail::joined_names(header)));
  constexpr double seconds[] = {0, 1, 1e-3, 1e-6};
  double time_unit = o.time_unit == TimeUnit::named ? time.unit : seconds[static_cast<int>(o.time_unit)];
  double deceleration_unit = o.deceleration_unit == DecelerationUnit::named ? deceleration.unit
                             : o.deceleration_unit == DecelerationUnit::g   ? gravity
                                                                            : 1;
  require(!std::isnan(time_unit), file + ": column", shown(header[time.place]),
          "names no unit; write time_s or time_ms, or give --time-unit");
  require(!std::isnan(deceleration_unit), file + ": column", shown(header[deceleration.place]),
          "names no unit; write deceleration_g or deceleration_m_s2, or give --deceleration-unit");
  for (double& t : m.time) t *= time_unit;
  for (double& a : m.deceleration) a *= deceleration_unit;
  m.notes.push_back(joined_text("columns: time is ", shown(header[time.place]), " (times ", time_unit,
                                " s), deceleration is ", shown(header[deceleration.place]), " (times ",
                                deceleration_unit, " m/s^2); ", m.time.size(), " rows"));
  return m;
}

}  // namespace arenite::ffp
