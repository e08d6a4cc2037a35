// JSON (RFC 8259) read from a text or a file, which may be anybody's: no content of it may do worse than
// throw. Values nest no deeper than a limit, for they are read, written and destroyed by recursion.
#pragma once

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <arenite/io/input_file.hpp>
#include <arenite/io/output_file.hpp>

#include "json.hpp"
#include "words.hpp"

namespace arenite::ffp {

/// The deepest that arrays and objects lie in each other; a summary has five levels.
inline constexpr int most_json_levels = 64;
/// Largest file; a summary has ten kilobytes.
inline constexpr std::uintmax_t most_json_bytes = std::uintmax_t{16} << 20;

namespace detail {

class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : text_{text} {}

  Json read() {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // a byte order mark
    Json all = value(0);
    if (skip_blanks(); at_ != text_.size()) fail("is no JSON: more follows its value");
    return all;
  }

 private:
  [[noreturn]] void fail(const std::string& rule) const {
    throw json_error(joined_text(rule, ", at byte ", at_));
  }
  void skip_blanks() {
    while (at_ < text_.size() && std::string_view{" \t\r\n"}.find(text_[at_]) != std::string_view::npos)
      ++at_;
  }
  /// The next character that is no blank; 0 at the end.
  char next() {
    skip_blanks();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (next() != c || at_ == text_.size()) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail(joined_text("is no JSON: needs ", c));
  }

  Json value(int levels) {
    const char c = next();
    if ((c == '[' || c == '{') && levels == most_json_levels)
      fail(joined_text("is nested deeper than ", most_json_levels, " levels"));
    if (c == '[') return array(levels + 1);
    if (c == '{') return object(levels + 1);
    if (c == '"') return string();
    for (const auto& [word, meaning] : {std::pair{std::string_view{"true"}, Json(true)},
                                        {std::string_view{"false"}, Json(false)},
                                        {std::string_view{"null"}, Json()}})
      if (text_.substr(at_).starts_with(word)) {
        at_ += word.size();
        return meaning;
      }
    return number();
  }
  Json array(int levels) {
    Json made = Json::array();
    expect('[');
    if (take(']')) return made;
    do made.push_back(value(levels));
    while (take(','));
    expect(']');
    return made;
  }
  Json object(int levels) {
    Json::Object members;
    std::set<std::string, std::less<>> names;
    expect('{');
    if (take('}')) return Json::object();
    do {
      if (next() != '"') fail("is no JSON: needs a name");
      std::string name = string();
      if (!names.insert(name).second) fail(joined_text("gives ", shown(name), " twice"));
      expect(':');
      members.emplace_back(std::move(name), value(levels));
    } while (take(','));
    expect('}');
    return Json::object(std::move(members));
  }

  Json number() {
    const std::size_t end = std::min(text_.find_first_not_of("+-.0123456789eE", at_), text_.size());
    const std::string_view word = text_.substr(at_, end - at_);
    const char *first = word.data(), *last = first + word.size();
    const std::string_view digits = word.substr(word.starts_with('-') ? 1 : 0);
    const auto is_digit = [&](std::size_t at) {
      return at < digits.size() && digits[at] >= '0' && digits[at] <= '9';
    };
    const std::size_t point = digits.find('.');
    if (!is_digit(0) || (digits[0] == '0' && is_digit(1)) ||
        (point != std::string_view::npos && !is_digit(point + 1)))
      fail("is no JSON: needs a value");
    std::int64_t whole = 0;
    if (const auto [to, code] = std::from_chars(first, last, whole); code == std::errc{} && to == last) {
      at_ = end;
      return whole;
    }
    double real = 0;
    const auto [to, code] = std::from_chars(first, last, real);
    if (code == std::errc::result_out_of_range) fail("has a number that is not of ordinary size");
    if (code != std::errc{} || to != last) fail("is no JSON: needs a value");
    at_ = end;
    return real;
  }

  std::string string() {
    std::string made;
    for (++at_;; ++at_) {
      if (at_ >= text_.size()) fail("is no JSON: a text does not end");
      const char c = text_[at_];
      if (static_cast<unsigned char>(c) < 0x20) fail("is no JSON: a control character in a text");
      if (c == '"') break;
      if (c != '\\') {
        const std::size_t length = utf8_length(text_.substr(at_));
        if (length == 0) fail("is no JSON: a text is no UTF-8");
        made += text_.substr(at_, length);
        at_ += length - 1;
        continue;
      }
      ++at_;
      constexpr std::string_view letters = "\"\\/bfnrt", meanings = "\"\\/\b\f\n\r\t";
      const char letter = at_ < text_.size() ? text_[at_] : '\0';
      if (const auto which = letters.find(letter); which != std::string_view::npos)
        made += meanings[which];
      else if (letter == 'u')
        append_utf8(made, character());
      else
        fail("is no JSON: an escape that there is not");
    }
    ++at_;
    return made;
  }
  /// The character of \uXXXX, or of a pair of them; stands at its last digit then.
  std::uint32_t character() {
    const std::uint32_t first = four_digits();
    if (first < 0xD800 || first > 0xDFFF) return first;
    if (first < 0xDC00 && text_.substr(at_ + 1).starts_with("\\u")) {
      at_ += 2;
      if (const std::uint32_t second = four_digits(); second >= 0xDC00 && second <= 0xDFFF)
        return 0x10000 + ((first - 0xD800) << 10) + (second - 0xDC00);
    }
    fail("is no JSON: half of a surrogate pair");
  }
  std::uint32_t four_digits() {
    std::uint32_t code = 0;
    const char* first = text_.data() + at_ + 1;
    if (text_.size() - at_ < 5 || std::from_chars(first, first + 4, code, 16).ptr != first + 4)
      fail("is no JSON: \\u needs four digits");
    at_ += 4;
    return code;
  }
  static void append_utf8(std::string& text, std::uint32_t code) {
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    const auto rest = [&](int shift) { put(0x80 | ((code >> shift) & 0x3F)); };
    if (code < 0x80) return put(code);
    if (code < 0x800) {
      put(0xC0 | (code >> 6));
    } else {
      if (code < 0x10000) {
        put(0xE0 | (code >> 12));
      } else {
        put(0xF0 | (code >> 18));
        rest(12);
      }
      rest(6);
    }
    rest(0);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace detail

/// Throws `json_error` "is no JSON: .., at byte N" or "is nested deeper ..".
inline Json parse_json(std::string_view text) { return detail::JsonReader{text}.read(); }

/// The value in a file. Throws `error` "what = path: rule" if the file cannot be read, is no regular one or
/// is too large, or is no JSON.
inline Json read_json(const std::filesystem::path& path, std::string_view what) {
  const std::string text =
      arenite::shared_detail::read_input(path, what, most_json_bytes, shown(path.string()));
  require(!text.empty(), what, shown(path.string()), "must be a file that is not empty");
  try {
    return parse_json(text);
  } catch (const json_error& e) {
    throw error(joined_text(what, " = ", shown(path.string()), ": ", e.what()));
  }
}

/// Throws `output_error` if the file cannot be written.
inline void write_json(const std::filesystem::path& path, const Json& value) {
  arenite::shared_detail::replace_file(path, [&](std::ostream& out) { out << value.text(2) << '\n'; });
}

}  // namespace arenite::ffp
