// Law pass: updates the stresses of neighbouring points by their law, a pack at a time, from the strains of a
// step in a buffer.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>

#include <arenite/law/law.hpp>
#include <arenite/simd/kernel.hpp>
#include <arenite/simd/lanes.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Sums of a pass over the points, each in a fixed order.
struct G2pSums {
  double work = 0;           ///< work of the stresses, J; 0 unless asked for
  double ending_work = 0;    ///< their work if they were those at the end of the step, J; as `work`
  double opened_volume = 0;  ///< voids that opened without stress, m3
  double check = 0;          ///< finite as long as every position, stress and volume is

  friend G2pSums operator+(const G2pSums& a, const G2pSums& b) {
    return {a.work + b.work, a.ending_work + b.ending_work, a.opened_volume + b.opened_volume,
            a.check + b.check};
  }
};

/// exp(x) for the x of one step by its Pade approximant (4, 4): relative error x^9 / 25401600, positive for
/// any x.
template <class T>
T small_exp(const T& x) {
  const T x2 = x * x;
  const T even = T(1) + x2 * (T(3.0 / 28) + x2 * T(1.0 / 1680));
  const T odd = x * (T(0.5) + x2 * T(1.0 / 84));
  return (even + odd) * reciprocal(T(even - odd));
}

/// Strains and spins of a run of points in one step, by column; kept small enough to stay in the nearest
/// cache. `StoresBearing`: whether the volume that carries a point's stress, and with which the stress does
/// work, may differ from the point's own.
template <class T, int D, bool StoresBearing = false>
struct StrainBuffer {
  static constexpr std::size_t capacity = 256, slack = 128 / sizeof(T);
  static constexpr std::size_t strain_size = Sym<T, D>::size, spin_size = D == 2 ? 1 : 3;

  /// Of points `at`, .. of the buffer. Lanes after the last point are overwritten by the next.
  template <class P>
  void store(std::size_t at, const StrainStep<P, D>& step) {
    repeat<strain_size>(
        [&](std::size_t k) { store_lanes(column_[k].data() + at, lane_count<P>, step.strain[k]); });
    repeat<spin_size>([&](std::size_t k) {
      store_lanes(column_[strain_size + k].data() + at, lane_count<P>, step.spin[k]);
    });
  }
  /// Takes those from `at` on with `lanes(place of the first)`.
  template <class P, class Lanes>
  void load(std::size_t at, StrainStep<P, D>& step, Lanes&& lanes) const {
    repeat<strain_size>([&](std::size_t k) { step.strain[k] = lanes(column_[k].data() + at); });
    repeat<spin_size>([&](std::size_t k) { step.spin[k] = lanes(column_[strain_size + k].data() + at); });
  }

  /// Volume that carries the stress of points `at`, .. over their own volume, -.
  void store_volume_factor(std::size_t at, std::size_t count, T volume_factor) {
    std::fill_n(volume_factor_.begin() + static_cast<std::ptrdiff_t>(at), count, volume_factor);
  }
  template <class P>
  P load_volume_factor(std::size_t at) const {
    return load_lanes<P>(volume_factor_.data() + at, lane_count<P>);
  }

 private:
  std::array<std::array<T, capacity + slack>, strain_size + spin_size> column_{};
  std::array<T, StoresBearing ? capacity + slack : 0> volume_factor_{};
};

/// Scalar type with which a law is called where `Width` points are computed at once: a pack of them or, if
/// the law requests it, a narrower one or two packs side by side.
template <class L, class T, int Width>
struct LawLanes {
  static constexpr int width = std::min(max_pack_width<L>, Width);
  using type =
      std::conditional_t<two_packs_at_once<L> && (width > 1), PackPair<Pack<T, width>>, lanes_of<T, width>>;
};

