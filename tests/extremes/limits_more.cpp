// Random scenes further out than the others (points a cell, slivers, speed), and with parts that those have not: see runner.hpp.
#include "one_body.hpp"

using namespace arenite;
using namespace arenite::extremes;

namespace {

using B = QuadraticBSpline;
using S = LinearSimplex;

/// One to 1,000 points a cell.
Outcome crowded(Draw& d) {
  const int along = static_cast<int>(d.random.decades(1, 32));
  d.per_cell = along * along;
  return one_body<PlaneStrain, CartesianGrid<2>, DruckerPrager<>, Numerics<B, Apic, Usl>>(d);
}
/// Nodes moved by up to 0.45 of an edge: cells of any shape, some of them slivers or turned inside out.
template <class M, class L, class N, class K>
Outcome slivers(Draw& d) {
  d.jitter = d.random.uniform(0.3, 0.45);
  return one_body<K, M, L, N>(d);
}
/// Matter that is pulled apart or thrown on itself faster than its waves.
template <class L, class N>
Outcome torn(Draw& d) {
  d.speed = d.random.decades(0.3, 30) * d.wave();
  d.motion = d.random.chance(0.7) ? Motion::stretch : Motion::noise;
  return one_body<PlaneStrain, CartesianGrid<2>, L, N>(d);
}
/// A load at a point, a force on all matter, and gravity that grows.
template <class M, class L, class N>
Outcome loaded(Draw& d) {
  if (d.layout == Layout::free) d.layout = Layout::boxed;
  return judge(d, [&] {
    const auto mesh = mesh_of<M>(d);
    const double size = extent(mesh), shove = d.young * square(d.cell) * d.random.decades(1e-7, 1e-2);
    const Vec<double, 2> pull = d.gravity * d.random.direction<2>();
    const double duration = d.steps * d.courant * d.cell / (d.wave() + d.speed);
    Scene scene{PlaneStrain{},
                mesh,
                numerics_of<N>(d),
                bodies(fill(blob<2>(d, size), law<L>(d), fill_options(d, mesh))),
                walls_of<2>(d),
                gravity(Triple{0, -d.gravity, 0}, Ramp{.over = duration}),
                point_load({0.5 * size, 0.45 * size, 0}, Triple{0, -shove, 0}),
                body_force(Triple{pull[0], pull[1], 0}),
                TrackEnergy{}};
    set_in_motion(scene, d);
    return scene;
  });
}
/// A damped body.
template <class K, class M, class L, class N, class Damping>
Outcome damped(Draw& d) {
  return one_body_with<K, M, L, N>(d, [&](const M&) {
    const double share = d.random.uniform();
    if constexpr (std::same_as<Damping, LocalDamping>)
      return std::tuple(walls_of<M::dimension>(d), LocalDamping{.factor = 0.9 * share});
    else
      return std::tuple(walls_of<M::dimension>(d), ViscousDamping{.rate = share * d.wave() / d.cell});
  });
}

/// A disc, m.
struct DistanceToDisc {
  Vec<double, 2> centre;
  double radius;
  double operator()(const Vec<double, 2>& x) const { return (x - centre).norm() - radius; }
};
/// A disc above the body that is pushed down into it, or falls, at nodes that keep their gaps.
template <class Motion, class M, class L, class N>
Outcome pushed(Draw& d) {
  return one_body_with<PlaneStrain, M, L, N>(d, [&](const M& mesh) {
    const double size = extent(mesh), radius = d.random.uniform(0.05, 0.15) * size;
    const Vec<double, 2> centre(d.random.uniform(0.35, 0.65) * size,
                                blob<2>(d, size).upper[1] + radius * d.random.uniform(1, 1.3));
    const double speed = std::min(d.speed, 0.5 * d.wave());
    const auto motion = [&] {
      if constexpr (std::same_as<Motion, Prescribed>)
        return Prescribed([speed](double) { return std::array<double, 3>{0, -speed, 0}; });
      else
        return Guided{.mass = d.density * d.contrast * pi * square(radius), .velocity = -speed};
    };
    return std::tuple(walls_of<2>(d), rigid(DistanceSurface{DistanceToDisc{centre, radius}}, motion(),
                                            Friction(d.contact_friction), NodalGap{}));
  });
}

}  // namespace

TEST_CASE("Random scenes far out, and with further parts, end sound, or say when and why not") {
  run_scenes(
      "limits_more",
      {{"plane B-splines APIC USL, 1 to 1,000 points a cell, Drucker-Prager double", crowded},
       {"triangles with slivers FLIP MUSL elastic double",
        slivers<SimplexMesh<2>, LinearElastic, Numerics<S, Flip, Musl>, PlaneStrain>},
       {"tetrahedra with slivers FLIP MUSL both averages Mohr-Coulomb double",
        slivers<SimplexMesh<3>, MohrCoulomb<>, Numerics<S, Flip, Musl, NodalAndElementAverage>,
                ThreeDimensional>},
       {"plane B-splines AFLIP USL, faster than waves, elastic double",
        torn<LinearElastic, Numerics<B, Aflip, Usl>>},
       {"plane B-splines FLIP MUSL, faster than waves, Drucker-Prager double",
        torn<DruckerPrager<>, Numerics<B, Flip, Musl>>},
       {"plane uGIMP APIC MUSL, load at a point, body force, gravity in time, Mohr-Coulomb double",
        loaded<CartesianGrid<2>, MohrCoulomb<>, Numerics<UGimp<2>, Apic, Musl>>},
       {"plane B-splines APIC, middle of the motion, elastic double",
        one_body<PlaneStrain, CartesianGrid<2>, LinearElastic, Numerics<B, Apic, MidpointStrain<Usl>>>},
       {"solid linear grid FMPM USL, local damping, Drucker-Prager double",
        damped<ThreeDimensional, CartesianGrid<3>, DruckerPrager<>, Numerics<LinearGrid, Fmpm, Usl>,
               LocalDamping>},
       {"axisymmetric triangles TPIC USL, viscous damping, Mohr-Coulomb double",
        damped<Axisymmetric, SimplexMesh<2>, MohrCoulomb<>, Numerics<S, Tpic, Usl>, ViscousDamping>},
       {"plane cubic B-splines FLIP MUSL, guided disc at nodes with gaps, Mohr-Coulomb double",
        pushed<Guided, CartesianGrid<2>, MohrCoulomb<>, Numerics<CubicBSpline, Flip, Musl>>},
       {"triangles FLIP MUSL, prescribed disc at nodes with gaps, Drucker-Prager double",
        pushed<Prescribed, SimplexMesh<2>, DruckerPrager<>, Numerics<S, Flip, Musl>>}},
      110);
}
