// Random scenes with frictions and stiffnesses that depend on rate, pressure and history, and with the
// deviatoric strain recorded: see runner.hpp.
#include "one_body.hpp"

using namespace arenite;
using namespace arenite::extremes;

namespace {

using B = QuadraticBSpline;
using S = LinearSimplex;
using Grid = CartesianGrid<2>;
using ByRate = MohrCoulomb<ForgetsOpening, RateSofteningFriction, RateStiffness>;
using Inertial = WithDeviatoricStrain<MohrCoulomb<ForgetsOpening, InertialFriction>, 2>;
using InertialCone = DruckerPrager<RemembersOpening, InertialFriction>;
using Logarithmic = MohrCoulomb<RemembersOpening, LogarithmicFriction>;
using Viscous = DruckerPrager<ForgetsOpening, LinearRateFriction, PressureStiffness>;

}  // namespace

TEST_CASE("Random scenes of laws with policies end sound, or say when and why not") {
  run_scenes("law_more",
             {{"plane B-splines FLIP MUSL Mohr-Coulomb, friction and stiffness by rate double",
               one_body<PlaneStrain, Grid, ByRate, Numerics<B, Flip, Musl>>},
              {"triangles FLIP MUSL Mohr-Coulomb, friction by inertia, deviatoric strain double",
               one_body<PlaneStrain, SimplexMesh<2>, Inertial, Numerics<S, Flip, Musl>>},
              {"plane B-splines APIC USL Drucker-Prager remembers, friction by inertia float",
               one_body<PlaneStrain, CartesianGrid<2, float>, InertialCone, Numerics<B, Apic, Usl>>},
              {"plane B-splines FLIP USL Mohr-Coulomb remembers, friction by log of rate double",
               one_body<PlaneStrain, Grid, Logarithmic, Numerics<B, Flip, Usl>>},
              {"triangles TPIC USL Drucker-Prager, friction in rate, stiffness by pressure double",
               one_body<PlaneStrain, SimplexMesh<2>, Viscous, Numerics<S, Tpic, Usl>>}},
             100);
}
