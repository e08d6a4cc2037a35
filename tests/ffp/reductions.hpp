// Reductions of records in files, as `arenite-ffp reduce` makes them.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "../../examples/ffp/command/read_reduce.hpp"
#include "../../examples/ffp/reduce/read_measurement.hpp"
#include "../../examples/ffp/reduce/reduction.hpp"
#include "catch.hpp"

namespace arenite::ffp {

/// Options of `reduce FILE ..`.
inline ReduceOptions options(const std::string& file, std::vector<std::string> words = {}) {
  words.insert(words.begin(), file);
  std::ostringstream answer;
  const auto o = read_reduce(words, answer);
  REQUIRE(o.has_value());
  return *o;
}

inline Reduction reduced(const std::string& file, std::vector<std::string> words = {}) {
  const auto o = options(file, std::move(words));
  return reduce(read_measurement(o), o);
}

inline std::string refusal(const std::string& file, std::vector<std::string> words = {}) {
  try {
    const auto o = options(file, std::move(words));
    reduce(read_measurement(o), o);
  } catch (const error& e) {
    return e.what();
  }
  return "accepted";
}

inline bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline std::string written(const std::string& name, const std::string& text) {
  std::ofstream{name, std::ios::binary} << text;
  return name;
}

inline const Estimate& estimate(const Reduction& r, const std::string& quantity) {
  for (const Estimate& e : r.estimates)
    if (e.quantity == quantity) return e;
  throw error("no estimate of " + quantity);
}

}  // namespace arenite::ffp
