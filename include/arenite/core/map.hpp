// Map: a `std::map` whose instantiations have different names for different instruction sets, so that the
// linker never mixes them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <functional>
#include <map>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// As `<` has it; texts are found without a copy.
struct MapOrder : std::less<> {};

template <class Key, class Value>
using Map = std::map<Key, Value, MapOrder>;

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
