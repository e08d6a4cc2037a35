// Globals, one in a program: the thread pool and the hook of warnings serve all units, also those that are compiled
// for other instruction sets. Such units share the object and no function that works on it, so that each runs
// its own code. They share only data by name: an atomic pointer to the object.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>

#include <arenite/core/instruction_set.hpp>

namespace arenite::program::inline ARENITE_VERSION_NAMESPACE {

/// Where an object is, once it is made.
using Place = std::atomic<void*>;
inline constinit Place thread_pool{nullptr}, warning_outlet{nullptr};
/// Whether this thread is in a loop of the pool.
inline constinit thread_local bool in_loop = false;

}  // namespace arenite::program::inline ARENITE_VERSION_NAMESPACE

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The program's one T, made by the unit that asks first: `own()` returns that of the unit. T is laid out
/// alike in all units.
template <class T>
T& once(program::Place& place, T& (*own)()) {
  void* made = place.load(std::memory_order_acquire);
  if (made == nullptr) {
    T& object = own();
    if (place.compare_exchange_strong(made, &object, std::memory_order_acq_rel)) return object;
  }
  return *static_cast<T*>(made);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
