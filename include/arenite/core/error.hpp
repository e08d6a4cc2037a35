// Errors: what a user's mistake and a failed run say. A programmer's mistake is an assert instead.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

#include <arenite/core/cold.hpp>
#include <arenite/core/instruction_set.hpp>

namespace arenite {  // not in the inline namespace: an exception has one type for all instruction sets, or `catch` would miss it

/// A value that breaks a rule. The message names the value and the rule.
class error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A run that failed physically (NaN, inverted mesh, used-up compressing zone). Names time, place and cause.
class run_error : public error {
 public:
  using error::error;
};

}  // namespace arenite

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A part of a message: words, which it does not own, or a number. Made for the time of one call.
class TextPart {
 public:
  TextPart(const char* words) : kind_(Kind::words), words_(words) {}
  TextPart(std::string_view words) : kind_(Kind::words), words_(words) {}
  TextPart(const std::string& words) : kind_(Kind::words), words_(words) {}
  TextPart(char letter) : kind_(Kind::letter), letter_(letter) {}
  TextPart(std::floating_point auto number) : kind_(Kind::real), real_(static_cast<double>(number)) {}
  TextPart(std::signed_integral auto number) : kind_(Kind::whole), whole_(number) {}
  TextPart(std::unsigned_integral auto number) : kind_(Kind::count), count_(number) {}

  /// Writes the part at the end of a text, a number with ten digits.
  void add_to(std::string& text) const;

 private:
  enum class Kind : char { words, letter, real, whole, count };
  Kind kind_;
  union {
    std::string_view words_;
    char letter_;
    double real_;
    long long whole_;
    unsigned long long count_;
  };
};

using TextParts = std::initializer_list<TextPart>;

/// The parts concatenated, as the text of a message.
std::string joined_text(TextParts parts);

/// "(1, 2, 3)" of a vector's components.
template <class Vector>
std::string vector_text(const Vector& v) {
  std::string text = "(";
  for (decltype(v.size()) k = 0; k < v.size(); ++k) text += joined_text({k > 0 ? ", " : "", v[k]});
  text += ")";
  return text;
}

/// Throws `error("name = value: rule")`.
[[noreturn]] void refuse(TextParts name, TextPart value, TextParts rule);

/// Refuses the value unless `holds`. Write the condition so that NaN fails it. Name and rule are words, or
/// parts that are joined only when needed.
inline void require(bool holds, TextPart name, TextPart value, TextPart rule) {
  if (!holds) [[unlikely]]
    refuse({name}, value, {rule});
}
inline void require(bool holds, TextParts name, TextPart value, TextPart rule) {
  if (!holds) [[unlikely]]
    refuse(name, value, {rule});
}
inline void require(bool holds, TextPart name, TextPart value, TextParts rule) {
  if (!holds) [[unlikely]]
    refuse({name}, value, rule);
}
inline void require(bool holds, TextParts name, TextPart value, TextParts rule) {
  if (!holds) [[unlikely]]
    refuse(name, value, rule);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <charconv>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void TextPart::add_to(std::string& text) const {
  if (kind_ == Kind::words) {
    text += words_;
  } else if (kind_ == Kind::letter) {
    text += letter_;
  } else {
    char digits[32];
    char* const end = kind_ == Kind::real
                          ? std::to_chars(digits, digits + 32, real_, std::chars_format::general, 10).ptr
                      : kind_ == Kind::whole ? std::to_chars(digits, digits + 32, whole_).ptr
                                             : std::to_chars(digits, digits + 32, count_).ptr;
    text.append(digits, end);
  }
}

ARENITE_COLD std::string joined_text(TextParts parts) {
  std::string text;
  for (const TextPart& part : parts) part.add_to(text);
  return text;
}

ARENITE_COLD void refuse(TextParts name, TextPart value, TextParts rule) {
  std::string text = joined_text(name);
  text += " = ";
  value.add_to(text);
  text += ": ";
  throw error(text += joined_text(rule));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
