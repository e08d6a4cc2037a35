// The command line `arenite-ffp COMMAND ..`: which command reads the words, and the help that lists them.
// Whatever is wrong becomes one `error` of one sentence that names option, value and rule.
#pragma once

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <arenite/version.hpp>

#include "command.hpp"
#include "read_drop.hpp"
#include "read_paper.hpp"
#include "read_push.hpp"
#include "read_reduce.hpp"

namespace arenite::ffp {

/// The command of `arenite-ffp <words>`, its options checked; nothing if `--help` or `--version` was asked
/// for and written to `answer`. Throws `error` of one sentence for anything else; the caller prints
/// "arenite-ffp: " and the sentence and exits with 2.
inline std::optional<Command> read_command_line(const std::vector<std::string>& words, std::ostream& answer) {
  const std::vector<std::string> options(words.begin() + (words.empty() ? 0 : 1), words.end());
  const std::string command = words.empty() ? "" : words.front();
  if (command == "drop") return read_drop(options, answer);
  if (command == "push") return read_push(options, answer);
  if (command == "reduce") return read_reduce(options, answer);
  if (command == "paper") return read_paper(options, answer);
  if (command == "--help" || command == "-h") {
    answer << "Drops a penetrometer into dry sand, or pushes one into the ground, by the material point "
              "method.\n"
              "Usage: arenite-ffp COMMAND [OPTIONS]\n\n"
              "  drop          Run one drop; without options the paper's case\n"
              "  push          Push a penetrometer into clay or sand: resistance by depth\n"
              "  reduce FILE   Read bearing resistance, density and strength off a record of deceleration\n"
              "  paper         Run every case of the paper, and hold the numbers against it\n"
              "  --version     Print the version and exit\n\n"
              "arenite-ffp COMMAND --help lists the options of a command.\n";
    return std::nullopt;
  }
  if (command == "--version") {
    answer << "arenite-ffp " << library_version << '\n';
    return std::nullopt;
  }
  refuse_command(command);
}

}  // namespace arenite::ffp
