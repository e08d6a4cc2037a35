// Errors: what a user's mistake and a failed run say. A programmer's mistake is an assert instead.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include <arenite/core/instruction_set.hpp>

namespace arenite {  // one for all instruction sets: who catches knows them

/// A value that breaks a rule. The message names the value and the rule.
class error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A run that failed physically (NaN, inverted mesh, used-up compressing zone). Names time, place and cause.
class run_error : public error {
 public:
  using error::error;
};

}  // namespace arenite

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The parts one behind the other as text, numbers with ten digits: what messages are made of.
template <class... Parts>
std::string joined_text(const Parts&... parts) {
  std::ostringstream text;
  text.precision(10);
  (text << ... << parts);
  return text.str();
}

/// "(1, 2, 3)" of a vector's components.
template <class Vector>
std::string vector_text(const Vector& v) {
  std::string text = "(";
  for (int k = 0; k < static_cast<int>(v.size()); ++k) text += joined_text(k > 0 ? ", " : "", v[k]);
  text += ")";
  return text;
}

/// Throws `error("name = value: rule")` unless `holds`. Write the condition so that NaN fails it.
template <class Value>
void require(bool holds, std::string_view name, const Value& value, std::string_view rule) {
  if (!holds) throw error(joined_text(name, " = ", value, ": ", rule));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
