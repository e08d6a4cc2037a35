// Values of a state: what a visitor of a state is shown, and the paths that name them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A number: any arithmetic type.
template <class V>
concept state_number = std::is_arithmetic_v<std::remove_cvref_t<V>>;

/// Numbers side by side in memory: `data()` and `size()`.
template <class V>
concept state_array = requires(V& v) {
  { v.size() } -> std::convertible_to<std::size_t>;
  requires state_number<decltype(*v.data())>;
};

/// Those whose count changes in a run: whoever restores a state calls `resize(n)` first.
template <class V>
concept resizable_state_array = state_array<V> && requires(V& v, std::size_t n) {
  v.resize(n);
};

template <class V>
concept state_value = state_number<V> || state_array<V>;

/// Visits values below a path: calls `f("prefix/name", value)`. For a `visit_state` that asks others for
/// theirs. `ReadOnly`: numbers are handed on as constants, arrays as spans of them.
template <class F, bool ReadOnly = false>
class StateUnder {
 public:
  StateUnder(F& f, std::string prefix) : f_{f}, prefix_{std::move(prefix)} {}

  template <class V>
  void operator()(std::string_view name, V&& value) const {
    static_assert(state_value<std::remove_reference_t<V>>,
                  "visit_state: call f(name, value) with a number, or with numbers side by side: data() and "
                  "size(), and resize(n) if their count changes");
    const std::string path = prefix_.empty() ? std::string(name) : prefix_ + "/" + std::string(name);
    if constexpr (state_number<V>) {
      if constexpr (ReadOnly)
        f_(path, std::as_const(value));
      else
        f_(path, value);
    } else if constexpr (ReadOnly) {
      using Number = std::remove_reference_t<decltype(*value.data())>;
      std::span<const Number> numbers(value.data(), static_cast<std::size_t>(value.size()));
      f_(path, numbers);
    } else if constexpr (requires { std::remove_cvref_t<V>::RowsAtCompileTime; }) {
      std::span numbers(value.data(), static_cast<std::size_t>(value.size()));  // of fixed size, of Eigen's
      f_(path, numbers);
    } else {
      f_(path, value);
    }
  }

 private:
  F& f_;
  std::string prefix_;
};

/// Calls `f("path/name", value)` for the state of what has a `visit_state`: of an observer, say.
template <class Owner, class F>
void visit_state_of(Owner& owner, std::string path, F&& f) {
  constexpr bool constant = std::is_const_v<Owner>;
  // `visit_state` itself changes nothing.
  const_cast<std::remove_const_t<Owner>&>(owner).visit_state(
      StateUnder<std::remove_reference_t<F>, constant>(f, std::move(path)));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
