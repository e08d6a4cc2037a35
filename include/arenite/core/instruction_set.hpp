// Instruction set: what this translation unit is compiled for, and the library's version, as the name of an
// inline namespace. All code depends on the compiler's flags; were functions named alike in units with other
// flags, the linker would keep one of each and give it to all, also where the processor does not have its
// instructions. `arenite::Scene` is `arenite::v0_1_avx2_fma::Scene` to the linker, so that libraries that were
// built with other versions work in one program, too. A name can only come from a macro, which no flag sets.
// Outside of it are exceptions, and the pointer to the one thread pool (core/once.hpp).
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/requirements.hpp>
#include <arenite/version.hpp>

#define ARENITE_NAMESPACE_FOR(set) \
  ARENITE_VERSIONED_NAME(ARENITE_VERSION_MAJOR, ARENITE_VERSION_MINOR, _##set)

#if defined(__AVX512F__) && defined(__AVX512VL__) && defined(__FMA__)
#define ARENITE_INSTRUCTION_SET ARENITE_NAMESPACE_FOR(avx512vl_fma)
#elif defined(__AVX512F__) && defined(__FMA__)
#define ARENITE_INSTRUCTION_SET ARENITE_NAMESPACE_FOR(avx512_fma)
#elif defined(__AVX512F__)
#define ARENITE_INSTRUCTION_SET ARENITE_NAMESPACE_FOR(avx512)
#elif defined(__AVX2__) && defined(__FMA__)
#define ARENITE_INSTRUCTION_SET ARENITE_NAMESPACE_FOR(avx2_fma)
#elif defined(__AVX2__)
#define ARENITE_INSTRUCTION_SET ARENITE_NAMESPACE_FOR(avx2)
#elif defined(__AVX__) && defined(__FMA__)
#define ARENITE_INSTRUCTION_SET ARENITE_NAMESPACE_FOR(avx_fma)
#elif defined(__AVX__)
#define ARENITE_INSTRUCTION_SET ARENITE_NAMESPACE_FOR(avx)
#elif defined(__SSE4_1__)
#define ARENITE_INSTRUCTION_SET ARENITE_NAMESPACE_FOR(sse4)
#elif defined(__SSE2__)
#define ARENITE_INSTRUCTION_SET ARENITE_NAMESPACE_FOR(sse2)
#else
#define ARENITE_INSTRUCTION_SET ARENITE_NAMESPACE_FOR(plain)
#endif
