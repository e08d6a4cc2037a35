// A scalar that counts the operations done on it: a law called with it gives its floating point operations.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace arenite::bench {

/// A number of type T; every +, -, *, /, square root and reciprocal of any of them adds one to `operations`.
/// Comparisons, negations and choices are not counted.
template <class T>
struct Counting {
  using scalar = T;
  static inline long operations = 0;
  T v{};

  Counting() = default;
  template <class S>
  requires std::is_arithmetic_v<S>
  constexpr Counting(S value) : v(static_cast<T>(value)) {}

  friend Counting operator+(Counting a, Counting b) { return count(a.v + b.v); }
  friend Counting operator-(Counting a, Counting b) { return count(a.v - b.v); }
  friend Counting operator*(Counting a, Counting b) { return count(a.v * b.v); }
  friend Counting operator/(Counting a, Counting b) { return count(a.v / b.v); }
  friend Counting operator-(Counting a) { return Counting(-a.v); }
  Counting& operator+=(Counting b) { return *this = *this + b; }
  Counting& operator-=(Counting b) { return *this = *this - b; }
  Counting& operator*=(Counting b) { return *this = *this * b; }
  Counting& operator/=(Counting b) { return *this = *this / b; }
  friend auto operator<=>(const Counting&, const Counting&) = default;
  friend bool operator==(const Counting&, const Counting&) = default;

  friend Counting sqrt(Counting a) { return count(std::sqrt(a.v)); }
  friend Counting reciprocal(Counting a) { return count(1 / a.v); }
  friend Counting reciprocal_root(Counting a) { return count(1 / std::sqrt(a.v)); }
  friend Counting abs(Counting a) { return Counting(std::abs(a.v)); }
  friend Counting min(Counting a, Counting b) { return b.v < a.v ? b : a; }
  friend Counting max(Counting a, Counting b) { return a.v < b.v ? b : a; }
  friend Counting times_power_of_two(Counting a, Counting n) {
    return Counting(std::ldexp(a.v, static_cast<int>(n.v)));
  }
  friend auto split_power(Counting a) {
    int power = 0;
    const T half = std::frexp(a.v, &power);
    return std::array{Counting(2 * half), Counting(power - 1)};
  }
  friend Counting select(bool mask, Counting a, Counting b) { return mask ? a : b; }

 private:
  static Counting count(T value) {
    ++operations;
    return Counting(value);
  }
};

}  // namespace arenite::bench
