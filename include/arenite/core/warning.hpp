// Warnings: what is worth a line although nothing is forbidden. They go through one hook of the process,
// which a program may replace.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

#include <arenite/core/once.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Text of a warning: a string. (A type of its own gives `std::function` of it a name of its own in units for
/// other instruction sets.)
struct WarningText : std::string {
  using std::string::string;
  WarningText(std::string text) : std::string(std::move(text)) {}
};

/// What is called with the text of each warning, one line without its end: any callable with a string. It may
/// throw: whoever warned then fails with that exception.
using WarningHook = std::function<void(const WarningText&)>;

namespace shared_detail {

/// The one place of the process that warnings pass through.
struct WarningOutlet {
  std::mutex mutex;
  WarningHook hook = [](const WarningText& text) {
    std::fprintf(stderr, "arenite: warning: %s\n", text.c_str());
  };
  std::atomic<std::size_t> count{0};

  static WarningOutlet& instance() {
    return once<WarningOutlet>(program::warning_outlet, []() -> WarningOutlet& {
      static WarningOutlet outlet;
      return outlet;
    });
  }
};

}  // namespace shared_detail

/// Replaces the hook and returns the old one. The first hook writes a line to standard error; an empty one
/// keeps silent. Any thread may call it at any time.
inline WarningHook on_warning(WarningHook hook) {
  auto& outlet = shared_detail::WarningOutlet::instance();
  const std::lock_guard lock(outlet.mutex);
  return std::exchange(outlet.hook, std::move(hook));
}

/// Warnings of the process so far, whatever the hook did with them.
inline std::size_t warning_count() { return shared_detail::WarningOutlet::instance().count; }

/// Gives a warning: counts it and calls the hook.
inline void warn(const std::string& text) {
  auto& outlet = shared_detail::WarningOutlet::instance();
  ++outlet.count;
  WarningHook hook;
  {
    const std::lock_guard lock(outlet.mutex);
    hook = outlet.hook;
  }
  if (hook) hook(text);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
