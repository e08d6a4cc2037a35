#include "words.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include <arenite/io/output_file.hpp>

namespace arenite::ffp {

std::string shown(std::string_view text, std::size_t most) {
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

std::string exactly(double x) {
  std::string text;
  append_number(text, x);
  return text;
}

std::string rounded(double x) {
  std::array<char, 32> text{};
  if (std::abs(x) >= 1000 && std::abs(x) < 1e7) {
    const double unit = std::pow(10, std::floor(std::log10(std::abs(x))) - 2);
    std::snprintf(text.data(), text.size(), "%.0f", std::round(x / unit) * unit);
  } else {
    std::snprintf(text.data(), text.size(), "%.3g", x);
  }
  return text.data();
}

std::string duration(double seconds) {
  if (seconds < 100) return rounded(std::ceil(seconds)) + " s";
  if (seconds < 100 * 60) return rounded(std::round(seconds / 60)) + " min";
  if (seconds < 100 * 3600) return rounded(std::round(seconds / 3600)) + " h";
  return rounded(std::round(seconds / 86400)) + " days";
}

}  // namespace arenite::ffp
