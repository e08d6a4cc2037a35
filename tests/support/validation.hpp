// A test's computed values with exact or measured ones, for docs/validation.py: tables and curves of a case,
// in the working folder of the test.
#pragma once

#include <fstream>
#include <iomanip>
#include <string>
#include <utility>

namespace arenite::test {

/// Writes validation_<case>.csv, a row for each value, and validation_<case>_curves.csv, a row for each point
/// of each curve. Text must not contain commas.
class Validation {
 public:
  /// `reference`: name of the values compared with, in tables and pictures.
  explicit Validation(const std::string& of_case, std::string reference = "exact")
      : name_{"validation_" + of_case}, reference_{std::move(reference)} {}

  void value(const std::string& composition, const std::string& quantity, const std::string& unit,
             double computed, double exact) {
    open(values_, ".csv", "composition,quantity,unit,computed," + reference_);
    values_ << composition << ',' << quantity << ',' << unit << ',' << computed << ',' << exact << '\n';
  }
  /// `x_label`, `y_label`: of the axes, with units; the first call's count.
  void point(const std::string& curve, const std::string& x_label, double x, const std::string& y_label,
             double computed, double exact) {
    open(curves_, "_curves.csv", "curve," + x_label + ',' + y_label + ',' + reference_);
    curves_ << curve << ',' << x << ',' << computed << ',' << exact << '\n';
  }

 private:
  void open(std::ofstream& file, const char* end, const std::string& head) const {
    if (file.is_open()) return;
    file.open(name_ + end);
    file << std::setprecision(9) << head << '\n';
  }

  std::string name_, reference_;
  std::ofstream values_, curves_;
};

}  // namespace arenite::test
