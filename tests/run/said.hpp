// Messages of a run: its error and its warnings.
#pragma once

#include <arenite/run/run.hpp>
#include <string>
#include <vector>

#include "warnings.hpp"

namespace arenite::test {

/// The error that `f()` throws and the warnings it gives.
struct Said {
  std::string error;
  std::vector<std::string> warnings;
};
template <class F>
Said said(F&& f) {
  Said out;
  out.warnings = warnings_of([&] {
    try {
      f();
    } catch (const run_error& e) {
      out.error = e.what();
    }
  });
  return out;
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace arenite::test
