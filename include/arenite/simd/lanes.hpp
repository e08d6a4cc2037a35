// Lanes: what a kernel over many points needs beside arithmetic, for packs and plain scalars alike: loads and
// stores of part of a pack, and sums over its lanes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <utility>

#include <arenite/simd/kernel.hpp>
#include <arenite/simd/pack_pair.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Whether P is a pack, or a pair of packs.
template <class P>
inline constexpr bool is_pack = false;
template <class T, int W>
inline constexpr bool is_pack<Pack<T, W>> = true;
template <class Half>
inline constexpr bool is_pack<PackPair<Half>> = true;

/// W neighbours as one value: a pack, or the scalar itself for W = 1.
template <class T, int W>
using lanes_of = std::conditional_t<W == 1, T, Pack<T, W>>;

/// Scalars in P: 1 for a scalar.
template <class P>
inline constexpr int lane_count = 1;
template <class T, int W>
inline constexpr int lane_count<Pack<T, W>> = W;
template <class Half>
inline constexpr int lane_count<PackPair<Half>> = 2 * Half::width;

/// `count` neighbours from memory; lanes after them are `fill`.
template <class P, class T>
P load_lanes(const T* from, int count, T fill = T(0)) {
  if constexpr (is_pack<P>)
    return P::load(from, count, fill);
  else
    return *from;
}
/// The first `count` lanes to memory.
template <class P, class T>
void store_lanes(T* to, int count, const P& value) {
  if constexpr (is_pack<P>)
    value.store(to, count);
  else
    *to = value;
}

/// Lanes from number `count` on: those that a load of `count` neighbours has filled.
template <class P>
auto lanes_from(int count) {
  if constexpr (is_pack<P>) {
    P lane;
    for (int k = 0; k < lane_count<P>; ++k) lane.set(k, static_cast<typename P::scalar>(k));
    return lane >= P(static_cast<typename P::scalar>(count));
  } else {
    return count < 1;
  }
}

