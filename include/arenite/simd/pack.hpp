// A pack: W scalars that a law computes with at once, over the vector types of GCC and Clang. Its operators
// are a scalar's, so that one source serves both; a comparison gives a mask, which no `if` accepts.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <arenite/core/scalar.hpp>

// immintrin.h takes ten times as long to parse.
#ifdef __AVX__
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

template <class T>
using lane_integer = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;

/// The compiler's vector of W elements.
template <class T, int W>
struct VectorOf {
  typedef T type __attribute__((vector_size(sizeof(T) * static_cast<std::size_t>(W))));
};

/// Whether any bit of `Bytes` bytes is set: by halves, as whole registers, down to one word.
template <std::size_t Bytes>
bool any_bit(const void* bytes) {
  if constexpr (Bytes <= 8) {
    std::conditional_t<Bytes == 8, std::uint64_t, std::uint32_t> word;
    std::memcpy(&word, bytes, Bytes);
    return word != 0;
  } else {
    typename VectorOf<std::uint32_t, static_cast<int>(Bytes / 8)>::type half[2];
    std::memcpy(half, bytes, Bytes);
    half[0] |= half[1];
    return any_bit<Bytes / 2>(half);
  }
}

/// Roots of N scalars: by halves down to a register of the instruction set. (A loop over `std::sqrt` stays a
/// loop of calls unless errno is switched off by the user's flags.)
template <class T, int N>
struct Roots {
  static void of(const T* x, T* root) {
    if constexpr (N == 1) {
      *root = std::sqrt(*x);
    } else {
      Roots<T, N / 2>::of(x, root);
      Roots<T, N / 2>::of(x + N / 2, root + N / 2);
    }
  }
};
#ifdef __SSE2__
template <>
struct Roots<double, 2> {
  static void of(const double* x, double* root) { _mm_storeu_pd(root, _mm_sqrt_pd(_mm_loadu_pd(x))); }
};
template <>
struct Roots<float, 4> {
  static void of(const float* x, float* root) { _mm_storeu_ps(root, _mm_sqrt_ps(_mm_loadu_ps(x))); }
};
#endif
#ifdef __AVX__
template <>
struct Roots<double, 4> {
  static void of(const double* x, double* root) {
    _mm256_storeu_pd(root, _mm256_sqrt_pd(_mm256_loadu_pd(x)));
  }
};
template <>
struct Roots<float, 8> {
  static void of(const float* x, float* root) { _mm256_storeu_ps(root, _mm256_sqrt_ps(_mm256_loadu_ps(x))); }
};
#endif
// With a zero mask: g++ 12 warns of the undefined register in the plain intrinsic.
#ifdef __AVX512F__
template <>
struct Roots<double, 8> {
  static void of(const double* x, double* root) {
    _mm512_storeu_pd(root, _mm512_maskz_sqrt_pd(0xff, _mm512_loadu_pd(x)));
  }
};
template <>
struct Roots<float, 16> {
  static void of(const float* x, float* root) {
    _mm512_storeu_ps(root, _mm512_maskz_sqrt_ps(0xffff, _mm512_loadu_ps(x)));
  }
};
#endif

/// 1 / x and 1 / sqrt(x) of N scalars. The divider takes 16 cycles and more for a register of doubles; an
/// estimate and Newton's steps, which double its digits, take 5.
template <class T, int W>
struct Estimates {
  static constexpr bool exist = false;
};
#ifdef __AVX512F__
template <>
struct Estimates<double, 8> {
  static constexpr bool exist = true;
  static constexpr int steps = 2;  // from 14 bits
  static void reciprocal(const double* x, double* y) {
    _mm512_storeu_pd(y, _mm512_maskz_rcp14_pd(0xff, _mm512_loadu_pd(x)));
  }
  static void reciprocal_root(const double* x, double* y) {
    _mm512_storeu_pd(y, _mm512_maskz_rsqrt14_pd(0xff, _mm512_loadu_pd(x)));
  }
};
template <>
struct Estimates<float, 16> {
  static constexpr bool exist = true;
  static constexpr int steps = 1;
  static void reciprocal(const float* x, float* y) {
    _mm512_storeu_ps(y, _mm512_maskz_rcp14_ps(0xffff, _mm512_loadu_ps(x)));
  }
  static void reciprocal_root(const float* x, float* y) {
    _mm512_storeu_ps(y, _mm512_maskz_rsqrt14_ps(0xffff, _mm512_loadu_ps(x)));
  }
};
#endif

