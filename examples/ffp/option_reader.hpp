// What the commands share in reading their options with CLI11: numbers, words and flags as the tables give
// them, and one sentence for whatever is wrong.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/version.hpp>

#include "options.hpp"
#include "range.hpp"
#include "words.hpp"

namespace arenite::ffp {

namespace detail {

/// The whole text as a number; throws `error("--option = text: must be a number")`.
template <class Number>
Number parse_number(const std::string& option, const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [at, code] = std::from_chars(text.data(), end, value);
  const char* rule = std::is_integral_v<Number> ? "must be a whole number" : "must be a number";
  if (code == std::errc::result_out_of_range) rule = "must be a number of ordinary size";
  require(code == std::errc{} && at == end, option, shown(text), rule);
  return value;
}

/// What puts the number that a word stands for where it belongs.
template <class Number, class Place>
auto parse_into(const std::string& name, Place& to) {
  return [name, &to](const std::string& word) { to = parse_number<Number>(name, word); };
}

/// Adds the options of a table to a command.
class OptionAdder {
 public:
  explicit OptionAdder(CLI::App& app) : app_{app} {}

  void group(const char* title) { group_ = title; }

  template <class Number>
  void number(const std::string& name, Number& to, const char* metavar, const Range& range,
              const std::string& help) {
    add(name, metavar, joined_text(help, ", in ", range.text(), " (default ", to, ")"),
        parse_into<Number>(name, to));
  }
  template <class Number>
  void number(const std::string& name, std::optional<Number>& to, const char* metavar, const Range& range,
              const std::string& help) {
    add(name, metavar, joined_text(help, ", in ", range.text()), parse_into<Number>(name, to));
  }
  void counts(const std::string& name, std::optional<int>& to, const std::string& help) {
    add(name, "N", help, parse_into<int>(name, to));
  }
  void text(const std::string& name, std::string& to, const char* metavar, const std::string& help) {
    add(name, metavar, help + (to.empty() ? "" : " (default " + to + ")"),
        [name, &to](const std::string& word) {
          require(!word.starts_with("--"), name, shown(word), "must be a name, not the next option");
          to = word;
        });
  }
  template <class Words, class Value>
  void choice(const std::string& name, const Words& words, Value& to, const std::string& help) {
    choose(name, words, to, help + " (default " + word_of(words, to) + ")");
  }
  template <class Words, class Value>
  void choice(const std::string& name, const Words& words, std::optional<Value>& to,
              const std::string& help) {
    choose(name, words, to, help);
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
  template <class Words, class Place>
  void choose(const std::string& name, const Words& words, Place& to, const std::string& help) {
    std::string all, rule;
    for (const auto& [word, meaning] : words) {
      all += (all.empty() ? "" : "|") + std::string{word};
      rule += (rule.empty() ? "must be " : " or ") + std::string{word};
    }
    add(name, all.c_str(), help, [name, words, rule, &to](const std::string& given) {
      for (const auto& [word, meaning] : words)
        if (word == given) {
          to = meaning;
          return;
        }
      throw error(joined_text(name, " = ", shown(given), ": ", rule));
    });
  }
  template <class Take>
  void add(const std::string& name, const char* metavar, const std::string& help, Take take) {
    app_.add_option_function<std::string>(name, take, help)
        ->type_name(metavar)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
        ->group(group_);
  }

  CLI::App& app_;
  std::string group_;
  std::vector<std::string> flags_;
};

/// Gives the words of a command to `app`, whose options are added. Returns whether they were options: false
/// if
/// `--help` or `--version` was asked for and written to `answer`. Throws `error` of one sentence for words
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
    throw error(joined_text("command line: ", shown(e.what())));
  }
  for (const auto& word : app.remaining(true))
    throw error(joined_text(shown(word),
                            word.starts_with("-") ? ": no such option" : ": a word without an option",
                            "; see ", app.get_name(), " --help"));
  return true;
}

}  // namespace detail

}  // namespace arenite::ffp
