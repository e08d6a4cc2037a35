// The interface of a table of options to its readers, whatever they read: each option's name, a placeholder
// for its value, its help, and a function that sets the value from a text, or throws one sentence.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#include <arenite/core/error.hpp>

#include "../text/range.hpp"
#include "../text/words.hpp"
#include "options.hpp"

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

/// A function that parses a word as a number and stores it in `to`.
template <class Number, class Place>
auto parse_into(const std::string& name, Place& to) {
  return [name, &to](const std::string& word) { to = parse_number<Number>(name, word); };
}

/// Visits a table for `Reader`, which has add(name, metavar, help, take), where take(text) sets the value,
/// and flag(name, to, help).
template <class Reader>
class OptionVisitor {
 public:
  void group(const char* title) { group_ = title; }

  template <class Number>
  void number(const std::string& name, Number& to, const char* metavar, const Range& range,
              const std::string& help) {
    add(name, metavar, joined_text({help, ", in ", range.text(), " (default ", to, ")"}),
        parse_into<Number>(name, to));
  }
  template <class Number>
  void number(const std::string& name, std::optional<Number>& to, const char* metavar, const Range& range,
              const std::string& help) {
    add(name, metavar, joined_text({help, ", in ", range.text()}), parse_into<Number>(name, to));
  }
  void counts(const std::string& name, std::optional<int>& to, const std::string& help) {
    add(name, "N", help, parse_into<int>(name, to));
  }
  void text(const std::string& name, std::string& to, const char* metavar, const std::string& help) {
    add(name, metavar, help + (to.empty() ? "" : " (default " + to + ")"),
        [name, &to](const std::string& word) {
          require(!word.empty(), name, word, "needs a value");
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

 protected:
  std::string group_;  ///< title of the options that come

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
      throw error(joined_text({name, " = ", shown(given), ": ", rule}));
    });
  }
  template <class Take>
  void add(const std::string& name, const char* metavar, const std::string& help, Take take) {
    static_cast<Reader*>(this)->add(name, metavar, help, take);
  }
};

}  // namespace detail

}  // namespace arenite::ffp
