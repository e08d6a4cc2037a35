// Pack pairs: more scalars than fit in a register, as two packs that are computed side by side. A law's chain
// of dependent operations leaves most of a processor's units idle; a second, independent chain uses them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/simd/pack.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Mask of a pack pair.
template <class Half>
class PackPairMask {
 public:
  PackPairMask() = default;
  constexpr PackPairMask(bool all) : low_(all), high_(all) {}
  PackPairMask(const Half& low, const Half& high) : low_(low), high_(high) {}

  /// Lanes may differ, so a mask is no condition: refused by the compiler.
  template <class B>
  requires std::same_as<B, bool>
  operator B() const { return detail::refuse_condition<B>(); }

  bool operator[](int lane) const { return lane < Half::width ? low_[lane] : high_[lane - Half::width]; }
  const Half& low() const { return low_; }
  const Half& high() const { return high_; }

  friend PackPairMask operator&&(const PackPairMask& a, const PackPairMask& b) {
    return {a.low_ && b.low_, a.high_ && b.high_};
  }
  friend PackPairMask operator||(const PackPairMask& a, const PackPairMask& b) {
    return {a.low_ || b.low_, a.high_ || b.high_};
  }
  friend PackPairMask operator!(const PackPairMask& a) { return {!a.low_, !a.high_}; }
  friend bool any_of(const PackPairMask& a) { return any_of(a.low_ || a.high_); }
  friend bool all_of(const PackPairMask& a) { return all_of(a.low_ && a.high_); }

 private:
  Half low_, high_;
};

/// Two packs `Half` as one; the operations of `Pack`.
template <class Half_>
class PackPair {
 public:
  using Half = Half_;
  using scalar = typename Half::scalar;
  using mask = PackPairMask<typename Half::mask>;
  static constexpr int width = 2 * Half::width;

  PackPair() = default;
  template <class S>
  requires std::is_arithmetic_v<S>
  constexpr PackPair(S value) : low_(value), high_(value) {}
  PackPair(const Half& low, const Half& high) : low_(low), high_(high) {}

  static PackPair load(const scalar* from) { return {Half::load(from), Half::load(from + Half::width)}; }
  static PackPair load(const scalar* from, int count, scalar fill = scalar(0)) {
    if (count <= Half::width) return {Half::load(from, count, fill), Half(fill)};
    return {Half::load(from), Half::load(from + Half::width, count - Half::width, fill)};
  }
  void store(scalar* to) const {
    low_.store(to);
    high_.store(to + Half::width);
  }
  void store(scalar* to, int count) const {
    if (count <= Half::width) return low_.store(to, count);
    low_.store(to);
    high_.store(to + Half::width, count - Half::width);
  }

  scalar operator[](int lane) const { return lane < Half::width ? low_[lane] : high_[lane - Half::width]; }
  void set(int lane, scalar value) {
    lane < Half::width ? low_.set(lane, value) : high_.set(lane - Half::width, value);
  }
  const Half& low() const { return low_; }
  const Half& high() const { return high_; }

  PackPair& operator+=(const PackPair& b) { return *this = *this + b; }
  PackPair& operator-=(const PackPair& b) { return *this = *this - b; }
  PackPair& operator*=(const PackPair& b) { return *this = *this * b; }
  PackPair& operator/=(const PackPair& b) { return *this = *this / b; }

  friend PackPair operator+(const PackPair& a, const PackPair& b) {
    return {a.low_ + b.low_, a.high_ + b.high_};
  }
  friend PackPair operator-(const PackPair& a, const PackPair& b) {
    return {a.low_ - b.low_, a.high_ - b.high_};
  }
  friend PackPair operator*(const PackPair& a, const PackPair& b) {
    return {a.low_ * b.low_, a.high_ * b.high_};
  }
  friend PackPair operator/(const PackPair& a, const PackPair& b) {
    return {a.low_ / b.low_, a.high_ / b.high_};
  }
  friend PackPair operator-(const PackPair& a) { return {-a.low_, -a.high_}; }

  friend mask operator<(const PackPair& a, const PackPair& b) { return {a.low_ < b.low_, a.high_ < b.high_}; }
  friend mask operator>(const PackPair& a, const PackPair& b) { return {a.low_ > b.low_, a.high_ > b.high_}; }
  friend mask operator<=(const PackPair& a, const PackPair& b) {
    return {a.low_ <= b.low_, a.high_ <= b.high_};
  }
  friend mask operator>=(const PackPair& a, const PackPair& b) {
    return {a.low_ >= b.low_, a.high_ >= b.high_};
  }
  friend mask operator==(const PackPair& a, const PackPair& b) {
    return {a.low_ == b.low_, a.high_ == b.high_};
  }
  friend mask operator!=(const PackPair& a, const PackPair& b) {
    return {a.low_ != b.low_, a.high_ != b.high_};
  }

  friend PackPair select(const mask& m, const PackPair& a, const PackPair& b) {
    return {select(m.low(), a.low_, b.low_), select(m.high(), a.high_, b.high_)};
  }
  friend PackPair min(const PackPair& a, const PackPair& b) {
    return {min(a.low_, b.low_), min(a.high_, b.high_)};
  }
  friend PackPair max(const PackPair& a, const PackPair& b) {
    return {max(a.low_, b.low_), max(a.high_, b.high_)};
  }
  friend PackPair abs(const PackPair& a) { return {abs(a.low_), abs(a.high_)}; }
  friend PackPair sqrt(const PackPair& a) { return {sqrt(a.low_), sqrt(a.high_)}; }
  friend PackPair reciprocal(const PackPair& a) { return {reciprocal(a.low_), reciprocal(a.high_)}; }
  friend PackPair reciprocal_root(const PackPair& a) {
    return {reciprocal_root(a.low_), reciprocal_root(a.high_)};
  }

 private:
  Half low_, high_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
