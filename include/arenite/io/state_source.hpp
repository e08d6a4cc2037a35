// State source: named numbers of a run's state, wherever they are kept: in a file or in memory.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/state_value.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A line of the head: what must be the same in the run that reads the file.
using StateTerm = std::pair<std::string, std::string>;

/// The source from which a state is restored.
class StateSource {
 public:
  virtual ~StateSource() = default;

  const std::vector<StateTerm>& terms() const { return terms_; }
  const std::vector<StateSlot>& entries() const { return entries_; }
  /// The entry of this name; null: there is none.
  const StateSlot* find(std::string_view name) const {
    const auto there = std::ranges::find(entries_, name, &StateSlot::name);
    return there != entries_.end() ? &*there : nullptr;
  }
  /// Writes an entry's numbers to `to`. Throws `error` for a bool that is neither 0 nor 1.
  void read(const StateSlot& entry, void* to) {
    if (entry.count == 0) return;
    get(entry, to);
    const auto* byte = static_cast<const unsigned char*>(to);
    if (entry.kind == 'b' && std::any_of(byte, byte + entry.size(), [](unsigned char b) { return b > 1; }))
      refuse(joined_text({"is damaged: ", entry.name, " is neither true nor false"}));
  }

  /// Throws `error` "state file = path: rule".
  [[noreturn]] void refuse(const std::string& rule) const {
    throw error(joined_text({"state file = ", path_.string(), ": ", rule}));
  }

 protected:
  explicit StateSource(std::filesystem::path path) : path_{std::move(path)} {}
  StateSource(const StateSource&) = default;
  StateSource(StateSource&&) = default;
  StateSource& operator=(const StateSource&) = default;
  StateSource& operator=(StateSource&&) = default;
  virtual void get(const StateSlot& entry, void* to) = 0;

  std::filesystem::path path_;
  std::vector<StateTerm> terms_;
  std::vector<StateSlot> entries_;
};

/// A state put aside in memory.
class StateCopy : public StateSource {
 public:
  /// Copies the numbers that the entries point to.
  explicit StateCopy(std::vector<StateSlot> entries) : StateSource("memory") {
    entries_ = std::move(entries);
    for (auto& entry : entries_) {
      const auto* byte = static_cast<const unsigned char*>(entry.data);
      bytes_.emplace_back(byte, byte + entry.size());
      entry.data = bytes_.back().data();
    }
  }

 private:
  void get(const StateSlot& entry, void* to) override {
    if (entry.size() > 0) std::memcpy(to, entry.data, entry.size());
  }

  std::vector<std::vector<unsigned char>> bytes_;  // [entries]
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
