// A number that is never out of bounds: parameters of aggregates check themselves.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/error.hpp>
#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A number that was checked when it was given. `Rule` has `name` (of the parameter) and `bounds` (a
/// sentence), both static and const char*, and `static bool holds(double)`. Throws `error` with name, value
/// and bounds if that is false.
template <class Rule>
class Checked {
 public:
  Checked(double value) : value_{value} { require(Rule::holds(value), Rule::name, value, Rule::bounds); }
  operator double() const { return value_; }

 private:
  double value_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
