// Cold functions: what runs rarely and is no template over a scene, such as messages, checks and files. They are declared in their header
// and defined at its end, `#if ARENITE_HAS_COLD`, with the includes that only they need. A program that only includes the headers
// compiles them, as inline functions; in one that links the target arenite::cold (which sets ARENITE_COLD_LIBRARY) they are compiled once,
// in the unit that includes cold.hpp. ARENITE_ONCE is for those that are no templates either, but run often: the pool of threads.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#if defined(ARENITE_COLD_LIBRARY) && !defined(ARENITE_COLD_HERE)
#define ARENITE_HAS_COLD 0
#else
#define ARENITE_HAS_COLD 1
#endif

#ifdef ARENITE_COLD_LIBRARY
#define ARENITE_ONCE
#else
#define ARENITE_ONCE inline
#endif
// Not `gnu::cold`: for size g++ would leave functions of the standard library and of Eigen as they are, which have one name for all
// instruction sets (tests/flags).
#define ARENITE_COLD [[gnu::noinline]] ARENITE_ONCE

// Explicit instantiations in arenite::cold: LIST(D), LIST(T) or LIST(T, D) for each dimension and number type that it has.
#ifdef ARENITE_COLD_LIBRARY
#define ARENITE_FOR_DIMENSIONS(LIST) LIST(2) LIST(3)
#define ARENITE_FOR_NUMBERS(LIST) LIST(float) LIST(double) LIST(long double)
#define ARENITE_FOR_NUMBERS_AND_DIMENSIONS(LIST) \
  LIST(float, 2) LIST(float, 3) LIST(double, 2) LIST(double, 3) LIST(long double, 2) LIST(long double, 3)
#else
#define ARENITE_FOR_DIMENSIONS(LIST)
#define ARENITE_FOR_NUMBERS(LIST)
#define ARENITE_FOR_NUMBERS_AND_DIMENSIONS(LIST)
#endif
