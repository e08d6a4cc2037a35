// Random scenes on triangles and tetrahedra, with and without averages: see runner.hpp.
#include "one_body.hpp"

using namespace arenite;
using namespace arenite::extremes;

using S = LinearSimplex;
template <int D, real_scalar T = double>
using Mesh = SimplexMesh<D, T>;

TEST_CASE("Random scenes on triangles and tetrahedra end sound, or say when and why not") {
  run_scenes(
      "simplex",
      {{"triangles TPIC USL elastic double",
        one_body<PlaneStrain, Mesh<2>, LinearElastic, Numerics<S, Tpic, Usl>>},
       {"triangles FLIP MUSL elastic float",
        one_body<PlaneStrain, Mesh<2, float>, LinearElastic, Numerics<S, Flip, Musl>>},
       {"axisymmetric FLIP MUSL both averages Mohr-Coulomb double",
        one_body<Axisymmetric, Mesh<2>, MohrCoulomb<>, Numerics<S, Flip, Musl, NodalAndElementAverage>>},
       {"triangles FLIP MUSL element average Mohr-Coulomb remembers double",
        one_body<PlaneStrain, Mesh<2>, MohrCoulomb<RemembersOpening>,
                 Numerics<S, Flip, Musl, ElementAverage>>},
       {"tetrahedra FLIP USL nodal averaging Drucker-Prager float",
        one_body<ThreeDimensional, Mesh<3, float>, DruckerPrager<>, Numerics<S, Flip, Usl, NodalAveraging>>}},
      100);
}
