// Requirements: what a translation unit must be compiled with, in one sentence. `core/instruction_set.hpp`,
// which nearly every header takes, includes it first.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#if defined(__clang__) && !defined(__apple_build_version__) && __clang_major__ < 13 || \
    defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 12
#error "Arenite needs g++ 12 or clang++ 13, or newer"
#elif __cplusplus < 202002L
#error "Arenite needs C++20: compile with -std=c++20"
#elif !defined(__cpp_exceptions)
#error "Arenite tells errors by exceptions: compile without -fno-exceptions"
#elif defined(__FAST_MATH__) || __FINITE_MATH_ONLY__
#error \
    "Arenite must see NaN: compile without -ffast-math, -Ofast and -ffinite-math-only; -fno-math-errno and -fno-trapping-math are fine"
#elif !__has_include(<Eigen/Core>)
#error \
    "Arenite needs Eigen 3.4 or newer: install it (Debian, Ubuntu: libeigen3-dev) and compile with -isystem and the folder that has Eigen/Core (there /usr/include/eigen3)"
#endif
