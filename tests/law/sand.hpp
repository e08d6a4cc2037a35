// Laws and driven paths that the tests of sand share.
#pragma once

#include <arenite/arenite.hpp>

namespace arenite::test {

inline const MohrCoulombParameters pyramid{
    .density = 1540, .young = 20_MPa, .poisson = 0.3, .friction = 35_deg};
inline const DruckerPragerParameters cone{
    .density = 1540, .young = 20_MPa, .poisson = 0.3, .friction = 35_deg};

template <class Friction>
auto mohr_coulomb(const Friction& friction, const MohrCoulombParameters& p = pyramid) {
  return MohrCoulomb<ForgetsOpening, Friction>{p, {}, friction};
}
template <class Friction>
auto drucker_prager(const Friction& friction, const DruckerPragerParameters& p = cone) {
  return DruckerPrager<ForgetsOpening, Friction>{p, {}, friction};
}

/// Simple shear in plane strain by `gamma` at a rate, 1/s, under constant mean stress -p: all normal stresses
/// begin alike and the matter does not dilate, so that it is at constant volume.
template <class Law>
auto simple_shear(const Law& law, double p, double gamma, double rate, int steps) {
  DrivenPoint<Law, 2> point{.stress = {{-p, -p, -p, 0}}};
  drive(law, point,
        DriveStage<2>{
            .components = {{{}, {}, {}, strain_by(gamma / 2)}}, .duration = gamma / rate, .steps = steps},
        [](const auto&) {});
  return point;
}

/// Triaxial compression along y at a rate of the axial strain, 1/s, at a cell pressure.
template <class Law>
auto triaxial(const Law& law, double pressure, double shortening, double rate, int steps) {
  DrivenPoint<Law, 3> point{.stress = {{-pressure, -pressure, -pressure, 0, 0, 0}}};
  const auto cell = stress_to(-pressure);
  drive(law, point,
        DriveStage<3>{.components = {{cell, strain_by(-shortening), cell, {}, {}, {}}},
                      .duration = shortening / rate,
                      .steps = steps},
        [](const auto&) {});
  return point;
}

inline const SofteningParameters soft{.residual_friction = 31_deg, .residual_dilatancy = 1_deg, .decay = 8};

inline const PressureStiffness hypoelastic{
    {.exponent = 0.5, .reference_pressure = 100_kPa, .lowest_pressure = 2_kPa}};
inline const MohrCoulomb<ForgetsOpening, ConstantFriction, PressureStiffness> stiffening{
    pyramid, {}, {}, hypoelastic};

}  // namespace arenite::test
