// Map: `std::map` with an order of our own. What the compiler makes of it has a name of its own in units for
// other instruction sets, where `std::map<std::string, int>` would be one for all.
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
