// Random scenes on Cartesian grids with B-splines: see runner.hpp.
#include "one_body.hpp"

using namespace arenite;
using namespace arenite::extremes;

using B = QuadraticBSpline;
template <int D, real_scalar T = double>
using Grid = CartesianGrid<D, T>;

TEST_CASE("Random scenes on grids end sound, or say when and why not") {
  run_scenes("grid",
             {{"plane APIC USL elastic double",
               one_body<PlaneStrain, Grid<2>, LinearElastic, Numerics<B, Apic, Usl>>},
              {"plane FLIP MUSL Mohr-Coulomb float",
               one_body<PlaneStrain, Grid<2, float>, MohrCoulomb<>, Numerics<B, Flip, Musl>>},
              {"axisymmetric FLIP USL elastic double",
               one_body<Axisymmetric, Grid<2>, LinearElastic, Numerics<B, Flip, Usl>>},
              {"solid APIC MUSL Drucker-Prager remembers float",
               one_body<ThreeDimensional, Grid<3, float>, DruckerPrager<RemembersOpening>,
                        Numerics<B, Apic, Musl>>}},
             100);
}