/// Stress, history and volume of the points [begin, end) after a step of dt, s, with the strains in
/// `buffer`. A volume follows the trace of the strain minus the opening: V = V_0 exp(sum (tr de - opening)).
/// Matter that dilates stops at its greatest V / V_0: dilation beyond that counts as opening.
/// `TracksWork`: whether the work of the stresses is summed.
template <bool TracksWork, int Width, class L, class Points, class T, int D, bool StoresBearing>
ARENITE_KERNEL void law_pass(const L& law, Points& points, std::size_t begin, std::size_t end,
                             const StrainBuffer<T, D, StoresBearing>& buffer, double dt, G2pSums& sums) {
  using P = typename LawLanes<L, T, Width>::type;
  constexpr int width = lane_count<P>;
  using History = typename L::template History<P>;
  using std::max;
  const auto each_history = [](auto& history, auto& columns, auto&& f) {
    std::apply(
        [&](auto&... member) {
          [[maybe_unused]] std::size_t k = 0;
          (f(member, columns[k++]), ...);
        },
        history.members());
  };
  [[maybe_unused]] P work(0), ending_work(0);
  P opened(0), check(0);
  for (std::size_t p = begin; p < end; p += width) {
    const int count = static_cast<int>(std::min<std::size_t>(width, end - p));
    StrainStep<P, D> step;
    step.dt = dt;
    Sym<P, D> stress;
    P before;
    History history{};
    const auto load = [&](auto&& lanes) {
      buffer.load(p - begin, step, lanes);
      repeat<stress.size>([&](std::size_t k) { stress[k] = lanes(points.stress.column(k).data() + p); });
      each_history(history, points.history,
                   [&](P& value, const auto& column) { value = lanes(column.data() + p); });
    };
    if (count == width) {
      load([](const T* from) { return load_lanes<P>(from, width); });
      before = load_lanes<P>(points.volume.data() + p, width);
    } else {
      // Unused lanes repeat the first point, so that the law is called only with states that a point has.
      // They have no volume, and so no part in the sums.
      load([&](const T* from) { return load_lanes<P>(from, count, *from); });
      before = load_lanes<P>(points.volume.data() + p, count);
    }

    [[maybe_unused]] const Sym<P, D> old = stress;
    const auto [opening, dilation] = inelastic(law.update(stress, step, history));
    P volume = before * small_exp(P(trace(step.strain) - opening));
    if constexpr (dilates<L, T, D>) {
      if (any_of(dilation > P(0))) {
        const T loosest = static_cast<T>(law.greatest_volume_ratio() / law.density());  // m3/kg
        const P limit = max(before, P(P(loosest) * load_lanes<P>(points.mass.data() + p, count)));
        const P beyond = select(dilation > P(0), P(max(P(volume - limit), P(0))), P(0));
        volume -= beyond;
        opened += beyond;
      }
      if constexpr (Points::has_dilation) store_lanes(points.dilation.data() + p, count, dilation);
    }

    each_history(history, points.history,
                 [&](const P& value, auto& column) { store_lanes(column.data() + p, count, value); });
    points.stress.template store<P>(p, count, stress.c);
    store_lanes(points.volume.data() + p, count, volume);
    if constexpr (TracksWork) {
      P done = (before + volume) * contract(old + stress, step.strain) * P(0.25);
      P ending = volume * contract(stress, step.strain);
      if constexpr (StoresBearing) {
        const P volume_factor = buffer.template load_volume_factor<P>(p - begin);
        done = done * volume_factor;
        ending = ending * volume_factor;
      }
      work += done;
      ending_work += ending;
    }
    opened += volume * opening;
    check += (trace(stress) + stress[3]) * volume;
  }
  const auto total = lane_sums(std::array<P, 2>{opened, check});
  sums.opened_volume += static_cast<double>(total[0]);
  sums.check += static_cast<double>(total[1]);
  if constexpr (TracksWork) {
    const auto works = lane_sums(std::array<P, 2>{work, ending_work});
    sums.work += static_cast<double>(works[0]);
    sums.ending_work += static_cast<double>(works[1]);
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
