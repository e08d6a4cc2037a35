// A table of text, row by row: the one description of what the driver takes as a table.
//
//   UTF-8, with or without a byte order mark; lines end with LF or CR LF; empty lines and lines with # are
//   left out. One separator a file, that of its header: a tab, a semicolon, a comma or blanks. Text in
//   quotes is one field. Every row has as many fields as the header; empty ones after them do not count. One
//   decimal mark a file, a point or a comma, and no mark between thousands.
//
// Anything else is refused with its line; nothing is guessed.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <compare>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/io/input_file.hpp>

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
      throw error(joined_text({file, ": has a row of more than ",
                               arenite::shared_detail::size_text(most_row_bytes), ": is no table"}));
  }
  if (!line.empty()) in.clear(std::ios::eofbit);
  return !line.empty();
}

/// The whole text as a number with a decimal point.
inline std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [at, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || at != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The same, with a point or one comma as the decimal mark.
inline std::optional<double> number_with_comma(std::string text) {
  if (const auto comma = text.find(','); comma != std::string::npos) text[comma] = '.';
  return number_of(text);
}

/// Whether the comma of a number cannot be a mark between thousands: "0,125" and "1,25", not "1,250".
inline bool is_decimal_comma(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_of("0123456789,"), text.size()));
  const std::size_t comma = text.find(','), end = std::min(text.find_first_of("eE"), text.size());
  return text.starts_with('0') || comma == 0 || comma > 3 || end - comma - 1 != 3;
}

/// Fields of a line between a separator, without quotes and blanks around them; any number of blanks is one
/// separator. None if a quote is left open.
inline std::optional<std::vector<std::string>> fields_of(std::string_view line, char separator) {
  std::vector<std::string> fields{""};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == separator && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  if (quoted) return std::nullopt;
  for (std::string& field : fields) {
    field.erase(std::min(field.find_last_not_of(' ') + 1, field.size()));
    field.erase(0, std::min(field.find_first_not_of(' '), field.size()));
  }
  if (separator == ' ') std::erase(fields, "");
  return fields;
}

}  // namespace detail

/// How well a line does as a header: how many of the wanted columns it names, and how clearly.
struct HeaderMatch {
  int found = 0, clearly = 0;
  auto operator<=>(const HeaderMatch&) const = default;
};

class TableReader {
 public:
  /// `what`: the input, in the errors of a file that cannot be opened. `whole_lines`: a last line without
  /// line break is cut, and left out. Throws `error`.
  TableReader(const std::filesystem::path& path, std::string_view what, std::uintmax_t most,
              bool whole_lines = false)
      : file_{shown(path.string())},
        in_{arenite::shared_detail::open_input(path, what, most, file_)},
        whole_lines_{whole_lines} {}

  /// Looks for the header: the first line of which one separator makes `wanted` of the columns that
  /// `match(names)` finds. Lines above it are titles; the one that comes closest is the header if there is none
  /// before a row of numbers or the end, and if none comes close one with as many fields as the numbers, or the
  /// most. Throws `error` for numbers below nothing of a header, with its cure.
  template <class Match>
  bool find_header(int wanted, const Match& match, std::string_view cure = "") {
    HeaderMatch most;
    for (std::string above; next_line(); above = line_) {
      const auto numbers = separator_of_numbers(0);
      for (const char separator : separators_of_header()) {
        auto names = names_in(line_, separator);
        if (names.empty()) continue;
        const HeaderMatch found = match(names);
        if (found < most ||
            (found == most && (found.found > 0 || separator == ' ' || names.size() <= header_.size())) ||
            (found.found == 0 && numbers))
          continue;
        most = found;
        header_ = std::move(names);
        separator_ = separator;
      }
      if (most.found == wanted) return true;
      if (!numbers) continue;
      if (most.found > 0 || header_.size() == names_in(line_, *numbers).size() ||
          is_header(above, *numbers) || (is_number(line_) && is_header(above, '\t')))
        return false;
      throw error(joined_text({file_, ": line ", row_,
                               " is a row of numbers, and no header names the columns; put a line such as "
                               "\"time_s,deceleration_g\" first",
                               cure}));
    }
    return false;
  }

  /// Looks for the first row of at least `least` numbers, which `next` then reads. The line above is the header
  /// if it has as many fields, else the columns are named "1", "2" and so on. Throws `error` if there is no such
  /// row, or if that is not the first.
  void find_numbers(std::size_t least) {
    std::size_t line_above = 0;
    for (std::string above; next_line(); above = line_, line_above = row_) {
      const auto numbers = separator_of_numbers(least);
      if (!numbers) continue;
      if (std::ranges::any_of(names_in(above, *numbers), is_number))
        throw error(joined_text({file_, ": line ", line_above, " = ", shown(above), ": must be a row of ",
                                 names_in(line_, *numbers).size(),
                                 " numbers, as the one below it; put # before a title"}));
      if (!is_header(above, *numbers)) {
        separator_ = *numbers;
        for (std::size_t n = names_in(line_, separator_).size(); header_.size() < n;)
          header_.push_back(joined_text({header_.size() + 1}));
      }
      pending_ = true;
      return;
    }
    if (row_ > 0)
      throw error(joined_text({file_, ": has no row of ", least > 1 ? joined_text({least, " or more "}) : "",
                               "numbers alone; give columns by their names in a header"}));
  }

