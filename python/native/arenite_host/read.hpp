// Reading: a host's value as a value of the library, by the names of its members; what does not fit is an
// error that names the place, the value and the rule.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <arenite/core/checked.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/map.hpp>
#include <arenite/core/type_words.hpp>
#include <arenite_host/members.hpp>
#include <arenite_host/reading.hpp>
#include <arenite_host/value.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// How a T is read: `static T read(const Value&, const Reading& at)`. Aggregates are read member by member,
/// classes with a struct `Parameters` through that; others need a specialisation.
template <class T>
struct ValueReader;

template <class T>
T read(const Value& value, const ReadContext& at) {
  return ValueReader<T>::read(value, at);
}

namespace detail {

/// Name of a type in messages: `MohrCoulombParameters` is MohrCoulomb.
template <class T>
std::string display_name() {
  std::string word = type_words<T>();
  word = word.substr(0, word.find('<'));
  constexpr std::string_view end = "Parameters";
  if (word.size() > end.size() && word.ends_with(end)) word.resize(word.size() - end.size());
  return word;
}

/// The numbers of a list or an array of one dimension.
std::vector<double> numbers(const Value& value, const ReadContext& at);

/// Whether a value is numbers, and not a function.
inline bool is_numbers(const Value& value) {
  return value.array() != nullptr || value.get<Value::List>() != nullptr;
}

/// Refuses a name that is none of those known.
void refuse_unknown(const Value::Dict& given, std::span<const std::string_view> known, const ReadContext& at);

/// The named members of a value; none is read as an empty dict.
const Value::Dict& dict(const Value& value, const ReadContext& at);

/// Member K of an aggregate: what was given, or as the aggregate has it.
template <class T, std::size_t K>
member_type<T, K> read_member(const Value::Dict& given, const ReadContext& at) {
  const std::string key(member_names<T>[K]);
  const auto found = given.find(key);
  if (found != given.end()) return read<member_type<T, K>>(found->second, at / key);
  if constexpr (requires { T{}; })
    return member<K>(T{});
  else
    throw error(joined_text({(at / key).name, " = nothing: must be given"}));
}

template <class T>
concept has_parameters = requires {
  typename T::Parameters;
}
&&!std::same_as<T, typename T::Parameters> && std::is_constructible_v<T, const typename T::Parameters&>;

}  // namespace detail

template <class T>
struct ValueReader {
  static T read(const Value& value, const ReadContext& at) {
    if constexpr (detail::has_parameters<T>) {
      return T(arenite::read<typename T::Parameters>(value, at.renamed(detail::display_name<T>())));
    } else {
      static_assert(std::is_aggregate_v<T>,
                    "host: a law or part made of values by name must be an aggregate, or hold a struct "
                    "Parameters { double density = 0, ..; } and a constructor that takes one "
                    "(examples/own_law.hpp); C++ may specialise ValueReader<T>");
      const Value::Dict& given = detail::dict(value, at);
      detail::refuse_unknown(given, member_names<T>, at);
      return with_members(given, at, std::make_index_sequence<member_count<T>>{});
    }
  }

 private:
  template <std::size_t... K>
  static T with_members([[maybe_unused]] const Value::Dict& given, [[maybe_unused]] const ReadContext& at,
                        std::index_sequence<K...>) {
    return T{detail::read_member<T, K>(given, at)...};
  }
};