/// The first `count` of W scalars between memory and a register: with the masks of the instruction set where
/// it has them.
template <class T, int W>
struct Parts {
  static void load(const T* from, int count, T* lanes) {
    if (count == W)
      std::memcpy(lanes, from, W * sizeof(T));
    else
      for (int i = 0; i < count; ++i) lanes[i] = from[i];
  }
  static void store(T* to, int count, const T* lanes) {
    if (count == W)
      std::memcpy(to, lanes, W * sizeof(T));
    else
      for (int i = 0; i < count; ++i) to[i] = lanes[i];
  }
};
#ifdef __SSE2__
template <>
struct Parts<double, 2> {
  static void load(const double* from, int count, double* lanes) {
    if (count == 2) return _mm_storeu_pd(lanes, _mm_loadu_pd(from));
    if (count == 1) _mm_storeu_pd(lanes, _mm_loadl_pd(_mm_loadu_pd(lanes), from));
  }
  static void store(double* to, int count, const double* lanes) {
    if (count == 2) return _mm_storeu_pd(to, _mm_loadu_pd(lanes));
    if (count == 1) _mm_storel_pd(to, _mm_loadu_pd(lanes));
  }
};
template <>
struct Parts<float, 4> {
  // One and two lanes in the lower half, the third in the upper.
  static void load(const float* from, int count, float* lanes) {
    if (count == 4) return _mm_storeu_ps(lanes, _mm_loadu_ps(from));
    __m128 v = _mm_loadu_ps(lanes);
    if (count == 1) v = _mm_move_ss(v, _mm_load_ss(from));
    if (count >= 2) v = _mm_loadl_pi(v, reinterpret_cast<const __m64*>(from));
    if (count == 3) v = _mm_movelh_ps(v, _mm_move_ss(_mm_movehl_ps(v, v), _mm_load_ss(from + 2)));
    _mm_storeu_ps(lanes, v);
  }
  static void store(float* to, int count, const float* lanes) {
    const __m128 v = _mm_loadu_ps(lanes);
    if (count == 4) return _mm_storeu_ps(to, v);
    if (count == 1) _mm_store_ss(to, v);
    if (count >= 2) _mm_storel_pi(reinterpret_cast<__m64*>(to), v);
    if (count == 3) _mm_store_ss(to + 2, _mm_movehl_ps(v, v));
  }
};
#endif
#ifdef __AVX512F__
/// The mask of the first `count` lanes.
template <class Bits>
Bits first_bits(int count) {
  return static_cast<Bits>((1u << count) - 1);
}
#endif
#if defined(__AVX512VL__) && defined(__FMA__)  // as the name of the instruction set has them
// AVX's masked store takes several times as long on AMD's processors.
template <>
struct Parts<double, 4> {
  static void load(const double* from, int count, double* lanes) {
    _mm256_storeu_pd(lanes, _mm256_mask_loadu_pd(_mm256_loadu_pd(lanes), first_bits<__mmask8>(count), from));
  }
  static void store(double* to, int count, const double* lanes) {
    _mm256_mask_storeu_pd(to, first_bits<__mmask8>(count), _mm256_loadu_pd(lanes));
  }
};
template <>
struct Parts<float, 8> {
  static void load(const float* from, int count, float* lanes) {
    _mm256_storeu_ps(lanes, _mm256_mask_loadu_ps(_mm256_loadu_ps(lanes), first_bits<__mmask8>(count), from));
  }
  static void store(float* to, int count, const float* lanes) {
    _mm256_mask_storeu_ps(to, first_bits<__mmask8>(count), _mm256_loadu_ps(lanes));
  }
};
#elif defined(__AVX__)
/// The mask of the first `count` lanes, from the middle of a row of ones and zeros.
template <class Lane, int W>
__m256i first_lanes(int count) {
  alignas(32) static constexpr auto row = [] {
    std::array<Lane, 2 * W> lanes{};
    for (std::size_t k = 0; k < W; ++k) lanes[k] = Lane(-1);
    return lanes;
  }();
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(row.data() + W - count));
}
template <>
struct Parts<double, 4> {
  static void load(const double* from, int count, double* lanes) {
    if (count == 4) return _mm256_storeu_pd(lanes, _mm256_loadu_pd(from));
    const __m256i mask = first_lanes<std::int64_t, 4>(count);
    _mm256_storeu_pd(lanes, _mm256_blendv_pd(_mm256_loadu_pd(lanes), _mm256_maskload_pd(from, mask),
                                             _mm256_castsi256_pd(mask)));
  }
  static void store(double* to, int count, const double* lanes) {
    if (count == 4) return _mm256_storeu_pd(to, _mm256_loadu_pd(lanes));
    _mm256_maskstore_pd(to, first_lanes<std::int64_t, 4>(count), _mm256_loadu_pd(lanes));
  }
};
template <>
struct Parts<float, 8> {
  static void load(const float* from, int count, float* lanes) {
    if (count == 8) return _mm256_storeu_ps(lanes, _mm256_loadu_ps(from));
    const __m256i mask = first_lanes<std::int32_t, 8>(count);
    _mm256_storeu_ps(lanes, _mm256_blendv_ps(_mm256_loadu_ps(lanes), _mm256_maskload_ps(from, mask),
                                             _mm256_castsi256_ps(mask)));
  }
  static void store(float* to, int count, const float* lanes) {
    if (count == 8) return _mm256_storeu_ps(to, _mm256_loadu_ps(lanes));
    _mm256_maskstore_ps(to, first_lanes<std::int32_t, 8>(count), _mm256_loadu_ps(lanes));
  }
};
#endif
#ifdef __AVX512F__
template <>
struct Parts<double, 8> {
  static void load(const double* from, int count, double* lanes) {
    _mm512_storeu_pd(lanes, _mm512_mask_loadu_pd(_mm512_loadu_pd(lanes), first_bits<__mmask8>(count), from));
  }
  static void store(double* to, int count, const double* lanes) {
    _mm512_mask_storeu_pd(to, first_bits<__mmask8>(count), _mm512_loadu_pd(lanes));
  }
};
template <>
struct Parts<float, 16> {
  static void load(const float* from, int count, float* lanes) {
    _mm512_storeu_ps(lanes, _mm512_mask_loadu_ps(_mm512_loadu_ps(lanes), first_bits<__mmask16>(count), from));
  }
  static void store(float* to, int count, const float* lanes) {
    _mm512_mask_storeu_ps(to, first_bits<__mmask16>(count), _mm512_loadu_ps(lanes));
  }
};
#endif

