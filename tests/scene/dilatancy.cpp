// Dense sand that shears and dilates under averages of strain and stress: it must not make energy, nor swell
// more than without averages. Every scene here blew up where the dilation went into the average.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

MohrCoulombParameters sand(double dilatancy) {
  return {.density = 1540, .young = 5e6, .poisson = 0.33, .friction = 40_deg, .dilatancy = dilatancy};
}

struct Outcome {
  double residual, swelling;  // energy residual over the work of gravity; mean V / V0
};

/// A bed on a rough base under gravity at 60 deg to its normal, which shears it along the base.
template <class A, class Scene>
Outcome sheared(Scene&& scene) {
  run(scene, {.end = 0.03, .courant = 0.5});
  const Energies e = energies(scene);
  return {e.residual / e.external, mean_volume_ratio(std::get<0>(scene.bodies))};
}

template <class A, class Law>
Outcome sheared_bed(const Law& law) {
  return sheared<A>(Scene{PlaneStrain{}, SimplexMesh<2>(test::triangles({0, 0}, {0.2, 0.06}, 20, 6)),
                          Numerics<LinearSimplex, Flip, Musl, A>{},
                          bodies(fill(Box{{0., 0.}, {0.2, 0.04}}, law, {.per_cell = 6})),
                          walls(bottom(fixed)), gravity({9.81 * std::sin(60_deg), -9.81 * std::cos(60_deg)}),
                          TrackEnergy{}});
}

template <class Law>
void check(const Law& law, double bound) {
  const Outcome without = sheared_bed<NoAntiLocking>(law);
  const Outcome nodal = sheared_bed<NodalAveraging>(law), both = sheared_bed<NodalAndElementAverage>(law);
  CAPTURE(without.residual, nodal.residual, both.residual, without.swelling, nodal.swelling, both.swelling);
  CHECK(std::abs(nodal.residual) <= bound);
  CHECK(std::abs(both.residual) <= bound);
  CHECK(nodal.swelling - 1 <= 1.1 * (without.swelling - 1) + 1e-3);
  CHECK(both.swelling - 1 <= 1.1 * (without.swelling - 1) + 1e-3);
}

}  // namespace

TEST_CASE("a sheared bed of dense sand makes no energy under averages") {
  for (const double psi : {0.0, 10_deg, 20_deg, 30_deg, 40_deg}) {
    CAPTURE(psi);
    check(MohrCoulomb{sand(psi)}, 0.04);
  }
  check(MohrCoulomb{sand(20_deg), RemembersOpening{}}, 0.04);
  check(
      DruckerPrager{
          {.density = 1540, .young = 5e6, .poisson = 0.33, .friction = 40_deg, .dilatancy = 20_deg}},
      0.04);
}
