// The words of `arenite-ffp reduce ..`.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "../options/reduce_options.hpp"
#include "option_reader.hpp"

namespace arenite::ffp {

/// Options of a reduction, checked; nothing if help or version was asked for and written to `answer`. Throws
/// `error` of one sentence for anything else.
inline std::optional<ReduceOptions> read_reduce(const std::vector<std::string>& words, std::ostream& answer) {
  ReduceOptions options;
  CLI::App app{"Reads bearing resistance, density and strength off the deceleration of a drop",
               "arenite-ffp reduce"};
  detail::OptionAdder adder{app};
  adder.operand("FILE", options.file, "");
  visit_reduce_options(options, adder);
  app.footer(
      "FILE is a table with a time and a deceleration (time_s, time_ms; deceleration_g, acceleration_m_s2 "
      "and the\n"
      "like; positive when it slows the penetrometer), a record of the BlueDrop (.bin), or the folder of a "
      "drop, whose\n"
      "inputs then stand for the options that are not given.\n"
      "Writes reduced.csv, reduced.json, reduced.png and reduced.svg into DIR and prints a table.\n"
      "Exit code: 0 done; 1 the files could not be written; 2 an option or FILE cannot be used.");
  if (!detail::parse_words(app, adder, words, answer)) return std::nullopt;
  read_device(options);
  check(options);
  return options;
}

}  // namespace arenite::ffp
