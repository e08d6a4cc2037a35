// Members of an aggregate by name: names and types of its data members, taken from the compiler, so that a
// host's values find their places without a list to keep.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// Represents a value of any type where members are counted.
struct AnyMember {
  template <class T>
  operator T() const;
};
template <class T, std::size_t... At>
constexpr bool takes_members(std::index_sequence<At...>) {
  return requires { T{(void(At), AnyMember{})...}; };
}
inline constexpr std::size_t most_members = 12;
template <class T, std::size_t N = most_members>
constexpr std::size_t count_members() {
  if constexpr (N == 0 || takes_members<T>(std::make_index_sequence<N>{}))
    return N;
  else
    return count_members<T, N - 1>();
}

/// Pointers to the members of an object, in order.
template <class T>
constexpr auto pointers_to_members(const T& object) {
  constexpr std::size_t n = count_members<T>();
  static_assert(!takes_members<T>(std::make_index_sequence<most_members + 1>{}),
                "host: an aggregate with more than 12 members");
  if constexpr (n == 0) {
    return std::tuple<>{};
  } else if constexpr (n == 1) {
    const auto& [a] = object;
    return std::tuple(&a);
  } else if constexpr (n == 2) {
    const auto& [a, b] = object;
    return std::tuple(&a, &b);
  } else if constexpr (n == 3) {
    const auto& [a, b, c] = object;
    return std::tuple(&a, &b, &c);
  } else if constexpr (n == 4) {
    const auto& [a, b, c, d] = object;
    return std::tuple(&a, &b, &c, &d);
  } else if constexpr (n == 5) {
    const auto& [a, b, c, d, e] = object;
    return std::tuple(&a, &b, &c, &d, &e);
  } else if constexpr (n == 6) {
    const auto& [a, b, c, d, e, f] = object;
    return std::tuple(&a, &b, &c, &d, &e, &f);
  } else if constexpr (n == 7) {
    const auto& [a, b, c, d, e, f, g] = object;
    return std::tuple(&a, &b, &c, &d, &e, &f, &g);
  } else if constexpr (n == 8) {
    const auto& [a, b, c, d, e, f, g, h] = object;
    return std::tuple(&a, &b, &c, &d, &e, &f, &g, &h);
  } else if constexpr (n == 9) {
    const auto& [a, b, c, d, e, f, g, h, i] = object;
    return std::tuple(&a, &b, &c, &d, &e, &f, &g, &h, &i);
  } else if constexpr (n == 10) {
    const auto& [a, b, c, d, e, f, g, h, i, j] = object;
    return std::tuple(&a, &b, &c, &d, &e, &f, &g, &h, &i, &j);
  } else if constexpr (n == 11) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k] = object;
    return std::tuple(&a, &b, &c, &d, &e, &f, &g, &h, &i, &j, &k);
  } else {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l] = object;
    return std::tuple(&a, &b, &c, &d, &e, &f, &g, &h, &i, &j, &k, &l);
  }
}

/// An object that is never made: only the names of its members are asked for.
template <class T>
struct Unevaluated {
  T object;
};
template <class T>
extern const Unevaluated<T> unevaluated;

template <class P>
struct MemberPointer {
  P pointer;
  constexpr MemberPointer(P p) : pointer{p} {}
};
/// The last word of the compiler's text of the pointer: g++ "..value.MCP::density)}", clang "..value.g}]".
template <MemberPointer p>
constexpr std::string_view text_of_pointer() {
  return __PRETTY_FUNCTION__;
}
constexpr std::string_view member_in(std::string_view text) {
  text = text.substr(0, text.find('}'));
  if (text.ends_with(')')) text.remove_suffix(1);
  return text.substr(text.find_last_of(".:") + 1);
}

#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wundefined-var-template"
#pragma clang diagnostic ignored "-Wundefined-internal"
#endif
template <class T, std::size_t... At>
constexpr auto names_of_members(std::index_sequence<At...>) {
  return std::array<std::string_view, sizeof...(At)>{member_in(
      text_of_pointer<MemberPointer{std::get<At>(pointers_to_members(unevaluated<T>.object))}>())...};
}
#ifdef __clang__
#pragma clang diagnostic pop
#endif

}  // namespace detail

/// Number of data members of an aggregate without base classes.
template <class T>
inline constexpr std::size_t member_count = detail::count_members<T>();

/// Their names, in order.
template <class T>
inline constexpr auto member_names = detail::names_of_members<T>(std::make_index_sequence<member_count<T>>{});

/// Type of member K.
template <class T, std::size_t K>
using member_type =
    std::remove_cvref_t<decltype(*std::get<K>(detail::pointers_to_members(std::declval<const T&>())))>;

/// Member K of an object.
template <std::size_t K, class T>
constexpr const auto& member(const T& object) {
  return *std::get<K>(detail::pointers_to_members(object));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
