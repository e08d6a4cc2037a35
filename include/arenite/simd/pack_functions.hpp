// Functions of packs: what <cmath> has for a scalar, lane by lane with the functions of `std`, so that a lane
// has the bits of a scalar. A law over a scalar T says `using std::pow;` and then `pow(x, y)`: for a pack the
// function here is found by its argument. (`sqrt`, `abs`, `min` and `max` are whole-register operations of
// `Pack`.)
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <type_traits>

#include <arenite/simd/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// The pack among one or two types.
template <class A, class B = A>
using pack_of = std::conditional_t<is_pack<A>, A, B>;

template <class First, class... More>
auto refuse_std_function(const First& first, [[maybe_unused]] const More&... more) {
  static_assert(
      !(is_pack<First> || ... || is_pack<More>),
      "a pack: the functions of std take one number: say using std::pow; and then pow(x, y) without "
      "std::, and so exp, log, tanh, ..; see arenite/simd/pack_functions.hpp");
  if constexpr (is_pack<First>)
    return first;
  else
    return (more, ...);
}

}  // namespace detail

#define ARENITE_OF_ONE_PACK(f)                                      \
  template <class P>                                                \
  requires is_pack<P> P f(const P& x) {                             \
    P y = x;                                                        \
    for (int k = 0; k < lane_count<P>; ++k) y.set(k, std::f(x[k])); \
    return y;                                                       \
  }
#define ARENITE_OF_TWO_PACKS(f)                                                     \
  template <class A, class B>                                                       \
  requires(is_pack<A> || is_pack<B>) auto f(const A& a, const B& b) {               \
    const detail::pack_of<A, B> x(a), y(b);                                         \
    auto z = x;                                                                     \
    for (int k = 0; k < lane_count<decltype(z)>; ++k) z.set(k, std::f(x[k], y[k])); \
    return z;                                                                       \
  }
#define ARENITE_FUNCTIONS_OF_ONE(list)                                                                  \
  list(exp) list(exp2) list(expm1) list(log) list(log2) list(log10) list(log1p) list(cbrt) list(sin)    \
      list(cos) list(tan) list(asin) list(acos) list(atan) list(sinh) list(cosh) list(tanh) list(asinh) \
          list(acosh) list(atanh) list(erf) list(floor) list(ceil)
#define ARENITE_FUNCTIONS_OF_TWO(list) list(pow) list(atan2) list(hypot)

ARENITE_FUNCTIONS_OF_ONE(ARENITE_OF_ONE_PACK)
ARENITE_FUNCTIONS_OF_TWO(ARENITE_OF_TWO_PACKS)

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

// In `std`, so that a law which names it hears one sentence and not of each of its overloads. Less
// specialised than the functions above, and called with no types but packs: no call that compiles means
// another thing.
#define ARENITE_REFUSED(f)                                                                         \
  template <class First, class... More>                                                            \
  requires(arenite::is_pack<First> || ... || arenite::is_pack<More>) auto f(const First& first,    \
                                                                            const More&... more) { \
    return arenite::detail::refuse_std_function(first, more...);                                   \
  }
namespace std {
ARENITE_FUNCTIONS_OF_ONE(ARENITE_REFUSED)
ARENITE_FUNCTIONS_OF_TWO(ARENITE_REFUSED)
ARENITE_REFUSED(sqrt)
ARENITE_REFUSED(abs)
ARENITE_REFUSED(fabs)
}  // namespace std

#undef ARENITE_OF_ONE_PACK
#undef ARENITE_OF_TWO_PACKS
#undef ARENITE_FUNCTIONS_OF_ONE
#undef ARENITE_FUNCTIONS_OF_TWO
#undef ARENITE_REFUSED
