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

namespace arenite {

/// What is called with the text of each warning, one line without its end. It may throw: whoever warned then
/// fails with that exception.
using WarningHook = std::function<void(const std::string&)>;

namespace detail {

/// The one place of the process that warnings pass through.
struct WarningOutlet {
  std::mutex mutex;
  WarningHook hook = [](const std::string& text) {
    std::fprintf(stderr, "arenite: warning: %s\n", text.c_str());
  };
  std::atomic<std::size_t> count{0};

  static WarningOutlet& instance() {
    static WarningOutlet outlet;
    return outlet;
  }
};

}  // namespace detail

/// Replaces the hook and returns the old one. The first hook writes a line to standard error; an empty one
/// keeps silent. Any thread may call it at any time.
inline WarningHook on_warning(WarningHook hook) {
  auto& outlet = detail::WarningOutlet::instance();
  const std::lock_guard lock(outlet.mutex);
  return std::exchange(outlet.hook, std::move(hook));
}

/// Warnings of the process so far, whatever the hook did with them.
inline std::size_t warning_count() { return detail::WarningOutlet::instance().count; }

/// Gives a warning: counts it and calls the hook.
inline void warn(const std::string& text) {
  auto& outlet = detail::WarningOutlet::instance();
  ++outlet.count;
  WarningHook hook;
  {
    const std::lock_guard lock(outlet.mutex);
    hook = outlet.hook;
  }
  if (hook) hook(text);
}

}  // namespace arenite
