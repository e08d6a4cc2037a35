// Cold functions of error.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <charconv>

#include <arenite/core/error.hpp>

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
