// Message of an exception.
#pragma once

#include <arenite/core/error.hpp>
#include <string>

namespace arenite::test {

/// Message of the `Exception` that `f` throws; others pass through.
template <class Exception = error, class F>
std::string message(F&& f) {
  try {
    f();
  } catch (const Exception& e) {
    return e.what();
  }
  return "nothing thrown";
}

}  // namespace arenite::test