  /// The next row; false at the end.
  bool next() {
    do {
      if (!std::exchange(pending_, false) && !next_line()) return finished();
      auto fields = detail::fields_of(line_, separator_);
      if (!fields) refuse("", ": leaves a quote open");
      fields_ = std::move(*fields);
    } while (std::ranges::all_of(fields_, [](const std::string& field) { return field.empty(); }));
    while (fields_.size() > header_.size() && fields_.back().empty()) fields_.pop_back();
    if (fields_.size() != header_.size())
      refuse(joined_text({", number of fields = ", fields_.size(), ": must be ", header_.size(),
                          ", as in the header"}),
             separator_ == ',' ? "; numbers with decimal commas need semicolons between them" : "");
    return true;
  }

  const std::string& file() const { return file_; }
  const std::vector<std::string>& header() const { return header_; }
  const std::vector<std::string>& fields() const { return fields_; }
  /// Line of the file, from 1 on.
  std::size_t line() const { return row_; }

  /// A field of this row as a number. Throws `error` that names line and column.
  double number(std::size_t column) {
    const std::string& text = fields_[column];
    const bool comma = text.find(',') != std::string::npos, point = text.find('.') != std::string::npos;
    if (comma && comma_line_ == 0) comma_line_ = row_;
    if (point && point_line_ == 0) point_line_ = row_;
    if ((comma || point) && comma_line_ > 0 && point_line_ > 0)
      refuse(column, joined_text({"a file has one decimal mark and none between thousands; line ",
                                  comma_line_, " has a comma, line ", point_line_, " a point"}));
    const auto value = detail::number_with_comma(text);
    if (!value || !std::isfinite(*value))
      refuse(column, text.find(':') == std::string::npos
                         ? "must be a number"
                         : "must be a number; turn times of the clock into seconds, or give --rate");
    if (comma && ambiguous_.empty() && !decimal_comma_) ambiguous_ = text;
    decimal_comma_ = decimal_comma_ || (comma && detail::is_decimal_comma(text));
    return *value;
  }

  /// Throws `error` of this row and a field of it.
  [[noreturn]] void refuse(std::size_t column, const std::string& rule) const {
    refuse(joined_text({", column ", shown(header_[column]), " = ", shown(fields_[column])}), ": " + rule);
  }

 private:
  static constexpr char separators[] = {'\t', ';', ',', ' '};

  static bool is_number(const std::string& text) { return detail::number_with_comma(text).has_value(); }
  /// Fields of a line, without empty ones at its end; none if it leaves a quote open.
  static std::vector<std::string> names_in(const std::string& line, char separator) {
    auto names = detail::fields_of(line, separator).value_or(std::vector<std::string>{});
    while (!names.empty() && names.back().empty()) names.pop_back();
    return names;
  }
  /// Those that split this line; with only blanks between its words it may also be one name.
  std::string separators_of_header() const {
    std::string found;
    for (const char s : separators) {
      if (s == ' ' && found.empty()) found = "\t";
      if (names_in(line_, s).size() > 1) found += s;
    }
    return found;
  }
  /// The one that makes this line a row of at least `least` numbers. Throws `error` if a comma may be it, or the
  /// decimal mark of a column that is chosen by number.
  std::optional<char> separator_of_numbers(std::size_t least) const {
    std::optional<char> found;
    std::size_t most = 0;
    for (const char s : separators) {
      const auto names = names_in(line_, s);
      if (names.empty() || names.size() < least || !std::ranges::all_of(names, is_number)) continue;
      if (found && least > 0 && names.size() != most)
        refuse(" = " + shown(line_),
               ": may be one number with a decimal comma, or two; write points, or give the column by its "
               "name in a header");
      if (names.size() > most) found = s;
      most = std::max(most, names.size());
    }
    return found;
  }
  /// Whether a line names the columns of this one, the first row of numbers.
  bool is_header(const std::string& line, char separator) {
    auto names = names_in(line, separator);
    if (names.size() != names_in(line_, separator).size()) return false;
    header_ = std::move(names);
    separator_ = separator;
    return true;
  }

  [[noreturn]] void refuse(const std::string& where, const std::string& rule) const {
    throw error(joined_text({file_, ": line ", row_, where, rule}));
  }

  /// The next line that is neither empty nor a comment.
  bool next_line() {
    while (detail::next_row(in_, line_, file_)) {
      ++row_;
      if (whole_lines_ && in_.eof()) return false;
      if (line_.find('\0') != std::string::npos ||
          (row_ == 1 && (line_.starts_with("\xff\xfe") || line_.starts_with("\xfe\xff"))))
        throw error(joined_text({file_, ": is UTF-16, or no text; save it as text in UTF-8 (CSV)"}));
      if (row_ == 1 && line_.starts_with("\xef\xbb\xbf")) line_.erase(0, 3);
      if (line_.ends_with('\r')) line_.pop_back();
      if (line_.find('\r') != std::string::npos) refuse("", ": holds a CR; lines must end with LF or CR LF");
      const std::size_t begin = line_.find_first_not_of(" \t");
      if (begin != std::string::npos && line_[begin] != '#') return true;
    }
    return false;
  }

  bool finished() const {
    if (!decimal_comma_ && !ambiguous_.empty())
      throw error(joined_text({file_, ": line ", comma_line_, ": ", shown(ambiguous_),
                               " may have a decimal comma, or a mark between thousands, and no other number "
                               "tells; write points"}));
    return false;
  }

  std::string file_;  ///< as messages show it
  std::ifstream in_;
  bool whole_lines_;
  std::string line_;
  std::size_t row_ = 0;
  bool pending_ = false;  ///< the line is a row that `next` has not read yet
  char separator_ = ',';
  std::vector<std::string> header_, fields_;
  std::size_t comma_line_ = 0, point_line_ = 0;  ///< the first with such a mark; 0: none
  bool decimal_comma_ = false;  ///< a number shows that the comma is no mark between thousands
  std::string ambiguous_;       ///< the first number that does not
};

}  // namespace arenite::ffp
