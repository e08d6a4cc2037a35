// Requirements: what a translation unit must be compiled with, in one sentence. `core/instruction_set.hpp`,
// which nearly every header takes, includes it first.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <version>  // of a standard library, which may undefine min and max

#if defined(__clang__) && !defined(__apple_build_version__) && __clang_major__ < 13 || \
    defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 12
#error "Arenite needs g++ 12 or clang++ 13, or newer"
#elif __cplusplus < 202002L
#error "Arenite needs C++20: compile with -std=c++20"
#elif !defined(__cpp_exceptions)
#error "Arenite tells errors by exceptions: compile without -fno-exceptions"
#elif defined(__FAST_MATH__) || __FINITE_MATH_ONLY__ || defined(__ASSOCIATIVE_MATH__) || \
    defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error \
    "Arenite must see NaN, and add and divide as written: compile without -ffast-math, -Ofast, -funsafe-math-optimizations, -ffinite-math-only, -fassociative-math, -freciprocal-math and -fno-signed-zeros; -fno-math-errno and -fno-trapping-math are fine"
#elif __FLT_EVAL_METHOD__ == 2
#error \
    "Arenite must round each operation to its type, which the x87 unit does not: compile with -msse2 -mfpmath=sse"
#elif defined(min) || defined(max) || defined(check) || defined(require) || defined(A) || defined(B) || \
    defined(C) || defined(D) || defined(E) || defined(F) || defined(G) || defined(H) || defined(K) ||   \
    defined(L) || defined(M) || defined(N) || defined(P) || defined(Q) || defined(R) || defined(S) ||   \
    defined(T) || defined(U) || defined(V) || defined(W) || defined(X) || defined(Z)
#error \
    "A macro has a name that Arenite uses (min, max, check, require or one capital letter): #undef it, or include Arenite before it is defined (windows.h: define NOMINMAX)"
#elif !__has_include(<Eigen/Core>)
#error \
    "Arenite needs Eigen 3.4 or newer: install it (Debian, Ubuntu: libeigen3-dev) and compile with -isystem and the folder that has Eigen/Core (there /usr/include/eigen3)"
#endif

static_assert(0.1 != 0.1F,
              "Arenite needs constants of double precision: compile without -fsingle-precision-constant");

// clang++ defines no macro for -fassociative-math and -funsafe-math-optimizations. With them it would fold
// (x + y) - y, by which numbers are rounded (simd/elementary.hpp). From here on sums are as written.
#ifdef __clang__
#pragma clang fp reassociate(off)
#endif
