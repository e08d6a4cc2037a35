// Random scenes of bodies under loads, between absorbing and frictional faces: see runner.hpp.
#include "one_body.hpp"

using namespace arenite;
using namespace arenite::extremes;

namespace {

/// Loads act on a body that fills the mesh from side to side, as a rule.
void lay(Draw& d) {
  if (d.layout == Layout::free || d.random.chance(0.5)) d.layout = Layout::floor;
}
Triple load_of(Draw& d) {
  const Vec<double, 2> t = d.young * d.random.decades(1e-7, 1e-2) * d.random.direction<2>();
  return {t[0], t[1], 0};
}
/// On the points of the upper half of a body.
PointTraction<Box<2>> load_on_points(Draw& d, double size) {
  return traction(surface(Box{{0., 0.3 * size}, {size, size}}, {.normal = {0, 1}, .thickness = 0.3 * size}),
                  VectorFunction(load_of(d)));
}
AbsorbingFaces absorber(Draw& d, MeshFaces where) {
  return absorbing(std::move(where),
                   {.support = d.k0 >= 0 || d.random.chance(0.3) ? Support::first_reaction : Support::none});
}
FrictionalWall rough(Draw& d, MeshFaces where) {
  return frictional(std::move(where), Friction(d.contact_friction), {.separates = d.random.chance(0.5)});
}

/// A traction on the right side; the left one and the bottom absorb.
template <class M, class L, class N>
Outcome waves(Draw& d) {
  lay(d);
  return one_body_with<PlaneStrain, M, L, N>(d, [&](const M&) {
    return std::tuple(traction(right(), VectorFunction(load_of(d))), absorber(d, left()),
                      absorber(d, bottom()));
  });
}
/// A traction on points; the sides absorb, the bottom is a wall.
template <class M, class L, class N>
Outcome pressed(Draw& d) {
  lay(d);
  return one_body_with<PlaneStrain, M, L, N>(d, [&](const M& mesh) {
    return std::tuple(load_on_points(d, extent(mesh)), absorber(d, left()), absorber(d, right()),
                      walls(bottom(d.smooth ? roller : fixed)));
  });
}
/// A pressure on the right side, friction at the others.
template <class M, class L, class N>
Outcome rubbed(Draw& d) {
  lay(d);
  return one_body_with<PlaneStrain, M, L, N>(d, [&](const M&) {
    return std::tuple(pressure(right(), load_of(d)[0]), rough(d, left()), rough(d, bottom()));
  });
}
/// A traction on points, friction on all sides.
template <class M, class L, class N>
Outcome boxed(Draw& d) {
  lay(d);
  return one_body_with<PlaneStrain, M, L, N>(d, [&](const M& mesh) {
    return std::tuple(load_on_points(d, extent(mesh)), rough(d, left()), rough(d, right()),
                      rough(d, bottom()), rough(d, top()));
  });
}

using B = QuadraticBSpline;
using S = LinearSimplex;

}  // namespace

TEST_CASE("Random scenes with loads, absorbing and frictional faces end sound, or say when and why not") {
  run_scenes("load_more",
             {{"plane B-splines APIC USL, traction, absorbing faces, elastic double",
               waves<CartesianGrid<2>, LinearElastic, Numerics<B, Apic, Usl>>},
              {"triangles FLIP MUSL, pressure, frictional walls, Mohr-Coulomb double",
               rubbed<SimplexMesh<2>, MohrCoulomb<>, Numerics<S, Flip, Musl>>},
              {"plane B-splines FLIP MUSL, traction on points, frictional walls, Drucker-Prager float",
               boxed<CartesianGrid<2, float>, DruckerPrager<>, Numerics<B, Flip, Musl>>},
              {"triangles FLIP MUSL, traction on points, absorbing faces, elastic double",
               pressed<SimplexMesh<2>, LinearElastic, Numerics<S, Flip, Musl>>}},
             100);
}
