// The words of `arenite-ffp push ..`.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "../options/push_options.hpp"
#include "option_reader.hpp"

namespace arenite::ffp {

/// Options of a push, checked; nothing if help or version was asked for and written to `answer`. Throws
/// `error` of one sentence for anything else.
inline std::optional<PushOptions> read_push(const std::vector<std::string>& words, std::ostream& answer) {
  PushOptions options;
  CLI::App app{"Pushes a penetrometer into clay or sand; without options a standard cone into clay",
               "arenite-ffp push"};
  detail::OptionAdder adder{app};
  visit_push_options(options, adder);
  app.footer(
      "The penetrometer starts in undisturbed ground, with its tip at --start-depth. Writes history.csv "
      "(means by "
      "way of q_c, f_s and "
      "friction\n"
      "ratio), summary.json, push.png and, for ParaView, fields.pvd with fields_*.vtu into DIR.\n"
      "SIGINT (Ctrl-C) or SIGTERM ends the run after the step, with all files complete.\n"
      "Exit code: 0 done; 1 the run failed physically, or its files could not be written; 2 an option or the "
      "folder cannot\n"
      "be used; 130 and 143 interrupted by SIGINT and SIGTERM.");
  if (!detail::parse_words(app, adder, words, answer)) return std::nullopt;
  read_device(options);
  check(options);
  return options;
}

}  // namespace arenite::ffp
