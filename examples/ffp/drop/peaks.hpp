// The peaks of a deceleration history. An explicit run writes one acceleration a step and its contact
// chatters from step to step, so a peak is one of a filtered history, and the filter is part of the result.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace arenite::ffp {

/// Integral of a history that is constant over each step: `value[i]` applies from `time[i - 1]` to `time[i]`,
/// as the acceleration of an explicit scheme does; `value[0]` is not used. Steps may differ in length.
class StepIntegral {
 public:
  /// time: [n] s, strictly ascending; value: [n]. Throws `error` if they do not fit.
  StepIntegral(std::vector<double> time, const std::vector<double>& value);

  /// Integral from the first time to t, which is clipped to the history.
  double operator()(double t) const;

  const std::vector<double>& time() const { return time_; }

 private:
  std::vector<double> time_;      ///< [n] s
  std::vector<double> integral_;  ///< [n] from time[0] to time[i]
};

/// Centred moving average over `window`, s, at the times of the history: exact for the steps of
/// `StepIntegral`, where it is the change of velocity over the window divided by the window. Within half a
/// window of an end it is the mean over the part of the window that the history covers.
std::vector<double> moving_average(const std::vector<double>& time, const std::vector<double>& value,
                                   double window);

/// The peaks of a filtered history, as places in it.
struct Peaks {
  std::size_t first = 0;              ///< the largest value
  std::optional<std::size_t> second;  ///< the second peak, if there is one
};

/// First peak: the largest value (the earliest, if several). Second peak: the largest value after the valley
/// that follows the first, where the valley is the lowest value before the history climbs again by `rise`
/// times the first peak. Wiggles smaller than that are no peaks.
Peaks find_peaks(const std::vector<double>& filtered, double rise = 0.1);

}  // namespace arenite::ffp
