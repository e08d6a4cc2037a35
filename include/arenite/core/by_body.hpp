// Values of bodies: as many as a scene names, or as many as only a run knows.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// In the place of a count that only a run knows.
inline constexpr std::size_t counted_at_run_time = static_cast<std::size_t>(-1);

/// Values X, one a body: an array, or a vector where only a run knows how many there are.
template <class X, std::size_t Count>
using ByBody = std::conditional_t<Count == counted_at_run_time, std::vector<X>,
                                  std::array<X, Count == counted_at_run_time ? 0 : Count>>;
template <class X, std::size_t Count>
ByBody<X, Count> by_body([[maybe_unused]] std::size_t count) {
  if constexpr (Count == counted_at_run_time)
    return ByBody<X, Count>(count);
  else
    return {};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
