// Random scenes on triangles and tetrahedra, with and without averages: see runner.hpp.
#include "runner.hpp"

using namespace arenite;
using namespace arenite::extremes;

namespace {

template <class K, int D, real T, class L, class N>
Outcome on_simplices(Draw& d) {
  return judge(d, [&] {
    const auto mesh = simplices<D, T>(d);
    N numerics{};
    if constexpr (requires { numerics.transfer.share; }) numerics.transfer.share = d.share;
    Scene scene{K{},
                mesh,
                numerics,
                bodies(fill(blob<D>(d, extent(mesh), 0, 1, K::hoop), law<L>(d), fill_options(d, mesh))),
                walls_of<D>(d),
                gravity_of(d),
                TrackEnergy{}};
    set_in_motion(scene, d);
    return scene;
  });
}

using S = LinearSimplex;

}  // namespace

TEST_CASE("Random scenes on triangles and tetrahedra end sound, or say when and why not") {
  run_scenes("simplex",
             {{"triangles TPIC USL elastic double",
               on_simplices<PlaneStrain, 2, double, LinearElastic, Numerics<S, Tpic, Usl>>},
              {"triangles FLIP MUSL elastic float",
               on_simplices<PlaneStrain, 2, float, LinearElastic, Numerics<S, Flip, Musl>>},
              {"axisymmetric FLIP MUSL both averages Mohr-Coulomb double",
               on_simplices<Axisymmetric, 2, double, MohrCoulomb<>,
                            Numerics<S, Flip, Musl, NodalAndElementAverage>>},
              {"triangles FLIP MUSL element average Mohr-Coulomb remembers double",
               on_simplices<PlaneStrain, 2, double, MohrCoulomb<RemembersOpening>,
                            Numerics<S, Flip, Musl, ElementAverage>>},
              {"tetrahedra FLIP USL nodal averaging Drucker-Prager float",
               on_simplices<Solid, 3, float, DruckerPrager<>, Numerics<S, Flip, Usl, NodalAveraging>>}},
             100);
}
