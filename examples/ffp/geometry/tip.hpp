// The tips that the penetrometer takes: what each is shaped like, and what the instrument weighs with it.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "geometry.hpp"

namespace arenite::ffp {

enum class Tip { cone, cone_truncated, parabolic, blunt };

inline constexpr std::array<std::pair<std::string_view, Tip>, 4> tip_words{
    {{"cone", Tip::cone},
     {"cone-truncated", Tip::cone_truncated},
     {"parabolic", Tip::parabolic},
     {"blunt", Tip::blunt}}};

/// Radius of the flat end of the instrument's cone, m. With the base's 4.375 cm and 60 deg it leaves a cone
/// of 7.197 cm. Its published height of 7.55 cm would need 57.7 deg, or a flat end of 0.016 cm; angle and
/// radii are kept here.
inline constexpr double truncated_radius = 0.0022;

/// The published parabola, r^2 = 2.4184 d in cm, in m. It joins the cylinder at 7.915 cm with its own slope,
/// 15.5 deg from the cylinder's.
inline constexpr double parabola_constant = 0.024184;

/// The published instrument with this tip, without fillet and offset.
inline DeviceShape shape_of(Tip tip) {
  DeviceShape shape;
  if (tip == Tip::cone_truncated) shape.flat = truncated_radius;
  if (tip == Tip::parabolic) shape.parabola = parabola_constant;
  if (tip == Tip::blunt) shape.flat = shape.radius;
  return shape;
}

/// Published mass of the instrument with this tip, kg.
inline double usual_mass(Tip tip) { return tip == Tip::parabolic ? 9.15 : tip == Tip::blunt ? 10.30 : 7.71; }

}  // namespace arenite::ffp
