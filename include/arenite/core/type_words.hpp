// Types as words: what a file says of the composition that wrote it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <string>
#include <string_view>

#include <arenite/core/error.hpp>
#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace shared_detail {

/// Name of a type without namespaces and template arguments, out of the compiler's text of it: g++
/// "std::string .. [with T = ns::X<..>; std::string = ..]", clang "std::string .. [T = ns::X<..>]".
template <class T>
std::string bare_type_name() {
  std::string_view text = __PRETTY_FUNCTION__;
  text.remove_prefix(text.find("T = ") + 4);
  text = text.substr(0, text.find_first_of("<;]"));
  const auto scope = text.rfind("::");
  return std::string(scope == std::string_view::npos ? text : text.substr(scope + 2));
}

template <class T>
struct TypeWords {
  static std::string text() { return bare_type_name<T>(); }
};

}  // namespace shared_detail

/// A type as it is written, without namespaces, but with all template arguments, the same from all compilers:
/// "MohrCoulomb<ForgetsOpening,ConstantFriction,ConstantStiffness>", "CartesianGrid<2,double>". Of templates
/// with other arguments than types, or one type and one number in any order, only the name.
template <class T>
std::string type_words() {
  return shared_detail::TypeWords<T>::text();
}

namespace shared_detail {

template <template <class...> class Template, class... T>
struct TypeWords<Template<T...>> {
  static std::string text() {
    std::string list;
    ((list = joined_text({list, list.empty() ? "" : ",", type_words<T>()})), ...);
    return joined_text({bare_type_name<Template<T...>>(), "<", list, ">"});
  }
};
template <template <class, int> class Template, class T, int N>
struct TypeWords<Template<T, N>> {
  static std::string text() {
    return joined_text({bare_type_name<Template<T, N>>(), "<", type_words<T>(), ",", N, ">"});
  }
};
template <template <int, class> class Template, int N, class T>
struct TypeWords<Template<N, T>> {
  static std::string text() {
    return joined_text({bare_type_name<Template<N, T>>(), "<", N, ",", type_words<T>(), ">"});
  }
};

}  // namespace shared_detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
