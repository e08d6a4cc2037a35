// How the mass of a homogeneous penetrometer lies: centre and radius of gyration.
#pragma once

#include <array>
#include <cmath>

#include "geometry.hpp"

namespace arenite::ffp {

/// Of a body of one density, turned about its axis.
struct MassOf {
  double centre;    ///< of mass, above the tip of its outline, m
  double gyration;  ///< radius about a line through the centre, across the axis, m
};

/// A disc of radius r at the height y has the moments pi r^2 y^k and, about a diameter, pi r^4 / 4; r is linear
/// between the corners of the outline, so that three places of Gauss are exact.
inline MassOf mass_in(const Device& body) {
  constexpr double off = 0.7745966692414834;  // sqrt(3 / 5)
  constexpr std::array<std::array<double, 2>, 3> places{{{-off, 5. / 18}, {0, 8. / 18}, {off, 5. / 18}}};
  const auto line = body.outline();
  double volume = 0, first = 0, second = 0;
  for (std::size_t k = 1; k < line.size(); ++k)
    for (const auto& [at, weight] : places) {
      const Point2 x = (line[k - 1] + line[k]) / 2 + at * (line[k] - line[k - 1]) / 2;
      const double disc = pi * x[0] * x[0] * weight * (line[k][1] - line[k - 1][1]);
      volume += disc;
      first += disc * x[1];
      second += disc * (x[1] * x[1] + x[0] * x[0] / 4);
    }
  const double centre = first / volume;
  return {centre, std::sqrt(second / volume - centre * centre)};
}

}  // namespace arenite::ffp
