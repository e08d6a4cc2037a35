// Numbers in sentences, and the sentence that a drop comes to.
#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "results.hpp"
#include "shown.hpp"

namespace arenite::ffp {

/// Three significant digits; "1960", not "1.96e+03".
inline std::string rounded(double x) {
  std::array<char, 32> text{};
  if (std::abs(x) >= 1000 && std::abs(x) < 1e7) {
    const double unit = std::pow(10, std::floor(std::log10(std::abs(x))) - 2);
    std::snprintf(text.data(), text.size(), "%.0f", std::round(x / unit) * unit);
  } else {
    std::snprintf(text.data(), text.size(), "%.3g", x);
  }
  return text.data();
}

/// "40 s", "12 min", "5 h" or "3 days".
inline std::string duration(double seconds) {
  if (seconds < 100) return rounded(std::ceil(seconds)) + " s";
  if (seconds < 100 * 60) return rounded(std::round(seconds / 60)) + " min";
  if (seconds < 100 * 3600) return rounded(std::round(seconds / 3600)) + " h";
  return rounded(std::round(seconds / 86400)) + " days";
}

/// What a drop came to, in one line.
inline std::string sentence_of(const DropFigures& f, const std::string& folder) {
  using arenite::detail::join;
  return join("The penetrometer stands at ", rounded(f.final_penetration_m), " m at ", rounded(f.end_s * 1e3),
              " ms (deepest: ", rounded(f.max_penetration_m), " m at ", rounded(f.max_penetration_time_s * 1e3),
              " ms); its deceleration peaked at ", rounded(f.peak.value_g), " g at ",
              rounded(f.peak.time_s * 1e3), " ms and ", rounded(f.peak.penetration_m), " m. Files: ",
              shown(folder));
}

}  // namespace arenite::ffp
