// How all commands read typed words with CLI11, with one sentence for whatever is wrong.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/version.hpp>

#include "../options/option_visitor.hpp"
#include "../text/words.hpp"

namespace arenite::ffp {

namespace detail {

/// Adds the options of a table to a command.
class OptionAdder : public OptionVisitor<OptionAdder> {
 public:
  explicit OptionAdder(CLI::App& app) : app_{app} {}

  template <class Take>
  void add(const std::string& name, const char* metavar, const std::string& help, Take take) {
    app_.add_option_function<std::string>(name, take, help)
        ->type_name(metavar)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
        ->group(group_);
  }
  void flag(const std::string& name, bool& to, const std::string& help) {
    app_.add_flag(name, to, help)->group(group_);
    flags_.push_back(name);
  }

  /// One word without an option before it.
  void operand(const std::string& name, std::string& to, const std::string& help) {
    app_.add_option(name, to, help)->type_name("")->group("");
  }

  /// Names of the options that take no value.
  const std::vector<std::string>& flags() const { return flags_; }

 private:
  CLI::App& app_;
  std::vector<std::string> flags_;
};

/// Gives the words of a command to `app`, whose options are added. Returns whether they were options:
/// false if `--help` or `--version` was asked for and written to `answer`. Throws `error` of one sentence for words
/// that are none.
inline bool parse_words(CLI::App& app, const OptionAdder& adder, const std::vector<std::string>& words,
                        std::ostream& answer) {
  app.set_version_flag("--version", std::string(library_version), "Print the version and exit");
  app.get_formatter()->column_width(46);
  app.allow_extras();
  for (const auto& word : words) {  // what CLI11 would take in silence
    for (const std::string& flag : adder.flags())
      require(!word.starts_with(flag + "="), flag, shown(word.substr(std::min(word.size(), flag.size() + 1))),
              "takes no value");
    if (word.starts_with("--") && word.ends_with("="))
      throw error(shown(word.substr(0, word.size() - 1)) + " = : needs a value");
  }
  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    app.parse(reversed);
  } catch (const CLI::CallForHelp&) {
    answer << app.help();
    return false;
  } catch (const CLI::CallForVersion&) {
    answer << "arenite-ffp " << library_version << '\n';
    return false;
  } catch (const CLI::ArgumentMismatch&) {  // only the last word can be an option without its value
    throw error(shown(words.back()) + " = : needs a value");
  } catch (const CLI::ParseError& e) {
    throw error(joined_text({"command line: ", shown(e.what())}));
  }
  for (const auto& word : app.remaining(true))
    throw error(
        joined_text({shown(word), word.starts_with("-") ? ": no such option" : ": a word without an option",
                     "; see ", app.get_name(), " --help"}));
  return true;
}

}  // namespace detail

}  // namespace arenite::ffp
