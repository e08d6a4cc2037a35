// Text of a user's in a message: one line, and not too long.
#pragma once

#include <string>
#include <string_view>

namespace arenite::ffp {

/// `text` with a blank in the place of each control character; if longer than `most` bytes, without its middle: "start .. end". Whole
/// UTF-8 characters.
inline std::string shown(std::string_view text, std::size_t most = 120) {
  const auto within = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80; };
  std::string line;
  if (text.size() <= most) {
    line = text;
  } else {
    std::size_t head = most / 2, tail = text.size() - most / 2;
    while (head > 0 && within(head)) --head;
    while (tail < text.size() && within(tail)) ++tail;
    line = std::string{text.substr(0, head)} + " .. " + std::string{text.substr(tail)};
  }
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  return line;
}

}  // namespace arenite::ffp
