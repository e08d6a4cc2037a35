// Words of a command line as options, or as what is said against them.
#pragma once

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "../../examples/ffp/command/command_line.hpp"
#include "catch.hpp"

namespace arenite::ffp {

inline DropOptions read(std::vector<std::string> words) {
  std::ostringstream help;
  auto options = read_drop(std::move(words), help);
  REQUIRE(options.has_value());
  REQUIRE(help.str().empty());
  return *options;
}

inline std::string refusal_of(std::vector<std::string> words) {
  std::ostringstream help;
  try {
    read_command_line(words, help);
  } catch (const error& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace arenite::ffp
