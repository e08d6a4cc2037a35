#include "measurement_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
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

/// The meaning of a column's name: whether it is the quantity, and its unit in s or m/s^2; NaN: no unit.
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

/// The one column of a header that is the quantity; throws `error` if several may be. `option` chooses one.
template <class Column>
NamedColumn pick_column(const TableReader& table, const char* quantity, const char* option,
                        const Column& column) {
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
    throw error(joined_text({table.file(), ": columns ", shown(header[found.place]), " and ",
                             shown(header[rival]), " may both be the ", quantity, "; give ", option,
                             " with the name or the number of the one that is meant"}));
  return found;
}

/// A number from 1 on, as of a column.
std::optional<std::size_t> column_number(const std::string& text) {
  std::size_t n = 0;
  const auto [at, code] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (code != std::errc{} || at != text.data() + text.size() || n == 0) return std::nullopt;
  return n;
}

/// The columns that an option names: one, if there is one of this name, else those between its commas.
std::vector<std::string> columns_given(const std::string& text, const std::vector<std::string>& header) {
  if (std::ranges::find(header, text) != header.end()) return {text};
  return detail::fields_of(text, ',').value_or(std::vector{text});
}

/// Place of a column by its name, or else by its number; none: there is no such.
std::optional<std::size_t> place_of(const std::string& given, const std::vector<std::string>& header) {
  if (const auto at = std::ranges::find(header, given); at != header.end())
    return static_cast<std::size_t>(at - header.begin());
  const auto number = column_number(given);
  return number && *number <= header.size() ? std::optional{*number - 1} : std::nullopt;
}

std::string joined_names(const std::vector<std::string>& names) {
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : ", ") + name;
  return shown(all);
}

/// The columns of a header that an option names, one or `most`; `unit(name)` is that of a name. Throws `error`
/// if there are no such.
template <class Unit>
std::vector<NamedColumn> given_columns(const TableReader& table, const char* option, const std::string& text,
                                       std::size_t most, const Unit& unit) {
  const auto& header = table.header();
  const std::string its_columns = header.empty() ? "" : "; its columns: " + joined_names(header);
  const auto all = columns_given(text, header);
  require(all.size() == 1 || all.size() == most, option, shown(text),
          joined_text({"must be one column", most > 1 ? ", or three as X,Y,Z" : "",
                       "; put quotes around a name that has a comma", its_columns}));
  std::vector<NamedColumn> columns;
  for (const std::string& given : all) {
    const auto place = place_of(given, header);
    require(place.has_value(), option, shown(given),
            joined_text({table.file(), " has no such column", its_columns}));
    require(std::ranges::count(header, given) < 2, option, shown(given),
            joined_text({table.file(), " has several of this name; give its number", its_columns}));
    require(std::ranges::find(columns, *place, &NamedColumn::place) == columns.end(), option, shown(text),
            "names a column twice");
    columns.push_back({.is_quantity = true, .unit = unit(header[*place]), .place = *place});
  }
  return columns;
}

/// Takes the unit from the row below the header, where it is one of units.
template <class Column>
void take_unit(const TableReader& table, NamedColumn& c, const std::string& word, const Column& column) {
  const double below = column(word + " " + table.fields()[c.place]).unit;
  if (std::isnan(below)) table.refuse(c.place, "must be a number, or in the row below the header a unit");
  if (!std::isnan(c.unit) && c.unit != below) table.refuse(c.place, "is another unit than the header's");
  c.unit = below;
}

}  // namespace

