// The command line `arenite-ffp drop ...`, read with CLI11. Whatever is wrong with it becomes one `error` of
// one sentence that names option, value and rule.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <optional>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

#include <arenite/version.hpp>

#include "input_file.hpp"
#include "option_table.hpp"

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

/// Adds the options of the table to a CLI11 application.
class DropOptionAdder {
 public:
  explicit DropOptionAdder(CLI::App& app) : app_{app} {}

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
    std::string all, rule;
    for (const auto& [word, meaning] : words) {
      all += (all.empty() ? "" : "|") + std::string{word};
      rule += (rule.empty() ? "must be " : " or ") + std::string{word};
    }
    add(name, all.c_str(), help + " (default " + word_of(words, to) + ")",
        [name, words, rule, &to](const std::string& given) {
          for (const auto& [word, meaning] : words)
            if (word == given) {
              to = meaning;
              return;
            }
          throw error(joined_text(name, " = ", shown(given), ": ", rule));
        });
  }
  void flag(const std::string& name, bool& to, const std::string& help) {
    app_.add_flag(name, to, help)->group(group_);
    flags_.push_back(name);
  }

  /// Names of the options that take no value.
  const std::vector<std::string>& flags() const { return flags_; }

 private:
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

/// Takes `--input FILE` out of the words and puts the words that the file stands for behind "drop". Throws
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
  const auto command = std::ranges::find(words, "drop");
  if (command == words.end()) return;
  const auto of_file = words_of_input(path);
  words.insert(command + 1, of_file.begin(), of_file.end());
}

}  // namespace detail

/// Options of `arenite-ffp <words>`, checked; nothing if `--help` or `--version` was asked for and written to
/// `answer`. Throws `error` of one sentence for anything else; the caller prints "arenite-ffp: " and the
/// sentence and exits with 2.
inline std::optional<DropOptions> read_command_line(std::vector<std::string> words, std::ostream& answer) {
  DropOptions options;
  CLI::App app{"Drops a free-fall penetrometer into dry sand, by the material point method.", "arenite-ffp"};
  CLI::App& drop = *app.add_subcommand("drop", "Run one drop; without options the paper's case");
  for (CLI::App* each : {&app, &drop})
    each->set_version_flag("--version", std::string(library_version), "Print the version and exit");
  drop.get_formatter()->column_width(46);
  detail::DropOptionAdder adder{drop};
  visit_options(options, adder);
  drop.add_option(
          "--input",
          "Inputs as JSON, by the keys of \"inputs\" in summary.json, or such a file; options given here win")
      ->type_name("FILE.json")
      ->group("Run");
  app.allow_extras();
  drop.allow_extras();
  drop.footer(
      "Writes history.csv, summary.json and, for ParaView, fields.pvd with fields_*.vtu into DIR.\n"
      "summary.json says \"status\": \"running\" from the start, and at the end \"done\", \"failed\",\n"
      "\"interrupted\" or \"disk-full\". A folder that another drop is writing to is refused.\n"
      "SIGINT (Ctrl-C) or SIGTERM ends the run after the step, with all files complete; a second one at "
      "once.\n"
      "Exit code: 0 done; 1 the run failed physically, or its files could not be written; 2 an option, a "
      "mesh\n"
      "or the folder cannot be used; 130 and 143 interrupted by SIGINT and SIGTERM.");
  if (std::ranges::find(words, "--help") == words.end()) detail::take_input(words);
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
    answer << (drop.parsed() ? drop.help("arenite-ffp") : app.help());
    return std::nullopt;
  } catch (const CLI::CallForVersion&) {
    answer << "arenite-ffp " << library_version << '\n';
    return std::nullopt;
  } catch (const CLI::ArgumentMismatch&) {  // only the last word can be an option without its value
    throw error(shown(words.back()) + " = : needs a value");
  } catch (const CLI::ParseError& e) {
    throw error(joined_text("command line: ", shown(e.what())));
  }
  for (const auto& word : app.remaining(true))
    throw error(joined_text(shown(word),
                            word.starts_with("-") ? ": no such option" : ": a word without an option",
                            "; see arenite-ffp drop --help"));
  if (!drop.parsed()) throw error("command: must be drop, as in arenite-ffp drop --help");
  check(options);
  return options;
}

}  // namespace arenite::ffp
