// What the commands share in reading their options: numbers, words and flags as the tables give them, the
// help that lists them, and one sentence for whatever is wrong.
#pragma once

#include <algorithm>
#include <charconv>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
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

/// The options of one command: a visitor of its table adds them, `read` gives them the words that a user
/// types. An option that is given twice has its last value.
class OptionReader {
 public:
  /// `command`: as it is typed; `purpose`: the first line of its help.
  OptionReader(std::string command, std::string purpose)
      : command_{std::move(command)}, purpose_{std::move(purpose)} {}

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
    add(name, "", help, [&to](const std::string&) { to = true; });
  }

  /// One word without an option before it.
  void operand(const std::string& name, std::string& to) {
    operand_ = name;
    to_operand_ = &to;
  }

  /// Puts the values where they belong. Returns whether there were options: false if `--help` or `--version`
  /// was asked for and written to `answer`; `footer` ends the help. Throws `error` of one sentence for words
  /// that are none.
  bool read(const std::vector<std::string>& words, std::string_view footer, std::ostream& answer) {
    std::vector<std::string> others;
    bool help = false, version = false;
    for (auto word = words.begin(); word != words.end(); ++word) {
      const std::size_t sign = word->find('=');
      const std::string name = word->substr(0, sign);
      const auto option = std::ranges::find(options_, name, &Option::name);
      help |= *word == "--help" || *word == "-h";
      version |= *word == "--version";
      if (name.starts_with("--") && sign != std::string::npos && sign + 1 == word->size())
        throw error(shown(name) + " = : needs a value");
      if (option == options_.end()) {
        others.push_back(*word);
      } else if (option->metavar.empty()) {
        require(sign == std::string::npos, name, shown(word->substr(std::min(word->size(), sign + 1))),
                "takes no value");
        option->given = "";
      } else if (sign != std::string::npos) {
        option->given = word->substr(sign + 1);
      } else {
        if (word + 1 == words.end()) throw error(shown(name) + " = : needs a value");
        option->given = *++word;
      }
    }
    if (help) {
      show(answer);
      answer << '\n' << footer << '\n';
      return false;
    }
    if (version) {
      answer << "arenite-ffp " << library_version << '\n';
      return false;
    }
    for (const Option& option : options_)
      if (option.given) option.take(*option.given);
    if (to_operand_ != nullptr)
      if (const auto at = std::ranges::find_if(others, [](const auto& w) { return !w.starts_with("-"); });
          at != others.end()) {
        *to_operand_ = *at;
        others.erase(at);
      }
    for (const auto& word : others)
      throw error(joined_text(shown(word),
                              word.starts_with("-") ? ": no such option" : ": a word without an option",
                              "; see ", command_, " --help"));
    return true;
  }

 private:
  struct Option {
    std::string name, metavar;  ///< metavar: what stands for its value; empty: it takes none
    std::string group, help;
    std::function<void(const std::string&)> take;
    std::optional<std::string> given{};
  };

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
  void add(const std::string& name, const char* metavar, const std::string& help,
           std::function<void(const std::string&)> take) {
    options_.push_back({name, metavar, group_, help, std::move(take)});
  }

  /// Purpose, usage, and the options under the titles of their groups.
  void show(std::ostream& out) const {
    constexpr std::size_t column = 46;
    const auto line = [&](const std::string& words, const std::string& help) {
      out << words
          << (words.size() + 2 > column ? '\n' + std::string(column, ' ')
                                        : std::string(column - words.size(), ' '))
          << help << '\n';
    };
    out << purpose_ << "\nUsage: " << command_ << " [OPTIONS]" << (operand_.empty() ? "" : " ") << operand_
        << "\n\nOptions:\n";
    line("  -h, --help", "Print this help message and exit");
    line("  --version", "Print the version and exit");
    std::string group;
    for (const Option& option : options_) {
      if (option.group != group) out << '\n' << option.group << ":\n";
      group = option.group;
      line("  " + option.name + (option.metavar.empty() ? "" : " ") + option.metavar, option.help);
    }
  }

  std::string command_, purpose_, group_, operand_;
  std::vector<Option> options_;
  std::string* to_operand_ = nullptr;
};

}  // namespace detail

}  // namespace arenite::ffp