template <>
struct ValueReader<Value> {
  static Value read(const Value& value, const std::string&) { return value; }
};
template <>
struct ValueReader<bool> {
  static bool read(const Value&, const ReadContext&);
};
template <std::floating_point T>
struct ValueReader<T> {
  static T read(const Value& value, const ReadContext& at) {
    const double* x = value.get<double>();
    if (x == nullptr) at.refuse(value, "must be a number");
    return static_cast<T>(*x);
  }
};
template <std::integral T>
struct ValueReader<T> {
  static T read(const Value& value, const ReadContext& at) {
    const double x = arenite::read<double>(value, at);
    const bool fits = x == std::floor(x) && x >= static_cast<double>(std::numeric_limits<T>::min()) &&
                      x <= std::min(static_cast<double>(std::numeric_limits<T>::max()), 9007199254740992.0);
    if (!fits) at.refuse(value, "must be a whole number that fits");
    return static_cast<T>(x);
  }
};
template <class T>
requires std::is_enum_v<T>
struct ValueReader<T> {
  static T read(const Value& value, const ReadContext& at) {
    return static_cast<T>(arenite::read<int>(value, at));
  }
};
template <>
struct ValueReader<std::string> {
  static std::string read(const Value&, const ReadContext&);
};
template <class Rule>
struct ValueReader<Checked<Rule>> {
  static Checked<Rule> read(const Value& value, const ReadContext& at) {
    return arenite::read<double>(value, at);
  }
};
/// Three numbers may be fewer: as many as the scene has dimensions.
template <std::size_t N>
struct ValueReader<std::array<double, N>> {
  static std::array<double, N> read(const Value& value, const ReadContext& at) {
    const auto given = detail::numbers(value, at);
    const bool fits = given.size() == N || (N == 3 && given.size() < N && !given.empty());
    if (!fits) at.refuse(value, joined_text({"must be ", N == 3 ? "up to " : "", N, " numbers"}));
    std::array<double, N> a{};
    std::ranges::copy(given, a.begin());
    return a;
  }
};
template <class T, std::size_t N>
requires(!std::is_same_v<T, double>) struct ValueReader<std::array<T, N>> {
  static std::array<T, N> read(const Value& value, const ReadContext& at) {
    const auto* list = value.get<Value::List>();
    if (list == nullptr || list->size() != N) at.refuse(value, joined_text({"must be a list of ", N}));
    std::array<T, N> all{};
    for (std::size_t k = 0; k < N; ++k) all[k] = arenite::read<T>((*list)[k], at[k]);
    return all;
  }
};
template <>
struct ValueReader<std::vector<double>> {
  static std::vector<double> read(const Value&, const ReadContext&);
};
template <class T>
struct ValueReader<std::vector<T>> {
  static std::vector<T> read(const Value& value, const ReadContext& at) {
    const auto* list = value.get<Value::List>();
    if (list == nullptr) at.refuse(value, "must be a list");
    std::vector<T> all;
    for (const Value& v : *list) all.push_back(arenite::read<T>(v, at[all.size()]));
    return all;
  }
};
template <class T>
struct ValueReader<std::optional<T>> {
  static std::optional<T> read(const Value& value, const ReadContext& at) {
    if (value.is_none()) return {};
    return arenite::read<T>(value, at);
  }
};
template <class T>
struct ValueReader<Map<std::string, T>> {
  static Map<std::string, T> read(const Value& value, const ReadContext& at) {
    Map<std::string, T> all;
    for (const auto& [key, v] : detail::dict(value, at)) all.emplace(key, arenite::read<T>(v, at / key));
    return all;
  }
};

#ifndef ARENITE_HOST_ELSEWHERE

namespace detail {

ARENITE_READER std::vector<double> numbers(const Value& value, const ReadContext& at) {
  if (const HostArray* a = value.array()) {
    if (a->shape.size() > 1) at.refuse(value, "must be numbers side by side");
    return a->numbers;
  }
  const auto* list = value.get<Value::List>();
  if (list == nullptr) at.refuse(value, "must be a list of numbers");
  std::vector<double> all;
  for (const Value& v : *list) {
    const double* x = v.get<double>();
    if (x == nullptr) at[all.size()].refuse(v, "must be a number");
    all.push_back(*x);
  }
  return all;
}

ARENITE_READER void refuse_unknown(const Value::Dict& given, std::span<const std::string_view> known,
                                   const ReadContext& at) {
  for (const auto& [key, value] : given) {
    if (std::ranges::find(known, key) != known.end()) continue;
    std::string all;
    for (const auto& k : known) all += (all.empty() ? "" : ", ") + std::string(k);
    (at / key).refuse(value,
                      all.empty() ? "is unknown: there is nothing to give" : "is unknown; there are: " + all);
  }
}

ARENITE_READER const Value::Dict& dict(const Value& value, const ReadContext& at) {
  static const Value::Dict none_given;
  if (value.is_none()) return none_given;
  const auto* given = value.get<Value::Dict>();
  if (given == nullptr) at.refuse(value, "must be names with values");
  return *given;
}

}  // namespace detail

ARENITE_READER bool ValueReader<bool>::read(const Value& value, const ReadContext& at) {
  const bool* b = value.get<bool>();
  if (b == nullptr) at.refuse(value, "must be true or false");
  return *b;
}
ARENITE_READER std::string ValueReader<std::string>::read(const Value& value, const ReadContext& at) {
  const auto* s = value.get<std::string>();
  if (s == nullptr) at.refuse(value, "must be a word");
  return *s;
}
ARENITE_READER std::vector<double> ValueReader<std::vector<double>>::read(const Value& value,
                                                                          const ReadContext& at) {
  return detail::numbers(value, at);
}

#endif

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
