// Limits of a number that is typed: what the checks test and `--help` shows.
#pragma once

#include <string>

#include <arenite/core/error.hpp>

namespace arenite::ffp {

/// An interval of numbers; NaN lies in none.
struct Range {
  double low, high;
  const char* unit = "";
  bool holds_low = true, holds_high = true;  ///< whether the end belongs to it

  bool contains(double x) const {
    return (x > low || (holds_low && x == low)) && (x < high || (holds_high && x == high));
  }
  /// As in "(0, 50] m/s".
  std::string text() const {
    return joined_text(
        {holds_low ? '[' : '(', low, ", ", high, holds_high ? ']' : ')', *unit ? " " : "", unit});
  }
};

/// (low, high]
constexpr Range above(double low, double high, const char* unit = "") {
  return {low, high, unit, false, true};
}
/// (low, high)
constexpr Range between(double low, double high, const char* unit = "") {
  return {low, high, unit, false, false};
}

}  // namespace arenite::ffp
