// Exact sum: doubles added without rounding, so that the sum is the same in any order.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A sum of up to 2^29 doubles as one long integer in units of 2^-1126, below all doubles (Kulisch 2013, Computer Arithmetic and
/// Validity, ch. 8). Its words have 32 bits each and room for carries: words of sums are added as plain integers.
class ExactSum {
 public:
  static constexpr std::size_t words = 72;

  void add(double x) {
    if (!std::isfinite(x)) {
      ++word_[std::isnan(x) ? no_number : x > 0 ? infinite : minus_infinite];
      return;
    }
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    const auto digits = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    const std::uint64_t size = static_cast<std::uint64_t>(digits < 0 ? -digits : digits);
    const auto shift = static_cast<std::size_t>(exponent + 1073);
    const std::size_t at = shift / 32, bit = shift % 32;
    const std::uint64_t low = (size & mask) << bit, high = (size >> 32) << bit;
    const std::int64_t sign = digits < 0 ? -1 : 1;
    word_[at] += sign * static_cast<std::int64_t>(low & mask);
    word_[at + 1] += sign * static_cast<std::int64_t>((low >> 32) + (high & mask));
    word_[at + 2] += sign * static_cast<std::int64_t>(high >> 32);
  }

  /// The words, which may be added to those of another sum.
  std::span<std::int64_t, words> all() { return word_; }

  /// The sum, rounded once to the nearest double.
  double value() const {
    if (word_[no_number] > 0 || (word_[infinite] > 0 && word_[minus_infinite] > 0))
      return std::numeric_limits<double>::quiet_NaN();
    if (word_[infinite] > 0) return std::numeric_limits<double>::infinity();
    if (word_[minus_infinite] > 0) return -std::numeric_limits<double>::infinity();
    auto digits = word_;
    carry(digits);
    const bool negative = digits[top] < 0;
    if (negative) {
      for (std::size_t k = 0; k <= top; ++k) digits[k] = -digits[k];
      carry(digits);
    }
    std::size_t first = top;
    while (first > 0 && digits[first] == 0) --first;
    if (digits[first] == 0) return 0;
    // The 64 leading bits; the last one is also set if any below it is (a sticky bit): rounding happens once.
    const int unused = std::countl_zero(static_cast<std::uint64_t>(digits[first]));  // 32 or more, of 64
    std::uint64_t leading = static_cast<std::uint64_t>(digits[first]) << unused;
    int filled = 64 - unused;
    bool below = false;
    for (std::size_t k = first; k-- > 0;) {
      const auto next = static_cast<std::uint64_t>(digits[k]);
      const int room = 64 - filled;
      if (room >= 32) {
        leading |= next << (room - 32);
        filled += 32;
      } else {
        leading |= next >> (32 - room);
        below = below || (next & ((std::uint64_t{1} << (32 - room)) - 1)) != 0;
        filled = 64;
      }
    }
    if (below) leading |= 1;
    const int exponent = static_cast<int>(32 * first) - unused - 1126;  // of the last of the 64 bits
    const double size = std::ldexp(static_cast<double>(leading), exponent);
    return negative ? -size : size;
  }

 private:
  static constexpr std::uint64_t mask = 0xffffffff;
  static constexpr std::size_t top = 68, no_number = 69, infinite = 70, minus_infinite = 71;

  /// Leaves 32 bits in each word but the top one, which has the sign.
  static void carry(std::array<std::int64_t, words>& digits) {
    for (std::size_t k = 0; k < top; ++k) {
      digits[k + 1] += digits[k] >> 32;
      digits[k] &= static_cast<std::int64_t>(mask);
    }
  }

  std::array<std::int64_t, words> word_{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
