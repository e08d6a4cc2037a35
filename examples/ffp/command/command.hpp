// The commands of the program, however they are given.
#pragma once

#include <string>
#include <variant>

#include <arenite/core/error.hpp>

#include "../options/option_table.hpp"
#include "../options/paper_options.hpp"
#include "../options/push_options.hpp"
#include "../options/reduce_options.hpp"
#include "../text/words.hpp"

namespace arenite::ffp {

using Command = std::variant<DropOptions, PushOptions, ReduceOptions, PaperOptions>;

/// Throws `error`: there is no command of this name.
[[noreturn]] inline void refuse_command(const std::string& command) {
  throw error(joined_text({"command: must be drop, push, reduce or paper, not ",
                           command.empty() ? "nothing" : shown(command), "; see arenite-ffp --help"}));
}

}  // namespace arenite::ffp