/// In the place of a mask's truth: stops the compiler.
template <class B>
bool refuse_condition() {
  static_assert(!std::same_as<B, bool>,
                "a pack: its lanes may differ in a comparison: use select(mask, a, b), any_of(mask) or "
                "all_of(mask) instead of a branch");
  return false;
}
}  // namespace detail

/// The answer to a comparison of packs: true or false in each lane. `select`, `any_of` and `all_of` read it.
template <class T, int W>
class Mask {
 public:
  using vector = typename detail::VectorOf<detail::lane_integer<T>, W>::type;
  static constexpr int width = W;

  Mask() = default;
  constexpr Mask(bool all) : v_(vector{} - static_cast<detail::lane_integer<T>>(all)) {}
  template <class V>
  requires(sizeof(V) == sizeof(vector) && !std::is_arithmetic_v<V>) explicit constexpr Mask(const V& lanes)
      : v_(vector(lanes)) {}

  /// Lanes may differ, so a mask is no condition: refused by the compiler.
  template <class B>
  requires std::same_as<B, bool>
  operator B() const { return detail::refuse_condition<B>(); }

  bool operator[](int lane) const { return v_[lane] != 0; }
  const vector& lanes() const { return v_; }

  friend Mask operator&&(const Mask& a, const Mask& b) { return Mask(a.v_ & b.v_); }
  friend Mask operator||(const Mask& a, const Mask& b) { return Mask(a.v_ | b.v_); }
  friend Mask operator!(const Mask& a) { return Mask(~a.v_); }

  friend bool any_of(const Mask& a) { return detail::any_bit<sizeof(vector)>(&a.v_); }
  friend bool all_of(const Mask& a) { return !any_of(!a); }

 private:
  vector v_;  // 0 or ~0 in each lane
};

/// W scalars. `Pack(T)` puts one value into each lane, so that `pack * T(2.0)` and `2.0 * pack` read alike.
template <class T, int W>
class Pack {
  static_assert(std::is_floating_point_v<T>, "Pack: the scalar must be float or double");
  static_assert(W >= 1 && std::has_single_bit(static_cast<unsigned>(W)),
                "Pack: the width must be a power of two");

 public:
  using scalar = T;
  using vector = typename detail::VectorOf<T, W>::type;
  using mask = Mask<T, W>;
  static constexpr int width = W;

