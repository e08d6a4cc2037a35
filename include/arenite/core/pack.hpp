// A pack: W scalars that a law computes with at once, over the vector types of GCC and Clang. Its operators
// are a scalar's, so that one source serves both; a comparison gives a mask, which no `if` accepts.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <arenite/core/scalar.hpp>

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace arenite {

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

}  // namespace detail

/// The answer to a comparison of packs: true or false in each lane. `select`, `any_of` and `all_of` read it.
template <class T, int W>
class Mask {
 public:
  using vector = typename detail::VectorOf<detail::lane_integer<T>, W>::type;

  Mask() = default;
  constexpr Mask(bool all) : v_(vector{} - static_cast<detail::lane_integer<T>>(all)) {}
  template <class V>
  requires(sizeof(V) == sizeof(vector) && !std::is_arithmetic_v<V>) explicit constexpr Mask(const V& lanes)
      : v_((vector)lanes) {}

  /// A mask has no one truth: write `select(mask, a, b)`, `any_of(mask)` or `all_of(mask)` instead of a
  /// branch.
  operator bool() const = delete;

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
  constexpr Pack(S value) : v_(vector{} + static_cast<T>(value)) {}

  /// W scalars from memory that need not be aligned.
  static Pack load(const T* from) {
    Pack a;
    std::memcpy(&a.v_, from, sizeof(vector));
    return a;
  }
  /// `count` <= W scalars from memory; the lanes after them hold `fill`. Reads nothing behind them.
  static Pack load(const T* from, int count, T fill = T(0)) {
    Pack a(fill);
    for (int i = 0; i < W && i < count; ++i) a.v_[i] = from[i];
    return a;
  }
  void store(T* to) const { std::memcpy(to, &v_, sizeof(vector)); }
  /// Writes the first `count` <= W lanes and nothing behind them.
  void store(T* to, int count) const {
    for (int i = 0; i < W && i < count; ++i) to[i] = v_[i];
  }

  T operator[](int lane) const { return v_[lane]; }
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
    return Pack((vector)((bits)a.v_ & magnitude));
  }
  friend Pack sqrt(const Pack& a) {
    T x[W], root[W];
    a.store(x);
    detail::Roots<T, W>::of(x, root);
    return load(root);
  }

 private:
  explicit constexpr Pack(const vector& lanes) : v_(lanes) {}

  vector v_;
};

}  // namespace arenite
