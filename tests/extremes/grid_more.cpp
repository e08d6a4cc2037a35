// Random scenes of what the core does not draw: other shape functions, grids, transfers, orders and laws.
// Built with ARENITE_TEST_EXTREMES_ALL, as run.sh does. See runner.hpp.
#include "one_body.hpp"

using namespace arenite;
using namespace arenite::extremes;

namespace {

using B = QuadraticBSpline;
using Grid = CartesianGrid<2>;
using Softening = MohrCoulomb<ForgetsOpening, SofteningFriction>;

/// Elastic, on a grid without walls that is closed along x.
Outcome ring(Draw& d) {
  d.layout = Layout::free;
  d.k0 = -1;
  return one_body<PlaneStrain, PeriodicGrid<Grid, 1>, LinearElastic, Numerics<B, Xpic, Usl>>(d);
}

}  // namespace

TEST_CASE("Random scenes on grids of all kinds end sound, or say when and why not") {
  run_scenes("grid_more",
             {{"cubic B-splines APIC USL elastic double",
               one_body<PlaneStrain, Grid, LinearElastic, Numerics<CubicBSpline, Apic, Usl>>},
              {"uGIMP FLIP USL Mohr-Coulomb double",
               one_body<PlaneStrain, Grid, MohrCoulomb<>, Numerics<UGimp<2>, Flip, Usl>>},
              {"linear grid FLIP MUSL elastic double",
               one_body<PlaneStrain, Grid, LinearElastic, Numerics<LinearGrid, Flip, Musl>>},
              {"rectilinear AFLIP USL, softening Mohr-Coulomb double",
               one_body<PlaneStrain, RectilinearGrid<2>, Softening, Numerics<B, Aflip, Usl>>},
              {"periodic XPIC USL elastic double", ring},
              {"FMPM MUSL Drucker-Prager double",
               one_body<PlaneStrain, Grid, DruckerPrager<>, Numerics<B, Fmpm, Musl>>},
              {"FLIP USF softening Mohr-Coulomb double",
               one_body<PlaneStrain, Grid, Softening, Numerics<B, Flip, Usf>>},
              {"AFLIP MUSL softening Mohr-Coulomb float",
               one_body<PlaneStrain, CartesianGrid<2, float>, Softening, Numerics<B, Aflip, Musl>>}},
             100);
}
