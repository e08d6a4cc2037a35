// The words of `arenite-ffp paper ..`.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "../options/paper_options.hpp"
#include "option_reader.hpp"

namespace arenite::ffp {

/// Options of the paper's cases, checked; nothing if help or version was asked for and written to `answer`.
/// Throws `error` of one sentence for anything else.
inline std::optional<PaperOptions> read_paper(const std::vector<std::string>& words, std::ostream& answer) {
  PaperOptions options;
  CLI::App app{"Runs every case of the paper, and holds the numbers against it", "arenite-ffp paper"};
  detail::OptionAdder adder{app};
  visit_paper_options(options, adder);
  app.footer(
      "Each case is a drop in a folder of its own in DIR; one that is finished is left as it is, one that "
      "was\n"
      "interrupted goes on. All cases run with Mohr-Coulomb, as the paper's, and those of the rigid "
      "half-section\n"
      "with --law too. Writes paper.json and figures 3 to 6 as PNG and SVG into DIR and prints a table.\n"
      "SIGINT (Ctrl-C) or SIGTERM ends the case after its step; the same command goes on from there.\n"
      "Exit code: 0 done; 1 a case failed, or files could not be written; 2 an option or a folder cannot be "
      "used;\n"
      "130 and 143 interrupted by SIGINT and SIGTERM.");
  if (!detail::parse_words(app, adder, words, answer)) return std::nullopt;
  check(options);
  return options;
}

}  // namespace arenite::ffp
