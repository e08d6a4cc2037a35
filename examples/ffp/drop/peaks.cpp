#include "peaks.hpp"

#include <algorithm>
#include <utility>

#include <arenite/core/error.hpp>

namespace arenite::ffp {

StepIntegral::StepIntegral(std::vector<double> time, const std::vector<double>& value)
    : time_{std::move(time)} {
  require(time_.size() == value.size() && !time_.empty(), "StepIntegral.value", value.size(),
          "needs one value a time, and at least one");
  integral_.assign(1, 0.0);
  for (std::size_t i = 1; i < time_.size(); ++i) {
    require(time_[i] > time_[i - 1], "StepIntegral.time", time_[i], "must be greater than the time before");
    integral_.push_back(integral_.back() + value[i] * (time_[i] - time_[i - 1]));
  }
}

double StepIntegral::operator()(double t) const {
  if (t <= time_.front()) return 0;
  if (t >= time_.back()) return integral_.back();
  const auto i = static_cast<std::size_t>(std::upper_bound(time_.begin(), time_.end(), t) - time_.begin());
  const double share = (t - time_[i - 1]) / (time_[i] - time_[i - 1]);
  return integral_[i - 1] + share * (integral_[i] - integral_[i - 1]);
}

std::vector<double> moving_average(const std::vector<double>& time, const std::vector<double>& value,
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

Peaks find_peaks(const std::vector<double>& filtered, double rise) {
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
