// The words of `arenite-ffp drop ..`.
#pragma once

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "../options/option_table.hpp"
#include "input_file.hpp"
#include "option_reader.hpp"

namespace arenite::ffp {

namespace detail {

/// Takes `--input FILE` out of the words and puts the words of the file before them. Throws
/// `error` if it is given twice, without its file, or with one that cannot be used.
inline void take_input(std::vector<std::string>& words) {
  const auto is_input = [](const std::string& w) { return w == "--input" || w.starts_with("--input="); };
  const auto at = std::ranges::find_if(words, is_input);
  if (at == words.end()) return;
  const bool apart = *at == "--input";
  if (apart && at + 1 == words.end()) throw error("--input = : needs a value");
  const std::string path = apart ? *(at + 1) : at->substr(8);
  require(!path.empty() && !path.starts_with("--"), "--input", shown(path), "must be a name of a file");
  const auto behind = words.erase(at, at + (apart ? 2 : 1));
  require(std::none_of(behind, words.end(), is_input), "--input", shown(path), "is given twice");
  const auto of_file = words_of_input(path);
  words.insert(words.begin(), of_file.begin(), of_file.end());
}

}  // namespace detail

/// Options of a drop, checked; nothing if help or version was asked for and written to `answer`. Throws
/// `error` of one sentence for anything else.
inline std::optional<DropOptions> read_drop(std::vector<std::string> words, std::ostream& answer) {
  DropOptions options;
  CLI::App app{"Runs one drop; without options the paper's case", "arenite-ffp drop"};
  detail::OptionAdder adder{app};
  visit_options(options, adder);
  app.add_option(
         "--input",
         "Inputs as JSON, by the keys of \"inputs\" in summary.json, or such a file; options given here win")
      ->type_name("FILE.json")
      ->group("Run");
  app.footer(
      "Writes history.csv, summary.json, reduced.csv, reduced.json and, for ParaView, fields.pvd with "
      "fields_*.vtu\n"
      "into DIR. summary.json says \"status\": \"running\" from the start, and at the end \"done\", "
      "\"failed\",\n"
      "\"interrupted\" or \"disk-full\". A folder that another drop is writing to is refused.\n"
      "SIGINT (Ctrl-C) or SIGTERM ends the run after the step, with all files complete; a second one at "
      "once.\n"
      "Exit code: 0 done; 1 the run failed physically, or its files could not be written; 2 an option, a "
      "mesh\n"
      "or the folder cannot be used; 130 and 143 interrupted by SIGINT and SIGTERM.");
  if (std::ranges::find(words, "--help") == words.end()) detail::take_input(words);
  if (!detail::parse_words(app, adder, words, answer)) return std::nullopt;
  read_device(options);
  check(options);
  return options;
}

}  // namespace arenite::ffp
