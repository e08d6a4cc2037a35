// A command as values, for programs that call this one: `arenite-ffp values` reads a JSON object from
// standard input, {"command": "drop", "options": {"delta": 40, "error_bar": true}}; "reduce" has a "file"
// too. Checks and sentences are those of the options when they are typed.
#pragma once

#include <istream>
#include <optional>
#include <ostream>

#include "../text/json_file.hpp"
#include "command.hpp"

namespace arenite::ffp {

/// The command in a JSON object, its options checked; nothing for {"command": "options", "of": "drop"}, which
/// writes the options of a command to `answer`. Throws `error` of one sentence for anything else.
std::optional<Command> command_of_values(const Json& all, std::ostream& answer);

/// The same, from a stream to its end.
std::optional<Command> read_values(std::istream& in, std::ostream& answer);

}  // namespace arenite::ffp
