// Warnings of a scene.
#pragma once

#include <arenite/core/warning.hpp>
#include <string>
#include <vector>

namespace arenite::test {

/// The warnings that `f()` gives. Exceptions pass through, and the previous hook is restored.
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
