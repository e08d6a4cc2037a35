// A record of deceleration, wherever it comes from.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <arenite/core/error.hpp>

#include "../geometry/geometry.hpp"
#include "../options/device_options.hpp"

namespace arenite::ffp {

/// The data of a drop's folder beside its deceleration.
struct DropFacts {
  double impact_velocity = 0;  ///< m/s, at t = 0
  double mass = 0, gravity = 0;
  double unit_weight = 0, k0 = 0;  ///< of the sand, N/m^3
  DeviceOptions device;            ///< the penetrometer
  double contact_offset = 0;       ///< m: from the penetrometer's surface to the contact surface

  Device body() const {
    DeviceShape shape = device.shape();
    shape.offset = contact_offset;
    return Device{shape};
  }
};

/// Deceleration against time: net, positive when it slows the penetrometer, 0 at rest, -g in free fall.
struct Measurement {
  std::vector<double> time;          ///< [n] s, ascending
  std::vector<double> deceleration;  ///< [n] m/s^2
  std::vector<double> depth{};       ///< [n] m, of the tip; empty: the integral of the deceleration is
  bool step_means =
      false;  ///< deceleration[i] is the mean from time[i - 1] to time[i], not the value at time[i]
  std::vector<std::string> notes;   ///< where it was found, for the user
  std::optional<DropFacts> drop{};  ///< of a drop's folder
};

/// Throws `error` that names the file if the record has less than two samples, or times that do not ascend.
inline void check(const Measurement& m, const std::string& file) {
  require(m.time.size() >= 2, file, joined_text({m.time.size(), " rows"}), "a record needs at least two");
  for (std::size_t i = 1; i < m.time.size(); ++i)
    require(m.time[i] > m.time[i - 1], {file, ": time in row ", i + 1}, m.time[i],
            {"must be greater than the time before, ", m.time[i - 1]});
}

/// Mean over the interval that ends at each sample, [n]; the first is the first sample's own value.
inline std::vector<double> interval_means(const Measurement& m) {
  std::vector<double> mean = m.deceleration;
  if (!m.step_means)
    for (std::size_t i = 1; i < mean.size(); ++i) mean[i] = (m.deceleration[i - 1] + m.deceleration[i]) / 2;
  return mean;
}

}  // namespace arenite::ffp
