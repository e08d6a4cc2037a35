// Penetrometers that are known by name: what their makers or a standard say of them.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "tip.hpp"

namespace arenite::ffp {

enum class Penetrometer { bluedrop, cone_10cm2, cone_15cm2 };

inline constexpr std::array<std::pair<std::string_view, Penetrometer>, 3> penetrometer_words{
    {{"bluedrop", Penetrometer::bluedrop},
     {"cone-10cm2", Penetrometer::cone_10cm2},
     {"cone-15cm2", Penetrometer::cone_15cm2}}};

/// Size of a penetrometer, m, and where it is from.
struct PenetrometerSize {
  double diameter;
  double length;  ///< tip to top
  std::string_view source;
};

/// The standard cones have a rod of any length: of themselves they are as slender as the BlueDrop.
inline PenetrometerSize size_of(Penetrometer which) {
  constexpr DeviceShape blue{};
  constexpr double slender = blue.length / (2 * blue.radius);
  constexpr std::string_view standard = "ISO 22476-1: cone of 60 deg";
  switch (which) {
    case Penetrometer::cone_10cm2:
      return {0.0357, slender * 0.0357, standard};
    case Penetrometer::cone_15cm2:
      return {0.0437, slender * 0.0437, standard};
    case Penetrometer::bluedrop:
      break;
  }
  return {2 * blue.radius, blue.length, "the paper"};
}

}  // namespace arenite::ffp