  Pack() = default;
  template <class S>
  requires std::is_arithmetic_v<S>
  constexpr Pack(S value) : v_(static_cast<T>(value) - vector{}) {}  // x - 0 is x, which compilers know

  /// W scalars from memory that need not be aligned.
  static Pack load(const T* from) {
    Pack a;
    std::memcpy(&a.v_, from, sizeof(vector));
    return a;
  }
  /// `count` <= W scalars from memory; the lanes after them are `fill`. Reads nothing beyond them.
  static Pack load(const T* from, int count, T fill = T(0)) {
    Pack a(fill);
    detail::Parts<T, W>::load(from, count, reinterpret_cast<T*>(&a.v_));
    return a;
  }
  void store(T* to) const { std::memcpy(to, &v_, sizeof(vector)); }
  /// Writes the first `count` <= W lanes and nothing beyond them.
  void store(T* to, int count) const {
    detail::Parts<T, W>::store(to, count, reinterpret_cast<const T*>(&v_));
  }

  T operator[](int lane) const { return v_[lane]; }
  const vector& lanes() const { return v_; }
  static Pack from(const vector& lanes) { return Pack(lanes); }
  void set(int lane, T value) { v_[lane] = value; }

  Pack& operator+=(const Pack& b) { return *this = *this + b; }
  Pack& operator-=(const Pack& b) { return *this = *this - b; }
  Pack& operator*=(const Pack& b) { return *this = *this * b; }
  Pack& operator/=(const Pack& b) { return *this = *this / b; }

  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.v_ + b.v_); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.v_ - b.v_); }
  friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.v_ * b.v_); }
  friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.v_ / b.v_); }
  friend Pack operator-(const Pack& a) { return Pack(-a.v_); }

  friend mask operator<(const Pack& a, const Pack& b) { return mask(a.v_ < b.v_); }
  friend mask operator>(const Pack& a, const Pack& b) { return mask(a.v_ > b.v_); }
  friend mask operator<=(const Pack& a, const Pack& b) { return mask(a.v_ <= b.v_); }
  friend mask operator>=(const Pack& a, const Pack& b) { return mask(a.v_ >= b.v_); }
  friend mask operator==(const Pack& a, const Pack& b) { return mask(a.v_ == b.v_); }
  friend mask operator!=(const Pack& a, const Pack& b) { return mask(a.v_ != b.v_); }

  /// `m ? a : b` in each lane. Both are computed; what is not chosen may be infinite or NaN.
  friend Pack select(const mask& m, const Pack& a, const Pack& b) { return Pack(m.lanes() ? a.v_ : b.v_); }
  friend Pack min(const Pack& a, const Pack& b) { return Pack(b.v_ < a.v_ ? b.v_ : a.v_); }
  friend Pack max(const Pack& a, const Pack& b) { return Pack(a.v_ < b.v_ ? b.v_ : a.v_); }
  friend Pack abs(const Pack& a) {
    using bits = typename mask::vector;
    constexpr auto magnitude = std::numeric_limits<detail::lane_integer<T>>::max();
    return Pack(vector(bits(a.v_) & magnitude));
  }
  friend Pack sqrt(const Pack& a) {
    T x[W], root[W];
    a.store(x);
    detail::Roots<T, W>::of(x, root);
    return load(root);
  }
  /// 1 / a to a few units in the last place, for a from 1e-30 to 1e30.
  friend Pack reciprocal(const Pack& a) {
    if constexpr (detail::Estimates<T, W>::exist) {
      T x[W], estimate[W];
      a.store(x);
      detail::Estimates<T, W>::reciprocal(x, estimate);
      Pack y = load(estimate);
      for (int k = 0; k < detail::Estimates<T, W>::steps; ++k) y = y + y * (Pack(1) - a * y);
      return y;
    } else {
      return Pack(1) / a;
    }
  }
  /// 1 / sqrt(a) to a few units in the last place, for a from 1e-30 to 1e30.
  friend Pack reciprocal_root(const Pack& a) {
    if constexpr (detail::Estimates<T, W>::exist) {
      T x[W], estimate[W];
      a.store(x);
      detail::Estimates<T, W>::reciprocal_root(x, estimate);
      Pack y = load(estimate);
      const Pack half = a * Pack(0.5);
      for (int k = 0; k < detail::Estimates<T, W>::steps; ++k) y = y + y * (Pack(0.5) - half * y * y);
      return y;
    } else {
      return Pack(1) / sqrt(a);
    }
  }

 private:
  explicit constexpr Pack(const vector& lanes) : v_(lanes) {}

  vector v_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
