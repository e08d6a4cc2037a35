// Warnings: what is worth a line although nothing is forbidden. They go through one hook of the process,
// which a program may replace.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include <arenite/core/cold.hpp>
#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Text of a warning: a string. (With a distinct type `std::function` of it has a distinct name in units for
/// other instruction sets.)
struct WarningText : std::string {
  using std::string::string;
  WarningText(std::string text) : std::string(std::move(text)) {}
};

/// The hook: any callable with a string. It gets the text of each warning, one line without a newline. It may
/// throw: the code that warned then fails with that exception.
using WarningHook = std::function<void(const WarningText&)>;

/// Replaces the hook and returns the old one. The first hook writes a line to standard error; an empty one
/// keeps silent. Any thread may call it at any time.
WarningHook on_warning(WarningHook hook);

/// Warnings of the process so far, whatever the hook did with them.
std::size_t warning_count();

/// Gives a warning: counts it and calls the hook.
void warn(const std::string& text);

/// Whether warnings of this thread are dropped.
bool drops_warnings();

/// While it lives warnings of its thread are dropped: they were given before.
class WithoutWarnings {
 public:
  WithoutWarnings();
  ~WithoutWarnings();
  WithoutWarnings(const WithoutWarnings&) = delete;
  WithoutWarnings& operator=(const WithoutWarnings&) = delete;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <atomic>
#include <cstdio>
#include <mutex>

#include <arenite/core/once.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
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

inline thread_local int without_warnings = 0;

}  // namespace shared_detail

ARENITE_COLD WarningHook on_warning(WarningHook hook) {
  auto& outlet = shared_detail::WarningOutlet::instance();
  const std::lock_guard lock(outlet.mutex);
  return std::exchange(outlet.hook, std::move(hook));
}

ARENITE_COLD std::size_t warning_count() { return shared_detail::WarningOutlet::instance().count; }

ARENITE_COLD WithoutWarnings::WithoutWarnings() { ++shared_detail::without_warnings; }
ARENITE_COLD WithoutWarnings::~WithoutWarnings() { --shared_detail::without_warnings; }

ARENITE_COLD bool drops_warnings() { return shared_detail::without_warnings > 0; }

ARENITE_COLD void warn(const std::string& text) {
  if (drops_warnings()) return;
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

#endif  // ARENITE_HAS_COLD
