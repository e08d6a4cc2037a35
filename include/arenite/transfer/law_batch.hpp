// Law batch: collects the strain increments of many points and takes their stresses through the law in packs.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include <arenite/core/pack.hpp>
#include <arenite/law/law.hpp>

namespace arenite {

/// Sums of a pass over the points, each in a fixed order.
struct DeformSums {
  double work = 0;           ///< work of the stresses, J
  double opened_volume = 0;  ///< voids that opened without stress, m3
  double check = 0;          ///< finite as long as every position, velocity, stress and volume is
};

/// exp(x) for the x of one step by its Pade approximant (4, 4): relative error x^9 / 25401600, positive for
/// any x, and exact in exp(x) exp(-x) = 1.
template <class T>
T small_exp(const T& x) {
  const T x2 = x * x;
  const T even = T(1) + x2 * (T(3.0 / 28) + x2 * T(1.0 / 1680));
  const T odd = x * (T(0.5) + x2 * T(1.0 / 84));
  return (even + odd) / (even - odd);
}

/// Points whose increments are known and whose stresses wait. `Bytes`: of a register, which makes the width
/// of the packs.
template <class T, int D, std::size_t Bytes>
class LawBatch {
 public:
  static constexpr std::size_t capacity = 256;
  bool full() const { return count_ == capacity; }

  void add(Index point, const Increment<T, D>& inc) {
    for (std::size_t k = 0; k < inc.strain.size; ++k) strain_[k][count_] = inc.strain[k];
    for (std::size_t k = 0; k < inc.spin.size(); ++k) spin_[k][count_] = inc.spin[k];
    point_[count_++] = point;
  }

  /// Updates stress, history and volume of the points added since the last call. A volume follows the trace
  /// of the strain less what opened: V = V_0 exp(sum (tr de - opening)).
  template <class L, class Points>
  void flush(const L& law, Points& points, DeformSums& sums) {
    constexpr int width = law_width<L>;
    for (std::size_t at = 0; at < count_; at += width)
      update<Pack<T, width>, width>(law, points, at, std::min<std::size_t>(width, count_ - at), sums);
    count_ = 0;
  }

  /// Width of the packs in which a law is called: a register's worth, or less if the law says so (`static
  /// constexpr int widest`).
  template <class L>
  static constexpr int law_width = [] {
    constexpr int fits = static_cast<int>(Bytes / sizeof(T));
    if constexpr (requires { L::widest; })
      return L::widest < fits ? L::widest : fits;
    else
      return fits;
  }();

 private:
  template <class P, int W, class L, class Points>
  void update(const L& law, Points& points, std::size_t at, std::size_t n, DeformSums& sums) {
    using Value = std::conditional_t<W == 1, T, P>;
    using History = typename L::template History<Value>;
    // The last pack of a batch is filled up with its last point; what comes of the copies is not stored.
    const auto id = [&](std::size_t lane) { return point_[at + std::min(lane, n - 1)]; };
    const auto take = [&](auto&& read) {
      alignas(sizeof(T) * W) std::array<T, W> lane;
      for (std::size_t k = 0; k < W; ++k) lane[k] = read(k);
      if constexpr (W == 1)
        return lane[0];
      else
        return P::load(lane.data());
    };
    const auto give = [&](const Value& value, auto&& write) {
      alignas(sizeof(T) * W) std::array<T, W> lane;
      if constexpr (W == 1)
        lane[0] = value;
      else
        value.store(lane.data());
      for (std::size_t k = 0; k < n; ++k) write(point_[at + k], lane[k]);
    };
    Increment<Value, D> inc;
    const auto column = [&](const std::array<T, capacity>& from) {
      return take([&](std::size_t k) { return from[at + std::min(k, n - 1)]; });
    };
    for (std::size_t k = 0; k < inc.strain.size; ++k) inc.strain[k] = column(strain_[k]);
    for (std::size_t k = 0; k < inc.spin.size(); ++k) inc.spin[k] = column(spin_[k]);
    Sym<Value, D> stress;
    for (std::size_t c = 0; c < stress.size; ++c)
      stress[c] = take([&](std::size_t k) { return points.stress[id(k)][c]; });
    const Value before = take([&](std::size_t k) { return points.volume[id(k)]; });
    History history{};
    each_history<L>(history, points, [&](Value& value, auto& values) {
      value = take([&](std::size_t k) { return values[id(k)]; });
    });

    const Sym<Value, D> old = stress;
    const Value opening = law.update(stress, inc, history);
    const Value after = before * small_exp(Value(trace(inc.strain) - opening));
    const Value work = (before + after) * contract(old + stress, inc.strain) * Value(0.25);

    each_history<L>(history, points, [&](const Value& value, auto& values) {
      give(value, [&](Index p, T v) { values[p] = v; });
    });
    for (std::size_t c = 0; c < stress.size; ++c)
      give(stress[c], [&](Index p, T v) { points.stress[p][c] = v; });
    give(after, [&](Index p, T v) { points.volume[p] = v; });
    give(work, [&](Index, T v) { sums.work += static_cast<double>(v); });
    give(after * opening, [&](Index, T v) { sums.opened_volume += static_cast<double>(v); });
    give(trace(stress) + stress[3] + after, [&](Index, T v) { sums.check += static_cast<double>(v); });
  }

  /// Calls `f(member, column)` for each scalar of the history.
  template <class L, class History, class Points, class F>
  static void each_history(History& history, Points& points, F&& f) {
    std::apply(
        [&](auto&... member) {
          [[maybe_unused]] std::size_t k = 0;
          (f(member, points.history[k++]), ...);
        },
        history.members());
  }

  std::array<Index, capacity> point_;
  std::array<std::array<T, capacity>, Sym<T, D>::size> strain_;
  std::array<std::array<T, capacity>, D == 2 ? 1 : 3> spin_;
  std::size_t count_ = 0;
};

}  // namespace arenite
