// Uncertainty of a computed value: parts by name, each with what it was estimated from, and their sum.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Half of max - min. Throws `error` with fewer than two values, or one that is not finite.
inline double half_spread(const std::vector<double>& values) {
  require(values.size() >= 2, "half_spread.values", values.size(), "needs two values at least");
  for (const double v : values) require(std::isfinite(v), "half_spread.values", v, "must be finite");
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return (*high - *low) / 2;
}

/// Half width of an error bar as parts that are independent of each other, so that their squares add (JCGM
/// 100:2008, Guide to the Expression of Uncertainty in Measurement, 5.1.2, with sensitivities of 1). A part
/// that could not be estimated is unknown, and so is then the whole.
class Uncertainty {
 public:
  struct Part {
    std::string name;
    std::optional<double> value;  ///< in the unit of the quantity; nothing: unknown
  };

  /// Throws `error` if the name is taken, or the value is negative or not finite.
  void add(std::string name, std::optional<double> value) {
    require(!name.empty() && !find(name), "Uncertainty.name", name, "must be given, and once");
    if (value)
      require(*value >= 0 && std::isfinite(*value), "Uncertainty." + name, *value,
              "must be finite and at least 0");
    parts_.push_back({std::move(name), value});
  }
  void add_unknown(std::string name) { add(std::move(name), std::nullopt); }

  /// In the order in which they were added.
  const std::vector<Part>& parts() const { return parts_; }
  /// Throws `error` without such a part.
  const Part& part(const std::string& name) const {
    const Part* found = find(name);
    require(found != nullptr, "Uncertainty.part", name, "there is no such part");
    return *found;
  }

  /// sqrt(sum u_i^2) of the parts that are known: what the error bar is at least.
  double known() const {
    double sum = 0;
    for (const Part& p : parts_) sum = std::hypot(sum, p.value.value_or(0));
    return sum;
  }
  /// sqrt(sum u_i^2); nothing if a part is unknown.
  std::optional<double> total() const {
    const bool complete =
        std::all_of(parts_.begin(), parts_.end(), [](const Part& p) { return p.value.has_value(); });
    return complete ? std::optional{known()} : std::nullopt;
  }

 private:
  const Part* find(const std::string& name) const {
    const auto at = std::find_if(parts_.begin(), parts_.end(), [&](const Part& p) { return p.name == name; });
    return at == parts_.end() ? nullptr : &*at;
  }

  std::vector<Part> parts_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
