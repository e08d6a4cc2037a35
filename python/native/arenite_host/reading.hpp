// Reading: where in a host's value a reader is, and what it needs of the scene to be made.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite_host/batched_function.hpp>
#include <arenite_host/value.hpp>

// How a scene's recipes are read is compiled once for many scenes, if a program wants it: its units define
// ARENITE_HOST_ELSEWHERE, and see only declarations; one of them, of readers.hpp, defines ARENITE_HOST_HERE.
#ifdef ARENITE_HOST_HERE
#define ARENITE_READER
#else
#define ARENITE_READER inline
#endif

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Context of a reader: the name of the place for messages, and data of the scene.
struct ReadContext {
  std::string name{};
  int dimension = 3;                 ///< of the scene
  PlaceFunctions* places = nullptr;  ///< where functions of place are collected; none: they are not
  const std::vector<std::array<double, 3>>* nodes = nullptr;  ///< positions of the mesh's nodes, m; or none
  PlaceMemory* memory = nullptr;                              ///< of a scene that is cut into tiles

  ReadContext operator/(std::string_view member) const { return renamed(joined_text({name, ".", member})); }
  ReadContext operator[](std::size_t k) const { return renamed(joined_text({name, "[", k, "]"})); }
  ReadContext renamed(std::string other) const {
    ReadContext at = *this;
    at.name = std::move(other);
    return at;
  }
  /// A function of place to ask in the place of one that the host gave.
  HostFunction of_places(const HostFunction& given) const {
    return memory ? memory->ask(given, name) : given;
  }
  /// Throws the refusal of a value there.
  [[noreturn]] void refuse(const Value& value, std::string_view rule) const {
    throw error(joined_text({name, " = ", value.text(), ": ", rule}));
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
