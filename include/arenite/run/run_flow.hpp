// Run flow: what an observer may return, to end a run before its time.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Whatever else an observer returns is ignored.
enum class RunFlow { go_on, stop };

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
