#include "measurement_table.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <arenite/core/error.hpp>

#include "../text/words.hpp"

namespace arenite::ffp {

namespace {

/// "Acceleration [m/s²]" as its words: {"acceleration", "m", "s2"}. The signs of UTF-8 and of Latin-1.
std::vector<std::string> words_of_name(std::string name) {
  for (const auto& [sign, letter] :
       {std::pair{"\xc2\xb2", '2'}, {"\xb2", '2'}, {"\xc2\xb5", 'u'}, {"\xce\xbc", 'u'}, {"\xb5", 'u'}})
    for (std::size_t at; (at = name.find(sign)) != std::string::npos;)
      name.replace(at, std::char_traits<char>::length(sign), 1, letter);
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
  std::size_t other_words = 0;  ///< beside quantity and unit
  std::size_t place = 0;        ///< in the header

  void has(double one) {
    unit = one;
    --other_words;
  }
  /// The column that is meant: one with a unit, and of those one without other words ("time_s", not
  /// "time_step_s").
  int rank() const { return is_quantity ? 1 + 2 * !std::isnan(unit) + (other_words == 0) : 0; }
};

NamedColumn time_column(const std::string& name) {
  const auto words = words_of_name(name);
  NamedColumn found;
  if (words.empty() || (words[0] != "time" && words[0] != "t" && words[0] != "zeit")) return found;
  found.is_quantity = true;
  found.other_words = words.size() - 1;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto& w = words[i];
    if (w == "s" || w == "sec" || w == "secs" || w == "seconds" || w == "second") found.has(1);
    if (w == "ms" || w == "msec" || w == "milliseconds") found.has(1e-3);
    if (w == "us" || w == "usec" || w == "microseconds") found.has(1e-6);
  }
  return found;
}

NamedColumn deceleration_column(const std::string& name, double gravity) {
  const auto words = words_of_name(name);
  NamedColumn found;
  if (words.empty()) return found;
  const auto& first = words[0];
  if (!first.starts_with("decel") && !first.starts_with("accel") && first != "acc" && first != "a")
    return found;
  found.is_quantity = true;
  found.other_words = words.size() - 1;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto& w = words[i];
    if (w == "g" || w == "gs") found.has(gravity);
    if (w == "ms2" || w == "mps2") found.has(1);
    if (words[i - 1] != "m") continue;
    const bool apart = w == "s" && i + 1 < words.size() && words[i + 1] == "2";
    if (w != "s2" && !apart) continue;
    found.has(1);
    found.other_words -= apart ? 2 : 1;
  }
  return found;
}

/// The one column of a header that is the quantity; throws `error` if several may be.
template <class Column>
NamedColumn pick_column(const TableReader& table, const char* quantity, const Column& column) {
  const auto& header = table.header();
  NamedColumn found;
  std::size_t rival = 0;
  for (std::size_t i = 0; i < header.size(); ++i) {
    NamedColumn c = column(header[i]);
    c.place = i;
    if (c.rank() > 0 && c.rank() == found.rank()) rival = i;
    if (c.rank() > found.rank()) {
      found = c;
      rival = 0;
    }
  }
  if (rival > 0)
    throw error(
        joined_text({table.file(), ": columns ", shown(header[found.place]), " and ", shown(header[rival]),
                     " may both be the ", quantity, "; leave the one that is meant"}));
  return found;
}

/// Takes the unit from the row below the header, where it is one of units.
template <class Column>
void take_unit(const TableReader& table, NamedColumn& c, const std::string& word, const Column& column) {
  const double below = column(word + " " + table.fields()[c.place]).unit;
  if (std::isnan(below)) table.refuse(c.place, "must be a number, or in the row below the header a unit");
  if (!std::isnan(c.unit) && c.unit != below) table.refuse(c.place, "is another unit than the header's");
  c.unit = below;
}

std::string joined_names(const std::vector<std::string>& names) {
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : ", ") + name;
  return shown(all);
}

}  // namespace

Measurement read_measurement_table(const std::filesystem::path& path, const ReduceOptions& o, double gravity,
                                   bool whole_lines) {
  const auto of_time = time_column;
  const auto of_deceleration = [&](const std::string& name) { return deceleration_column(name, gravity); };
  TableReader table(path, "FILE", whole_lines ? most_history_bytes : most_table_bytes, whole_lines);
  const std::string& file = table.file();
  const auto& header = table.header();
  const auto is_quantity = [](const auto& column) {
    return [&](const std::string& name) { return column(name).is_quantity; };
  };
  const auto count = [&](const std::vector<std::string>& names) {
    return int{std::ranges::any_of(names, is_quantity(of_time))} +
           int{std::ranges::any_of(names, is_quantity(of_deceleration))};
  };
  const bool found = table.find_header(2, count);
  if (table.line() == 0)
    throw error(joined_text({file, ": must be a file that can be read and is not empty"}));
  auto time = pick_column(table, "time", of_time),
       deceleration = pick_column(table, "deceleration", of_deceleration);
  if (!found)
    throw error(
        joined_text({file, ": has no column of ", !time.is_quantity ? "time (time_s, time_ms, t ..)" : "",
                     !time.is_quantity && !deceleration.is_quantity ? " nor one of " : "",
                     !deceleration.is_quantity ? "deceleration (deceleration_g, acceleration_m_s2 ..)" : "",
                     header.empty() ? "" : "; its columns: ", joined_names(header)}));
  Measurement m;
  for (bool first = true; table.next(); first = false) {
    const auto is_number = [&](const NamedColumn& c) {
      return detail::number_with_comma(table.fields()[c.place]).has_value();
    };
    if (first && !is_number(time) && !is_number(deceleration)) {
      take_unit(table, time, "time", of_time);
      take_unit(table, deceleration, "acc", of_deceleration);
      continue;
    }
    const double t = table.number(time.place), a = table.number(deceleration.place);
    if (!m.time.empty() && !(t > m.time.back()))
      table.refuse(time.place,
                   joined_text({"must be greater than the time before, ", exactly(m.time.back())}));
    m.time.push_back(t);
    m.deceleration.push_back(a);
  }
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
  m.notes.push_back(joined_text({"columns: time is ", shown(header[time.place]), " (times ", time_unit,
                                 " s), deceleration is ", shown(header[deceleration.place]), " (times ",
                                 deceleration_unit, " m/s^2); ", m.time.size(), " rows"}));
  return m;
}

}  // namespace arenite::ffp
