// Cold functions of warning.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <cstdio>
#include <mutex>

#include <arenite/core/once.hpp>
#include <arenite/core/warning.hpp>

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
