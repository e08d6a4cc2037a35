// Gravity of the driver's models.
#pragma once

namespace arenite::ffp {

inline constexpr double standard_gravity =
    9.81;  ///< m/s^2: gravity of the model, and the g of all decelerations

}  // namespace arenite::ffp
