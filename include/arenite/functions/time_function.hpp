// Functions of time that a few numbers describe: `Table`, `Ramp`. For loads and motions.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A function of time, s, linear between the rows {time, value}, constant before the first and after the
/// last: `Table{{0, 0}, {0.1, 5_kPa}, {0.3, 0}}`. Two rows of one time are a jump: the second applies there.
class Table {
 public:
  using Row = std::pair<double, double>;

  /// Throws `error` unless there is a row, all numbers are finite, and times do not fall.
  Table(std::initializer_list<Row> rows) : Table(std::vector<Row>(rows)) {}
  explicit Table(std::vector<Row> rows) : rows_{std::move(rows)} {
    require(rows_.size() > 0, "Table.rows", rows_.size(), "must be at least one");
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const auto [time, value] = rows_[k];
      require(std::isfinite(time), {"Table.time[", k, "]"}, time, "must be finite");
      require(std::isfinite(value), {"Table.value[", k, "]"}, value, "must be finite");
      if (k > 0)
        require(time >= rows_[k - 1].first, {"Table.time[", k, "]"}, time,
                {"must not lie before the one above, ", rows_[k - 1].first});
    }
  }

  double operator()(double time) const {
    const auto place = std::upper_bound(rows_.begin(), rows_.end(), time,
                                        [](double t, const Row& row) { return t < row.first; });
    const auto after = static_cast<std::size_t>(place - rows_.begin());
    if (after == 0) return rows_.front().second;
    if (after == rows_.size()) return rows_.back().second;
    const auto& [start, at_start] = rows_[after - 1];
    const auto& [end, at_end] = rows_[after];
    return at_start + (time - start) / (end - start) * (at_end - at_start);
  }

 private:
  std::vector<Row> rows_;
};

/// From one value to another, linearly in time, constant before and after.
///
/// `Ramp{.to = 100_kPa, .over = 0.2}`.
struct Ramp {
  double to = 1;  ///< value at the end, any, any
  double over =
      std::numeric_limits<double>::quiet_NaN();  ///< duration, s; required, >= 0; 0: a step at `start`
  double from = 0;                               ///< value at the start, any, any
  double start = 0;                              ///< when it begins, s, any

  double operator()(double time) const {
    if (time >= start + over) return to;
    return time <= start ? from : from + (to - from) * (time - start) / over;
  }
  /// Throws `error` for a number that is not finite, or a duration below zero.
  void check() const {
    require(std::isfinite(to), "Ramp.to", to, "must be finite");
    require(over >= 0 && std::isfinite(over), "Ramp.over", over, "must be given, and not negative");
    require(std::isfinite(from), "Ramp.from", from, "must be finite");
    require(std::isfinite(start), "Ramp.start", start, "must be finite");
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
