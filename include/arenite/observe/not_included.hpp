// What arenite.hpp leaves to headers of their own because it writes files: its name alone, with the sentence
// that says where it is.
#pragma once

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
