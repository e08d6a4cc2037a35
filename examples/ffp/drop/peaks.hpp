// The peaks of a deceleration history. An explicit run writes one acceleration a step and its contact
// chatters from step to step, so a peak is one of a filtered history, and the filter is part of the result.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>

namespace arenite::ffp {

/// Integral of a history that is constant over each step: `value[i]` holds from `time[i - 1]` to `time[i]`,
/// as the acceleration of an explicit scheme does; `value[0]` is not used. Steps may differ in length.
class StepIntegral {
 public:
  /// time: [n] s, strictly ascending; value: [n]. Throws `error` if they do not fit.
  StepIntegral(std::vector<double> time, const std::vector<double>& value) : time_{std::move(time)} {
    require(time_.size() == value.size() && !time_.empty(), "StepIntegral.value", value.size(),
            "needs one value a time, and at least one");
    integral_.assign(1, 0.0);
    for (std::size_t i = 1; i < time_.size(); ++i) {
      require(time_[i] > time_[i - 1], "StepIntegral.time", time_[i], "must be greater than the time before");
      integral_.push_back(integral_.back() + value[i] * (time_[i] - time_[i - 1]));
    }
  }

  /// Integral from the first time to t, which is clipped to the history.
  double operator()(double t) const {
    if (t <= time_.front()) return 0;
    if (t >= time_.back()) return integral_.back();
    const auto i = static_cast<std::size_t>(std::upper_bound(time_.begin(), time_.end(), t) - time_.begin());
    const double share = (t - time_[i - 1]) / (time_[i] - time_[i - 1]);
    return integral_[i - 1] + share * (integral_[i] - integral_[i - 1]);
  }

  const std::vector<double>& time() const { return time_; }

 private:
  std::vector<double> time_;      ///< [n] s
  std::vector<double> integral_;  ///< [n] from time[0] to time[i]
};

/// Centred moving average over `window`, s, at the times of the history: exact for the steps of
/// `StepIntegral`, where it is the change of velocity over the window divided by the window. Within half a
/// window of an end it is the mean over the part of the window that the history covers.
inline std::vector<double> moving_average(const std::vector<double>& time, const std::vector<double>& value,
                                          double window) {
  require(window > 0, "moving_average.window", window, "must be positive");
  const StepIntegral integral{time, value};
  std::vector<double> mean;
  for (const double t : time) {
    const double from = std::max(t - window / 2, time.front()), to = std::min(t + window / 2, time.back());
    mean.push_back(to > from ? (integral(to) - integral(from)) / (to - from) : value.front());
  }
  return mean;
}

/// The peaks of a filtered history, as places in it.
struct Peaks {
  std::size_t first = 0;              ///< the largest value
  std::optional<std::size_t> second;  ///< the second peak, if there is one
};

/// First peak: the largest value (the earliest, if several). Second peak: the largest value after the valley
/// that follows the first, where the valley is the lowest value before the history climbs again by `rise`
/// times the first peak. Wiggles smaller than that are no peaks.
inline Peaks find_peaks(const std::vector<double>& filtered, double rise = 0.1) {
  require(!filtered.empty(), "find_peaks.filtered", filtered.size(), "needs at least one value");
  Peaks peaks;
  peaks.first =
      static_cast<std::size_t>(std::max_element(filtered.begin(), filtered.end()) - filtered.begin());
  double lowest = filtered[peaks.first];
  for (std::size_t i = peaks.first; i < filtered.size(); ++i) {
    lowest = std::min(lowest, filtered[i]);
    if (filtered[i] > lowest + rise * filtered[peaks.first]) {
      peaks.second = static_cast<std::size_t>(
          std::max_element(filtered.begin() + static_cast<std::ptrdiff_t>(i), filtered.end()) -
          filtered.begin());
      break;
    }
  }
  return peaks;
}

}  // namespace arenite::ffp
