// What a run says: its error and its warnings.
#pragma once

#include <arenite/core/warning.hpp>
#include <arenite/run/run.hpp>
#include <string>
#include <vector>

namespace arenite::test {

/// What `f()` throws and the warnings it gives.
struct Said {
  std::string error;
  std::vector<std::string> warnings;
};
template <class F>
Said said(F&& f) {
  Said out;
  const WarningHook old = on_warning([&](const std::string& text) { out.warnings.push_back(text); });
  try {
    f();
  } catch (const run_error& e) {
    out.error = e.what();
  }
  on_warning(old);
  return out;
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace arenite::test
