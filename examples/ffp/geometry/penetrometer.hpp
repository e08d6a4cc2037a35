// Penetrometers that are known by name: what their makers or a standard say of them.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "tip.hpp"

namespace arenite::ffp {

enum class Penetrometer { bluedrop, cone_10cm2, cone_15cm2, ball, sphere };

inline constexpr std::array<std::pair<std::string_view, Penetrometer>, 5> penetrometer_words{
    {{"bluedrop", Penetrometer::bluedrop},
     {"cone-10cm2", Penetrometer::cone_10cm2},
     {"cone-15cm2", Penetrometer::cone_15cm2},
     {"ball-100cm2", Penetrometer::ball},
     {"sphere-25cm", Penetrometer::sphere}}};

/// Size of a penetrometer, m, and where it is from.
struct PenetrometerSize {
  double diameter;
  double length;  ///< tip to top
  std::string_view source;
};

/// Standard cones and balls have a rod of any length: of themselves they are as slender as the BlueDrop.
inline PenetrometerSize size_of(Penetrometer which) {
  const DeviceShape blue;
  const double slender = blue.length / (2 * blue.radius);
  constexpr std::string_view standard = "ISO 22476-1: cone of 60 deg";
  switch (which) {
    case Penetrometer::cone_10cm2:
      return {0.0357, slender * 0.0357, standard};
    case Penetrometer::cone_15cm2:
      return {0.0437, slender * 0.0437, standard};
    case Penetrometer::ball:
      return {0.1128, slender * 0.1128, "a full-flow ball of 100 cm2 on a rod of 10 cm2"};
    case Penetrometer::sphere:
      return {0.25, 0.25, "the instrumented free-fall sphere of Morton, O'Loughlin and White 2014"};
    case Penetrometer::bluedrop:
      break;
  }
  return {2 * blue.radius, blue.length, "the paper"};
}

/// The outline of a penetrometer that is no tip on a cylinder, in proportion to its diameter, m.
inline std::optional<ProfileLine> outline_of(Penetrometer which, double diameter, double length) {
  const double ball = diameter / 2, rod = ball * 0.0357 / 0.1128;
  if (which == Penetrometer::sphere) return ProfileLine{{{{ball, ball}, ball}, {{0, length}, ball}}};
  if (which != Penetrometer::ball) return {};
  return ProfileLine{
      {{{ball, ball}, ball}, {{rod, ball + std::sqrt(ball * ball - rod * rod)}, ball}, {{rod, length}}}};
}

}  // namespace arenite::ffp
