// Map: a `std::map` whose instantiations have different names for different instruction sets, so that the
// linker never mixes them.
#pragma once

#include <functional>
#include <map>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// As `<` has it; texts are found without a copy.
struct Order : std::less<> {};

template <class Key, class Value>
using Map = std::map<Key, Value, Order>;

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
