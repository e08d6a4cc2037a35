// What a scene warns of.
#pragma once

#include <arenite/core/warning.hpp>
#include <string>
#include <vector>

namespace arenite::test {

/// The warnings that `f()` gives. What it throws passes through, and the hook of before is back.
template <class F>
std::vector<std::string> warnings_of(F&& f) {
  std::vector<std::string> texts;
  const WarningHook old = on_warning([&](const std::string& text) { texts.push_back(text); });
  try {
    (void)f();
  } catch (...) {
    on_warning(old);
    throw;
  }
  on_warning(old);
  return texts;
}

}  // namespace arenite::test
