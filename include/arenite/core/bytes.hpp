// Bytes: values in messages as they lie in memory.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstring>
#include <string>
#include <string_view>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <class V>
void append_bytes(std::string& to, const V& value) {
  to.append(reinterpret_cast<const char*>(&value), sizeof(V));
}
/// Takes the first value off.
template <class V>
V read_bytes(std::string_view& from) {
  V value;
  std::memcpy(&value, from.data(), sizeof(V));
  from.remove_prefix(sizeof(V));
  return value;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
