// Parameters of Mohr-Coulomb that its tests go through.
#pragma once

#include <arenite/core/units.hpp>
#include <arenite/law/mohr_coulomb.hpp>
#include <vector>

namespace arenite::test {

inline std::vector<MohrCoulombParameters> parameter_sets() {
  return {{.density = 1540, .young = 5e6, .poisson = 0.33, .friction = 40_deg},
          {.density = 1540, .young = 5e6, .poisson = 0.33, .friction = 40_deg, .dilatancy = 12_deg},
          {.density = 1540,
           .young = 5e6,
           .poisson = 0.2,
           .friction = 30_deg,
           .cohesion = 3_kPa,
           .dilatancy = 30_deg},
          {.density = 1540,
           .young = 5e6,
           .poisson = 0.45,
           .friction = 25_deg,
           .cohesion = 10_kPa,
           .dilatancy = 5_deg},
          {.density = 1540, .young = 5e6, .poisson = 0.49, .friction = 0_deg, .cohesion = 5_kPa},
          {.density = 1540,
           .young = 5e6,
           .poisson = -0.5,
           .friction = 60_deg,
           .cohesion = 1_kPa,
           .dilatancy = 20_deg},
          {.density = 1540, .young = 5e6, .poisson = 0, .friction = 35_deg, .dilatancy = 35_deg}};
}

}  // namespace arenite::test
