// A loop without its types: what the thread pool runs.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

struct Loop {
  void (*items)(const void* body, std::size_t begin, std::size_t end);  ///< runs the items [begin, end)
  const void* body;
  /// The first item of part `part` of `parts`.
  std::size_t (*cut)(const void* cuts, std::size_t part, std::size_t parts);
  const void* cuts;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
