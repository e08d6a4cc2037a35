// Twin packs: more scalars than a register holds, as two packs that are computed side by side. A law's chain
// of operations leaves most of a processor idle; two chains at once share it.
#pragma once

#include <arenite/core/pack.hpp>

namespace arenite {

/// Mask of a twin pack.
template <class T, int W>
requires(sizeof(T) * static_cast<std::size_t>(W) > detail::widest_register) class Mask<T, W> {
 public:
  using Half = Mask<T, W / 2>;
  Mask() = default;
  constexpr Mask(bool all) : low_(all), high_(all) {}
  Mask(const Half& low, const Half& high) : low_(low), high_(high) {}

  /// A mask has no one truth: write `select(mask, a, b)`, `any_of(mask)` or `all_of(mask)` instead of a
  /// branch.
  operator bool() const = delete;

  bool operator[](int lane) const { return lane < W / 2 ? low_[lane] : high_[lane - W / 2]; }
  const Half& low() const { return low_; }
  const Half& high() const { return high_; }

  friend Mask operator&&(const Mask& a, const Mask& b) { return {a.low_ && b.low_, a.high_ && b.high_}; }
  friend Mask operator||(const Mask& a, const Mask& b) { return {a.low_ || b.low_, a.high_ || b.high_}; }
  friend Mask operator!(const Mask& a) { return {!a.low_, !a.high_}; }
  friend bool any_of(const Mask& a) { return any_of(a.low_ || a.high_); }
  friend bool all_of(const Mask& a) { return all_of(a.low_ && a.high_); }

 private:
  Half low_, high_;
};

/// W scalars in two packs; the operations of `Pack`.
template <class T, int W>
requires(sizeof(T) * static_cast<std::size_t>(W) > detail::widest_register) class Pack<T, W> {
 public:
  using Half = Pack<T, W / 2>;
  using scalar = T;
  using mask = Mask<T, W>;
  static constexpr int width = W;

  Pack() = default;
  template <class S>
  requires std::is_arithmetic_v<S>
  constexpr Pack(S value) : low_(value), high_(value) {}
  Pack(const Half& low, const Half& high) : low_(low), high_(high) {}

  static Pack load(const T* from) { return {Half::load(from), Half::load(from + W / 2)}; }
  static Pack load(const T* from, int count, T fill = T(0)) {
    if (count <= W / 2) return {Half::load(from, count, fill), Half(fill)};
    return {Half::load(from), Half::load(from + W / 2, count - W / 2, fill)};
  }
  void store(T* to) const {
    low_.store(to);
    high_.store(to + W / 2);
  }
  void store(T* to, int count) const {
    if (count <= W / 2) return low_.store(to, count);
    low_.store(to);
    high_.store(to + W / 2, count - W / 2);
  }

  T operator[](int lane) const { return lane < W / 2 ? low_[lane] : high_[lane - W / 2]; }
  void set(int lane, T value) { lane < W / 2 ? low_.set(lane, value) : high_.set(lane - W / 2, value); }
  const Half& low() const { return low_; }
  const Half& high() const { return high_; }

  Pack& operator+=(const Pack& b) { return *this = *this + b; }
  Pack& operator-=(const Pack& b) { return *this = *this - b; }
  Pack& operator*=(const Pack& b) { return *this = *this * b; }
  Pack& operator/=(const Pack& b) { return *this = *this / b; }

  friend Pack operator+(const Pack& a, const Pack& b) { return {a.low_ + b.low_, a.high_ + b.high_}; }
  friend Pack operator-(const Pack& a, const Pack& b) { return {a.low_ - b.low_, a.high_ - b.high_}; }
  friend Pack operator*(const Pack& a, const Pack& b) { return {a.low_ * b.low_, a.high_ * b.high_}; }
  friend Pack operator/(const Pack& a, const Pack& b) { return {a.low_ / b.low_, a.high_ / b.high_}; }
  friend Pack operator-(const Pack& a) { return {-a.low_, -a.high_}; }

  friend mask operator<(const Pack& a, const Pack& b) { return {a.low_ < b.low_, a.high_ < b.high_}; }
  friend mask operator>(const Pack& a, const Pack& b) { return {a.low_ > b.low_, a.high_ > b.high_}; }
  friend mask operator<=(const Pack& a, const Pack& b) { return {a.low_ <= b.low_, a.high_ <= b.high_}; }
  friend mask operator>=(const Pack& a, const Pack& b) { return {a.low_ >= b.low_, a.high_ >= b.high_}; }
  friend mask operator==(const Pack& a, const Pack& b) { return {a.low_ == b.low_, a.high_ == b.high_}; }
  friend mask operator!=(const Pack& a, const Pack& b) { return {a.low_ != b.low_, a.high_ != b.high_}; }

  friend Pack select(const mask& m, const Pack& a, const Pack& b) {
    return {select(m.low(), a.low_, b.low_), select(m.high(), a.high_, b.high_)};
  }
  friend Pack min(const Pack& a, const Pack& b) { return {min(a.low_, b.low_), min(a.high_, b.high_)}; }
  friend Pack max(const Pack& a, const Pack& b) { return {max(a.low_, b.low_), max(a.high_, b.high_)}; }
  friend Pack abs(const Pack& a) { return {abs(a.low_), abs(a.high_)}; }
  friend Pack sqrt(const Pack& a) { return {sqrt(a.low_), sqrt(a.high_)}; }
  friend Pack reciprocal(const Pack& a) { return {reciprocal(a.low_), reciprocal(a.high_)}; }
  friend Pack reciprocal_root(const Pack& a) { return {reciprocal_root(a.low_), reciprocal_root(a.high_)}; }

 private:
  Half low_, high_;
};

}  // namespace arenite
