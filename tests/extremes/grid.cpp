// Random scenes on Cartesian grids with B-splines: see runner.hpp.
#include "runner.hpp"

using namespace arenite;
using namespace arenite::extremes;

namespace {

template <class K, int D, real T, class L, class N>
Outcome on_grid(Draw& d) {
  return judge(d, [&] {
    const auto mesh = grid<D, T>(d);
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

using B = QuadraticBSpline;

}  // namespace

TEST_CASE("Random scenes on grids end sound, or say when and why not") {
  run_scenes("grid",
             {{"plane APIC USL elastic double",
               on_grid<PlaneStrain, 2, double, LinearElastic, Numerics<B, Apic, Usl>>},
              {"plane FLIP MUSL Mohr-Coulomb float",
               on_grid<PlaneStrain, 2, float, MohrCoulomb<>, Numerics<B, Flip, Musl>>},
              {"axisymmetric FLIP USL elastic double",
               on_grid<Axisymmetric, 2, double, LinearElastic, Numerics<B, Flip, Usl>>},
              {"solid APIC MUSL Drucker-Prager remembers float",
               on_grid<Solid, 3, float, DruckerPrager<RemembersOpening>, Numerics<B, Apic, Musl>>}},
             100);
}
