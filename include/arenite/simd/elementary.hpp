// Elementary functions for scalars and packs alike: the same operations in the same order, so that a lane has
// the bits of a scalar. To a few units in the last place, each on the range that it names.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <arenite/simd/pack_pair.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// Where the bits of a number are: `exponent_at`, and a number that rounds what it is added to.
template <class T>
struct FloatBits {
  static constexpr int exponent_at = std::numeric_limits<T>::digits - 1;
  static constexpr T whole = static_cast<T>(std::uint64_t{1} << exponent_at);
  static constexpr T rounder = whole * T(1.5);
  static constexpr int bias = std::numeric_limits<T>::max_exponent - 1;
  using integer = lane_integer<T>;
  static constexpr integer fraction = (integer{1} << exponent_at) - 1;
};

/// x 2^n for a whole n, x and the result normal and positive.
template <real_scalar T>
T times_power_of_two(T x, T n) {
  using F = FloatBits<T>;
  using bits = std::make_unsigned_t<typename F::integer>;
  return std::bit_cast<T>(std::bit_cast<bits>(x) + (std::bit_cast<bits>(n + F::rounder) << F::exponent_at));
}
template <class T, int W>
Pack<T, W> times_power_of_two(const Pack<T, W>& x, const Pack<T, W>& n) {
  using F = FloatBits<T>;
  using bits = typename Pack<T, W>::mask::vector;
  using vector = typename Pack<T, W>::vector;
  const Pack<T, W> rounded = n + Pack<T, W>(F::rounder);
  return Pack<T, W>::from(vector(bits(x.lanes()) + (bits(rounded.lanes()) << F::exponent_at)));
}
template <class Half>
PackPair<Half> times_power_of_two(const PackPair<Half>& x, const PackPair<Half>& n) {
  return {times_power_of_two(x.low(), n.low()), times_power_of_two(x.high(), n.high())};
}

/// x = fraction 2^power with the fraction in [1, 2) and a whole power; x normal and positive.
template <class T>
struct FractionAndPower {
  T fraction, power;
};
template <real_scalar T>
FractionAndPower<T> split_power(T x) {
  using F = FloatBits<T>;
  using integer = typename F::integer;
  const auto b = std::bit_cast<integer>(x);
  return {std::bit_cast<T>((b & F::fraction) | std::bit_cast<integer>(T(1))),
          std::bit_cast<T>((b >> F::exponent_at) | std::bit_cast<integer>(F::whole)) - (F::whole + F::bias)};
}
template <class T, int W>
FractionAndPower<Pack<T, W>> split_power(const Pack<T, W>& x) {
  using F = FloatBits<T>;
  using P = Pack<T, W>;
  using bits = typename P::mask::vector;
  using vector = typename P::vector;
  const auto b = bits(x.lanes());
  const auto one = std::bit_cast<typename F::integer>(T(1)),
             whole = std::bit_cast<typename F::integer>(F::whole);
  return {P::from(vector((b & F::fraction) | one)),
          P::from(vector((b >> F::exponent_at) | whole)) - P(F::whole + F::bias)};
}
template <class Half>
FractionAndPower<PackPair<Half>> split_power(const PackPair<Half>& x) {
  const auto low = split_power(x.low()), high = split_power(x.high());
  return {{low.fraction, high.fraction}, {low.power, high.power}};
}

}  // namespace detail

/// tan(x), 0 <= x < pi/2, by the continued fraction of x/2 and the double angle.
template <class T>
T lane_tan(const T& x) {
  const T half = x * T(0.5), z = half * half;
  const T above = half * (T(34459425) + z * (T(-4729725) + z * (T(135135) + z * (T(-990) + z))));
  const T below = T(34459425) + z * (T(-16216200) + z * (T(945945) + z * (T(-13860) + z * T(45))));
  return T(2) * above * below / ((below - above) * (below + above));
}

/// exp(-x), x >= 0, by Pade's approximant (5, 5) between powers of two; beyond x = 80 that of 80, 2e-35.
template <class T>
T lane_exp_minus(const T& x) {
  using std::min;
  using S = scalar_of<T>;
  const T y = min(x, T(80)), rounder = T(detail::FloatBits<S>::rounder);
  const T n = (y * T(-1.4426950408889634) + rounder) - rounder;
  // ln 2 in two parts, of which the first times n is exact.
  constexpr double high = sizeof(S) == 4 ? 0.693359375 : 0.693147180369123816490;
  constexpr double low = sizeof(S) == 4 ? -2.12194440054690583e-4 : 1.90821492927058770002e-10;
  const T r = (T(0) - y - n * T(high)) - n * T(low), z = r * r;
  const T even = T(1) + z * (T(1.0 / 9) + z * T(1.0 / 1008));
  const T odd = r * (T(0.5) + z * (T(1.0 / 72) + z * T(1.0 / 30240)));
  using detail::times_power_of_two;
  return times_power_of_two(T((even + odd) / (even - odd)), n);
}

/// The natural logarithm of x, normal and positive, by the series of atanh.
template <class T>
T lane_log(const T& x) {
  using detail::split_power;
  auto [m, power] = split_power(x);
  const auto above = m > T(1.4142135623730951);
  m = select(above, T(m * T(0.5)), m);
  power = select(above, T(power + T(1)), power);
  const T s = (m - T(1)) / (m + T(1)), z = s * s;
  T sum = T(2.0 / 21);
  for (int k = 19; k >= 1; k -= 2) sum = sum * z + T(2.0 / k);
  return power * T(0.69314718055994531) + s * sum;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
