// A bar that a growing body force draws out against the closed form of its stretch: with FLIP and MUSL points must
// move with the velocities that strain them, or they drift from their strains and the bar parts.
#include <arenite/arenite.hpp>

#include "../../examples/extend/laws/neo_hookean.hpp"
#include "catch.hpp"

using namespace arenite;

namespace {

constexpr double young = 1e6, density = 1000, length = 1, width = 0.4;  // Pa, kg/m3, m, m
const Elasticity rubber{"rubber", density, young, 0.3};

/// Stretch of a bar between rollers under the nominal stress P = (G (l^2 - 1) + lame ln l) / l, Pa.
double stretch_under(double nominal) {
  double low = 1, high = 6;
  for (int k = 0; k < 60; ++k) {
    const double l = (low + high) / 2;
    ((rubber.shear() * (l * l - 1) + rubber.lame() * std::log(l)) / l < nominal ? low : high) = l;
  }
  return low;
}

}  // namespace

TEST_CASE(
    "A neo-Hookean bar of ten cells stays whole to twice its length, little damped, at the step of run") {
  const double most = 1.1 * young / density / length;  // body force after 3 s, m/s2
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {width, 4}, .cell = 0.1}},
              Numerics<QuadraticBSpline>{},
              bodies(fill(Box{{0, 0}, {width, length}}, NeoHookean{rubber}, {.per_cell = 9})),
              walls(left(roller), right(roller), bottom(fixed)),
              gravity({0, most}, Ramp{.over = 3}),
              LocalDamping{.factor = 0.1},
              Reactions{},
              TrackEnergy{}};
  run(scene, {.end = 2.2});
  const double force = density * most * scene.time / 3;  // N/m3
  CHECK(stretch_under(force * length) == Approx(2.06).margin(0.02));
  CHECK(-reaction(scene, "bottom").force[1] == Approx(force * length * width).epsilon(0.03));
  double tip = 0, top = 0;
  for (int k = 0; k < 1000; ++k) tip += stretch_under(force * length * (k + 0.5) / 1000) * length / 1000;
  // The upper row of points lies a sixth of a cell below the end, where there is no stress.
  for (const auto& x : scene.body().points.position) top = std::max(top, x[1]);
  CHECK(top + 0.1 / 6 == Approx(tip).epsilon(0.01));
  const Energies e = energies(scene);
  CHECK(std::abs(e.residual) <= 0.005 * e.strain);
}
