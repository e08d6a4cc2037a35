// Units at the call site: the library computes in SI and radians; `40_deg`, `5_MPa`, `1_cm` convert.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
inline namespace literals {

// Angle, rad.
constexpr double operator""_deg(long double x) { return static_cast<double>(x) * pi / 180; }
constexpr double operator""_deg(unsigned long long x) { return static_cast<double>(x) * pi / 180; }
// Stress, Pa.
constexpr double operator""_Pa(long double x) { return static_cast<double>(x); }
constexpr double operator""_Pa(unsigned long long x) { return static_cast<double>(x); }
constexpr double operator""_kPa(long double x) { return static_cast<double>(x) * 1e3; }
constexpr double operator""_kPa(unsigned long long x) { return static_cast<double>(x) * 1e3; }
constexpr double operator""_MPa(long double x) { return static_cast<double>(x) * 1e6; }
constexpr double operator""_MPa(unsigned long long x) { return static_cast<double>(x) * 1e6; }
constexpr double operator""_GPa(long double x) { return static_cast<double>(x) * 1e9; }
constexpr double operator""_GPa(unsigned long long x) { return static_cast<double>(x) * 1e9; }
// Length, m.
constexpr double operator""_m(long double x) { return static_cast<double>(x); }
constexpr double operator""_m(unsigned long long x) { return static_cast<double>(x); }
constexpr double operator""_cm(long double x) { return static_cast<double>(x) * 1e-2; }
constexpr double operator""_cm(unsigned long long x) { return static_cast<double>(x) * 1e-2; }
constexpr double operator""_mm(long double x) { return static_cast<double>(x) * 1e-3; }
constexpr double operator""_mm(unsigned long long x) { return static_cast<double>(x) * 1e-3; }

}  // namespace literals
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
