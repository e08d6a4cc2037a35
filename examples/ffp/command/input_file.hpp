// Inputs of a drop from a JSON file: by hand, or the summary.json of a run. They become words of the command
// line, so that limits and messages are those of the options; words that the user types come later and win.
#pragma once

#include <string>
#include <vector>

#include "../drop/history.hpp"

namespace arenite::ffp {

/// The inputs in a file as words of the command line. Takes an object of inputs, or one that has them as
/// "inputs". Throws `error` that names `--input`, the file and the key.
std::vector<std::string> words_of_input(const std::string& path);

}  // namespace arenite::ffp
