// Value: what a program in another language says of a scene, before anyone knows the scene's type: numbers,
// words, lists, names with values, arrays and functions.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Numbers in rows: `shape` [rows, columns, ..], the last index running fastest.
struct HostArray {
  std::vector<double> numbers{};
  std::vector<std::size_t> shape{};

  std::size_t rows() const { return shape.empty() ? 1 : shape.front(); }
  /// Numbers of a row.
  std::size_t columns() const {
    std::size_t n = 1;
    for (std::size_t k = 1; k < shape.size(); ++k) n *= shape[k];
    return n;
  }
};

/// A function of the host language over many arguments at once: a row in, a row out. It may be called on any
/// thread, and throws what the caller shall see.
using HostFunction = std::function<HostArray(const HostArray&)>;

/// Three numbers that the host may change between two steps, and functions read: a force, a velocity.
using HostSignal = std::shared_ptr<std::array<double, 3>>;

/// One value. Copies share arrays and functions.
class Value {
 public:
  using List = std::vector<Value>;
  using Dict = std::map<std::string, Value>;

  Value() = default;
  template <class V>
  requires(!std::same_as<std::remove_cvref_t<V>, Value>) Value(V&& v) : held_{std::forward<V>(v)} {}

  bool is_none() const { return std::holds_alternative<std::monostate>(held_); }
  template <class V>
  const V* get() const {
    return std::get_if<V>(&held_);
  }
  const HostArray* array() const { return shared<HostArray>(); }
  const HostFunction* function() const { return shared<HostFunction>(); }

  /// The value of that name, if this has names and there is one.
  const Value* find(const std::string& name) const {
    const Dict* all = get<Dict>();
    if (all == nullptr) return nullptr;
    const auto found = all->find(name);
    return found == all->end() ? nullptr : &found->second;
  }

  /// A short description of it, for messages.
  std::string text() const {
    if (is_none()) return "nothing";
    if (const bool* b = get<bool>()) return *b ? "true" : "false";
    if (const double* x = get<double>()) return joined_text({*x});
    if (const auto* s = get<std::string>()) return *s;
    if (const auto* l = get<List>()) return joined_text({"a list of ", l->size()});
    if (array()) return joined_text({"an array of ", array()->numbers.size(), " numbers"});
    if (function()) return "a function";
    return get<Dict>() ? "names with values" : "a signal";
  }

 private:
  template <class V>
  const V* shared() const {
    const auto* p = get<std::shared_ptr<const V>>();
    return p ? p->get() : nullptr;
  }

  std::variant<std::monostate, bool, double, std::string, List, Dict, std::shared_ptr<const HostArray>,
               std::shared_ptr<const HostFunction>, HostSignal>
      held_{};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
