// ARENITE_KERNEL: marks a loop over points or nodes. All that it calls is inlined, so that packs stay in
// registers across calls (G2P of tetrahedra 14.0 -> 8.8 ns a point), but not under sanitizers, where g++
// would take six times as long to compile a scene, and not without optimisation. A build may give it as nothing
// (-DARENITE_KERNEL=): tests are compiled in six to eight tenths of the time, and run as fast at -O1.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#ifdef ARENITE_KERNEL
#elif !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ARENITE_KERNEL
#else
#define ARENITE_KERNEL [[gnu::flatten]]
#ifdef __clang__
// Functions that kernels call are between ARENITE_INLINE_BEGIN and ARENITE_INLINE_END; lambdas of a kernel itself have ARENITE_INLINE
// after their parameters: `flatten` of clang++ inlines only the calls in the function itself, that of g++ also all calls below them.
#define ARENITE_INLINE __attribute__((always_inline))
#define ARENITE_INLINE_BEGIN \
  _Pragma("clang attribute push(__attribute__((always_inline)), apply_to = function)")
#define ARENITE_INLINE_END _Pragma("clang attribute pop")
#endif
#endif
#ifndef ARENITE_INLINE
#define ARENITE_INLINE
#define ARENITE_INLINE_BEGIN
#define ARENITE_INLINE_END
#endif
