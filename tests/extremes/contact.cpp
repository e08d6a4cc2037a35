// Random scenes of bodies in contact, and of rigid bodies: see runner.hpp.
#include "runner.hpp"

using namespace arenite;
using namespace arenite::extremes;

namespace {

/// Two bodies one above the other with Coulomb friction between them.
template <class M, class La, class Lb, class N>
Outcome two_bodies(Draw& d) {
  constexpr int D = M::dimension;
  return judge(d, [&] {
    const auto mesh = mesh_of<M>(d);
    const auto options = fill_options(d, mesh);
    Scene scene{PlaneStrain{},
                mesh,
                numerics_of<N>(d),
                bodies(fill(blob<D>(d, extent(mesh), 0, 2), law<La>(d), options),
                       fill(blob<D>(d, extent(mesh), 1, 2), law<Lb>(d, d.contrast), options)),
                walls_of<D>(d),
                gravity_of(d),
                Coulomb{Friction(d.contact_friction)},
                TrackEnergy{}};
    set_in_motion(scene, d);
    return scene;
  });
}

/// A ball, m.
struct DistanceToBall {
  Vec<double, 3> centre;
  double radius;
  double operator()(const Vec<double, 3>& x) const { return (x - centre).norm() - radius; }
};

/// A guided ball on a grid, above the body or within it.
Outcome ball(Draw& d) {
  return judge(d, [&] {
    const auto mesh = grid<3, float>(d);
    const double size = extent(mesh);
    const DistanceToBall shape{size * Vec<double, 3>(0.5, d.random.uniform(0.6, 0.8), 0.5),
                               d.random.uniform(0.1, 0.3) * size};
    const double mass = d.density * d.contrast * std::pow(shape.radius, 3);
    Scene scene{ThreeDimensional{},
                mesh,
                numerics_of<Numerics<QuadraticBSpline, Flip, Musl>>(d),
                bodies(fill(blob<3>(d, size), law<DruckerPrager<>>(d), fill_options(d, mesh))),
                walls_of<3>(d),
                gravity_of(d),
                rigids(rigid(DistanceSurface{shape}, Guided{.mass = mass, .velocity = -d.speed},
                             Friction(d.contact_friction))),
                TrackEnergy{}};
    set_in_motion(scene, d);
    return scene;
  });
}

/// A block of the mesh, guided, that the mesh follows, above sand; through the centre of mass.
Outcome device(Draw& d) {
  return judge(d, [&] {
    const auto mesh = simplices<2, double>(d, true);
    const double size = extent(mesh), side = 0.4 * size;
    if (d.layout != Layout::floor) d.k0 = -1;
    d.layout = Layout::floor;
    const double mass = d.density * d.contrast * side * side;
    Scene scene{
        PlaneStrain{},
        mesh,
        numerics_of<Numerics<LinearSimplex, Flip, Musl, NodalAndElementAverage>>(d),
        bodies(fill(blob<2>(d, size), law<MohrCoulomb<>>(d), fill_options(d, mesh))),
        walls_of<2>(d),
        gravity_of(d),
        rigids(rigid(MeshSurface{"device"}, Guided{.mass = mass, .velocity = -d.speed},
                     Friction(d.contact_friction), CentreOfMass{})),
        MovingMesh<>{
            .fixed_below = 0, .moving_from = 0.55 * size, .moving_to = 0.85 * size, .fixed_above = size},
        TrackEnergy{}};
    set_in_motion(scene, d);
    return scene;
  });
}

}  // namespace

TEST_CASE("Random scenes with contact end sound, or say when and why not") {
  run_scenes(
      "contact",
      {{"plane B-splines APIC USL, Coulomb, elastic on elastic double",
        two_bodies<CartesianGrid<2>, LinearElastic, LinearElastic, Numerics<QuadraticBSpline, Apic, Usl>>},
       {"triangles FLIP MUSL, Coulomb, elastic on Mohr-Coulomb float",
        two_bodies<SimplexMesh<2, float>, MohrCoulomb<>, LinearElastic, Numerics<LinearSimplex, Flip, Musl>>},
       {"solid B-splines FLIP MUSL, guided ball on Drucker-Prager float", ball},
       {"triangles both averages, moving mesh, centre of mass on Mohr-Coulomb double", device}},
      100);
}