Measurement read_measurement_table(const std::filesystem::path& path, const ReduceOptions& o, double gravity,
                                   bool whole_lines) {
  const auto of_time = time_column;
  const auto of_deceleration = [&](const std::string& name) { return deceleration_column(name, gravity); };
  TableReader table(path, "FILE", whole_lines ? most_history_bytes : most_table_bytes, whole_lines);
  const std::string& file = table.file();
  const auto& header = table.header();
  const bool with_time = !o.rate;
  const auto match = [&](const std::vector<std::string>& names) {
    HeaderMatch line;
    const auto look_for = [&](const std::string& option, const auto& column) {
      int rank = 0;
      if (option.empty())
        for (const auto& name : names) rank = std::max(rank, column(name).rank());
      else
        rank = std::ranges::all_of(columns_given(option, names),
                                   [&](const auto& given) { return place_of(given, names).has_value(); });
      line.found += rank > 0;
      line.clearly += rank;
    };
    if (with_time) look_for(o.time_column, of_time);
    look_for(o.column, of_deceleration);
    return line;
  };
  // Where all columns are given by number there need be no header.
  std::size_t most = 0;
  bool numbered = !o.column.empty() && (!with_time || !o.time_column.empty());
  for (const std::string& option : {o.column, with_time ? o.time_column : ""})
    for (const std::string& given : columns_given(option, {})) {
      const auto number = column_number(given);
      numbered = numbered && (option.empty() || number);
      most = std::max(most, number.value_or(0));
    }
  bool found = true;
  if (numbered)
    table.find_numbers(most);
  else
    found = table.find_header(
        with_time ? 2 : 1, match,
        ", or give the numbers of columns to --column, and to --time-column or the rows a second to --rate");
  if (table.line() == 0)
    throw error(joined_text({file, ": must be a file that can be read and is not empty"}));

  const auto find = [&](const std::string& option, const char* name, const char* quantity, const auto& column,
                        const char* word, std::size_t most_columns) {
    if (option.empty()) return std::vector{pick_column(table, quantity, name, column)};
    return given_columns(table, name, option, most_columns, [&](const std::string& in_header) {
      return column(joined_text({word, " ", in_header})).unit;
    });
  };
  std::vector<NamedColumn> times;
  if (with_time) times = find(o.time_column, "--time-column", "time", of_time, "time", 1);
  const auto axes = find(o.column, "--column", "deceleration", of_deceleration, "acc", 3);
  if (!found) {
    const bool no_time = with_time && !times[0].is_quantity, no_deceleration = !axes[0].is_quantity;
    throw error(joined_text({file, ": has no column of ", no_time ? "time (time_s, time_ms, t ..)" : "",
                             no_time && no_deceleration ? " nor one of " : "",
                             no_deceleration ? "deceleration (deceleration_g, acceleration_m_s2 ..)" : "",
                             header.empty() ? "" : "; its columns: " + joined_names(header), "; give ",
                             no_time ? "--time-column or --rate" : "",
                             no_time && no_deceleration ? ", and " : "", no_deceleration ? "--column" : ""}));
  }
  const bool is_magnitude = axes.size() > 1;
  if (is_magnitude) {
    require(
        o.reads == Reading::proper, "--column", shown(o.column),
        "three columns go with --reads proper alone, an accelerometer that reads 1 g at rest and 0 in the "
        "fall: a magnitude has no sign, and in a net record fall and braking would be the same");
    if (o.invert) throw error("--invert: goes without three columns in --column: a magnitude has no sign");
  }

  const auto named = [&](const NamedColumn& c) {
    return header[c.place] == joined_text({c.place + 1}) ? "column " + header[c.place]
                                                         : shown(header[c.place]);
  };
  Measurement m;
  std::vector<NamedColumn> all = times;
  all.insert(all.end(), axes.begin(), axes.end());
  for (const NamedColumn& c : axes)
    if (with_time && c.place == times[0].place)
      throw error(joined_text({file, ": ", named(c), " cannot be both time and deceleration"}));
  std::size_t line = 0;
  for (bool first = true; table.next(); first = false) {
    if (first && std::ranges::none_of(all, [&](const NamedColumn& c) {
          return detail::number_with_comma(table.fields()[c.place]).has_value();
        })) {
      for (NamedColumn& c : all) {
        const bool is_time = with_time && &c == &all.front();
        is_time ? take_unit(table, c, "time", of_time) : take_unit(table, c, "acc", of_deceleration);
      }
      continue;
    }
    if (with_time) {
      const double t = table.number(times[0].place);
      if (!m.time.empty() && !(t > m.time.back()))
        table.refuse(times[0].place,
                     joined_text({"must be greater than the time before, ", exactly(m.time.back())}));
      m.time.push_back(t);
    } else {
      if (!m.time.empty() && table.line() != line + 1)
        throw error(joined_text({file, ": line ", table.line(),
                                 ": must follow the row before without lines that are empty or have #: "
                                 "--rate counts rows"}));
      line = table.line();
      m.time.push_back(static_cast<double>(m.time.size()) / *o.rate);
    }
    double a = table.number(axes[0].place);
    if (is_magnitude) a = std::hypot(a, table.number(axes[1].place), table.number(axes[2].place));
    m.deceleration.push_back(a);
  }
  std::string of_time_text = joined_text({"row / ", o.rate.value_or(0), " Hz"});
  if (with_time) {
    constexpr double seconds[] = {0, 1, 1e-3, 1e-6};
    const double unit = o.time_unit == TimeUnit::named ? all[0].unit : seconds[static_cast<int>(o.time_unit)];
    require(!std::isnan(unit), file + ": column", shown(header[all[0].place]),
            "names no unit; write time_s or time_ms, or give --time-unit");
    for (double& t : m.time) t *= unit;
    of_time_text = joined_text({named(all[0]), " (times ", unit, " s)"});
  } else {
    for (const auto& name : header)
      if (of_time(name).is_quantity) of_time_text += " (column " + shown(name) + " is not read)";
  }
  double unit = std::numeric_limits<double>::quiet_NaN();
  std::string of_axes;
  for (auto c = all.begin() + with_time; c != all.end(); ++c) {
    const double other = all[with_time].unit;
    if (!std::isnan(c->unit) && !std::isnan(other) && c->unit != other)
      throw error(joined_text({file, ": ", of_axes, " and ", named(*c), " must have one unit"}));
    unit = o.deceleration_unit == DecelerationUnit::named ? c->unit
           : o.deceleration_unit == DecelerationUnit::g   ? gravity
                                                          : 1;
    require(!std::isnan(unit), file + ": column", shown(header[c->place]),
            "names no unit; write deceleration_g or deceleration_m_s2, or give --deceleration-unit");
    of_axes += (of_axes.empty() ? "" : ", ") + named(*c);
  }
  for (double& a : m.deceleration) a *= unit;
  m.notes.push_back(joined_text({"columns: time is ", of_time_text, ", deceleration is ",
                                 is_magnitude ? "the magnitude of " : "", of_axes, " (times ", unit,
                                 " m/s^2); ", m.time.size(), " rows"}));
  return m;
}

}  // namespace arenite::ffp
