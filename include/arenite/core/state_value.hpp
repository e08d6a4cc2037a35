// Values of a state: what a visitor of a state is shown, the paths that name them, and the list of them.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

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
/// theirs. `ReadOnly`: numbers are passed as constants, arrays as spans of constants.
template <class F, bool ReadOnly = false>
class StateUnder {
 public:
  StateUnder(F& f, std::string prefix) : f_{f}, prefix_{std::move(prefix)} {}
  StateUnder(const StateUnder& above, std::string prefix) : f_{above.f_}, prefix_{above.path_of(prefix)} {}

  template <class V>
  void operator()(std::string_view name, V&& value) const {
    static_assert(state_value<std::remove_reference_t<V>>,
                  "visit_state: call f(name, value) with a number, or with numbers side by side: data() and "
                  "size(), and resize(n) if their count changes");
    static_assert(!state_number<V> || std::is_lvalue_reference_v<V>,
                  "visit_state: call f(name, value) with a member: a number that is computed there cannot be "
                  "restored");
    const std::string path = path_of(name);
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
  std::string path_of(std::string_view name) const {
    return prefix_.empty() ? std::string(name) : prefix_ + "/" + std::string(name);
  }

  F& f_;
  std::string prefix_;
};
// Below a path below a path: one visitor.
template <class F, bool ReadOnly>
StateUnder(StateUnder<F, ReadOnly>&, std::string) -> StateUnder<F, ReadOnly>;
template <class F, bool ReadOnly>
StateUnder(const StateUnder<F, ReadOnly>&, std::string) -> StateUnder<F, ReadOnly>;

/// An owner of a state whose `visit_state` can be called: it changes nothing, but is not a constant member,
/// because a state is restored by writing to what it shows.
template <class Owner>
std::remove_const_t<Owner>& state_owner(Owner& owner) {
  return const_cast<std::remove_const_t<Owner>&>(owner);
}

/// Calls `f("path/name", value)` for the state of what has a `visit_state`: of an observer, say.
template <class Owner, class F>
void visit_state_of(Owner& owner, std::string path, F&& f) {
  state_owner(owner).visit_state(
      StateUnder<std::remove_reference_t<F>, std::is_const_v<Owner>>(f, std::move(path)));
}

/// Kind of a number: 'f' floating, 'i' signed, 'u' unsigned, 'b' bool.
template <class Number>
inline constexpr char number_kind = std::is_same_v<Number, bool>       ? 'b'
                                    : std::is_floating_point_v<Number> ? 'f'
                                    : std::is_signed_v<Number>         ? 'i'
                                                                       : 'u';

/// A value of a state whatever its type: valid until the next step.
struct StateSlot {
  std::string name;       ///< path, such as "bodies/sand/points/position/x"
  char kind = 'f';        ///< `number_kind`
  std::size_t bytes = 8;  ///< of a number
  std::size_t count = 0;
  void* data = nullptr;   ///< [count]; null: the numbers are in a file
  bool is_array = false;  ///< numbers side by side, or one number
  void* array = nullptr;  ///< whose count changes
  /// Returns where the numbers are then; null: no count changes.
  void* (*resize)(void* array, std::size_t count) = nullptr;

  std::size_t size() const { return bytes * count; }
  /// "f8", "u4"
  std::string type() const { return kind + std::to_string(bytes); }
};

/// The visitor that lists a state: whatever is done with its values, one function finds them. They must
/// last until they are read or restored: members, and spans of the numbers in members.
struct StateSlots {
  std::vector<StateSlot> slots{};

  template <class Value>
  void operator()(std::string_view name, Value& value) {
    if constexpr (state_number<Value>) {
      add(name, &value, 1);
    } else {
      add(name, value.data(), static_cast<std::size_t>(value.size()));
      slots.back().is_array = true;
    }
    if constexpr (resizable_state_array<Value>) {
      static_assert(
          !std::is_trivially_copyable_v<Value>,
          "visit_state: an array whose count changes must own its numbers: a view of them may be gone "
          "when the state is restored");
      slots.back().array = &value;
      slots.back().resize = [](void* array, std::size_t count) -> void* {
        static_cast<Value*>(array)->resize(count);
        return static_cast<Value*>(array)->data();
      };
    }
  }

 private:
  template <class Number>
  void add(std::string_view name, Number* data, std::size_t count) {
    static_assert(!std::is_const_v<Number>, "visit_state: a state that is restored must not be constant");
    slots.push_back({std::string(name), number_kind<Number>, sizeof(Number), count, data});
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