/// Makes the compiler read `value` from memory again after this call. A loop over few points that uses many
/// scalars of a table is then faster: otherwise compilers load all of them into registers before the loop and
/// spill them.
template <class V>
void reload_from_memory(const V& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// One lane of what a comparison gives.
constexpr bool in_lane(bool mask, int) { return mask; }
template <class M>
bool in_lane(const M& mask, int k) {
  return mask[k];
}

/// Calls `f(k)` for k in [0, N): written out for few, whatever the optimiser's level, so that what k names
/// stays in registers; a loop for many.
template <std::size_t N, class F>
ARENITE_INLINE constexpr void repeat(F&& f) {
  if constexpr (N <= 32) {
    [&]<std::size_t... K>(std::index_sequence<K...>) ARENITE_INLINE { (f(K), ...); }
    (std::make_index_sequence<N>{});
  } else {
    for (std::size_t k = 0; k < N; ++k) f(k);
  }
}

/// Transposes the squares of `Size` rows by `Size` neighbouring lanes: exchanges the blocks of `Block` lanes
/// off the diagonals of squares of two blocks by two, then larger ones.
template <int Block = 1, class T, int W, std::size_t Size>
void transpose_lanes(std::array<Pack<T, W>, Size>& row) {
  if constexpr (Block < static_cast<int>(Size)) {
    [&]<std::size_t... At>(std::index_sequence<At...>) {
      repeat<Size>([&](std::size_t r) {
        if (r & Block) return;
        const auto a = row[r].lanes(), b = row[r + Block].lanes();
        row[r] = Pack<T, W>::from(__builtin_shufflevector(a, b, ((At & Block) ? At - Block + W : At)...));
        row[r + Block] =
            Pack<T, W>::from(__builtin_shufflevector(a, b, ((At & Block) ? At + W : At + Block)...));
      });
    }
    (std::make_index_sequence<static_cast<std::size_t>(W)>{});
    transpose_lanes<2 * Block>(row);
  }
}

/// Two packs as one, the lanes of `a` first.
template <class T, int W>
Pack<T, 2 * W> join_packs(const Pack<T, W>& a, const Pack<T, W>& b) {
  return [&]<std::size_t... At>(std::index_sequence<At...>) {
    return Pack<T, 2 * W>::from(__builtin_shufflevector(a.lanes(), b.lanes(), At...));
  }
  (std::make_index_sequence<static_cast<std::size_t>(2 * W)>{});
}

namespace detail {

/// One step of many sums at once: the lower half of each group of `Group` lanes becomes the sum of a's
/// halves, the upper half that of b's. One operand is a blend, for which processors have more ports than for
/// moves between lanes.
template <int Group, class T, int W, std::size_t... At>
Pack<T, W> fold(const Pack<T, W>& a, const Pack<T, W>& b, std::index_sequence<At...>) {
  constexpr auto upper = [](std::size_t lane) { return (lane & (Group / 2)) != 0; };
  return Pack<T, W>::from(
      __builtin_shufflevector(a.lanes(), b.lanes(), (upper(At) ? At + W : At)...) +
      __builtin_shufflevector(a.lanes(), b.lanes(), (upper(At) ? At + W - Group / 2 : At + Group / 2)...));
}

/// Greatest lane, by halves: the greatest of each lane and the one half the lanes away.
template <class T, int W>
T greatest(const Pack<T, W>& a) {
  if constexpr (W == 1) {
    return a[0];
  } else {
    const auto half = [&]<std::size_t... At>(std::index_sequence<At...>) {
      return max(Pack<T, W / 2>::from(__builtin_shufflevector(a.lanes(), a.lanes(), At...)),
                 Pack<T, W / 2>::from(__builtin_shufflevector(a.lanes(), a.lanes(), (At + W / 2)...)));
    };
    return greatest(half(std::make_index_sequence<static_cast<std::size_t>(W / 2)>{}));
  }
}

/// Sums of `Count` packs, number `First` and then every `Stride`th (zeros after the last): as often as there
/// are lanes in a group of W / Count, each sum is all that is left of its pack.
template <std::size_t First, std::size_t Stride, int Count, class T, int W, std::size_t N>
Pack<T, W> folded(const std::array<Pack<T, W>, N>& packs) {
  if constexpr (First >= N) {
    return Pack<T, W>(0);
  } else if constexpr (Count == 1) {
    return packs[First];
  } else {
    return fold<2 * W / Count>(folded<First, 2 * Stride, Count / 2>(packs),
                               folded<First + Stride, 2 * Stride, Count / 2>(packs),
                               std::make_index_sequence<static_cast<std::size_t>(W)>{});
  }
}

/// `lane_sums` of packs. A separate function: g++ 12 copies an array that is returned out of a nested block.
template <class T, int W, std::size_t N>
auto summed(const std::array<Pack<T, W>, N>& packs) {
  constexpr std::size_t width = static_cast<std::size_t>(W), registers = (N + width - 1) / width;
  std::array<T, registers * width + 3> sums;
  [&]<std::size_t... R>(std::index_sequence<R...>) {
    (folded<R * width, 1, W>(packs).store(sums.data() + R * width), ...);
  }
  (std::make_index_sequence<registers>{});
  for (std::size_t k = N; k < sums.size(); ++k) sums[k] = 0;
  return sums;
}

}  // namespace detail

/// Sums of the lanes of N packs, in the first N places of the array; W packs are summed with W - 1 additions,
/// for their sums fill a register. At least three more places may be read.
template <class P, std::size_t N>
auto lane_sums(const std::array<P, N>& packs) {
  if constexpr (requires { typename P::Half; }) {
    std::array<typename P::Half, N> halves;
    for (std::size_t k = 0; k < N; ++k) halves[k] = packs[k].low() + packs[k].high();
    return lane_sums(halves);
  } else if constexpr (is_pack<P>) {
    return detail::summed(packs);
  } else {
    std::array<P, N + 3> sums{};
    for (std::size_t k = 0; k < N; ++k) sums[k] = packs[k];
    return sums;
  }
}

/// The greatest of the lanes.
template <class P>
auto greatest_lane(const P& a) {
  if constexpr (requires { typename P::Half; }) {
    return greatest_lane(max(a.low(), a.high()));
  } else if constexpr (is_pack<P>) {
    return detail::greatest(a);
  } else {
    return a;
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
