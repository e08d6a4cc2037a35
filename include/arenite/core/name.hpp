// Name: what a body of a scene is called, known to the compiler.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <string>
#include <string_view>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A template argument that names a body: a word, or its number among those of its kind; empty: no name.
template <std::size_t Size>
struct Name {
  char text[Size]{};
  int number = -1;  ///< none

  constexpr Name(const char (&word)[Size]) {
    for (std::size_t k = 0; k < Size; ++k) text[k] = word[k];
  }
  constexpr Name(std::size_t n) requires(Size == 1) : number{static_cast<int>(n)} {}

  constexpr std::string_view word() const { return {text, Size - 1}; }
};
template <std::size_t Size>
Name(const char (&)[Size]) -> Name<Size>;
Name(std::size_t)->Name<1>;

/// Name or number of a body, known when the program runs.
struct BodyName {
  std::string word{};
  int number = -1;  ///< none

  BodyName(std::size_t n) : number{static_cast<int>(n)} {}
  BodyName(const char* w) : word{w} {}
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
