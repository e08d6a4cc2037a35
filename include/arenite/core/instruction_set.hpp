// Instruction set: what this translation unit is compiled for, as the name of an inline namespace. All code
// depends on the compiler's flags; were functions named alike in units with other flags, the linker would
// keep one of each and give it to all, also where the processor does not have its instructions.
// `arenite::Scene` is `arenite::avx2_fma::Scene` to the linker. A name can only come from a macro, which
// no flag sets. Outside are exceptions, and what tells where the one thread pool is (core/once.hpp).
#pragma once

#include <arenite/core/requirements.hpp>

#if defined(__AVX512F__) && defined(__FMA__)
#define ARENITE_INSTRUCTION_SET avx512_fma
#elif defined(__AVX512F__)
#define ARENITE_INSTRUCTION_SET avx512
#elif defined(__AVX2__) && defined(__FMA__)
#define ARENITE_INSTRUCTION_SET avx2_fma
#elif defined(__AVX2__)
#define ARENITE_INSTRUCTION_SET avx2
#elif defined(__AVX__) && defined(__FMA__)
#define ARENITE_INSTRUCTION_SET avx_fma
#elif defined(__AVX__)
#define ARENITE_INSTRUCTION_SET avx
#elif defined(__SSE4_1__)
#define ARENITE_INSTRUCTION_SET sse4
#elif defined(__SSE2__)
#define ARENITE_INSTRUCTION_SET sse2
#else
#define ARENITE_INSTRUCTION_SET plain
#endif
