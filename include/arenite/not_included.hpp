// Placeholders: `vtu` without its header gives a compile error that names the header to include.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <type_traits>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Chosen where the functions of `observe/vtu.hpp` are not known.
template <class T = void>
auto vtu(...) {
  static_assert(!std::is_void_v<T>, "vtu: include <arenite/observe/vtu.hpp>");
  return [](const auto&) {};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
