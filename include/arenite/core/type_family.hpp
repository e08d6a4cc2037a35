// A list of types that belong together: the policies of a law, the transfers.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <type_traits>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Types of a family, the default first.
template <class... Type>
struct TypeFamily {
  template <template <class...> class Template>
  using in = Template<Type...>;

  /// Calls `call(std::type_identity<Type>{})` for each.
  template <class Call>
  static constexpr void each(const Call& call) {
    (call(std::type_identity<Type>{}), ...);
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
