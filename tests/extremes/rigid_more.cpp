// Random scenes of free rigid bodies that touch points, and one another with matter between: see runner.hpp.
#include "one_body.hpp"

using namespace arenite;
using namespace arenite::extremes;

namespace {

using B = QuadraticBSpline;

/// A disc, m.
struct DistanceToDisc {
  Vec<double, 2> centre;
  double radius;
  double operator()(const Vec<double, 2>& x) const { return (x - centre).norm() - radius; }
};

/// A body of so much area that moves and spins.
Free free_body(Draw& d, double area, double inertia, const Vec<double, 2>& centre, double sign) {
  const Vec<double, 2> v = d.speed * (0.3 * d.random.direction<2>() - sign * Vec<double, 2>::Unit(1));
  const double mass = d.density * d.contrast * area;
  return {.mass = mass,
          .inertia = mass * inertia,
          .centre = {centre[0], centre[1], 0},
          .velocity = {v[0], v[1], 0},
          .spin = {0, 0, d.random.chance(0.5) ? 0 : d.random.uniform(-2, 2) * d.speed / d.cell / 10}};
}

/// A disc above the body that touches its points.
template <class M, class L, class N>
Outcome disc(Draw& d) {
  return one_body_with<PlaneStrain, M, L, N>(d, [&](const M& mesh) {
    const double size = extent(mesh), radius = d.random.uniform(0.05, 0.15) * size;
    const Blob matter = blob<2>(d, size);
    const Vec<double, 2> centre(d.random.uniform(0.35, 0.65) * size,
                                matter.upper[1] + radius * d.random.uniform(1, 1.3));
    return std::tuple(walls_of<2>(d), rigid(DistanceSurface{DistanceToDisc{centre, radius}},
                                            free_body(d, pi * square(radius), square(radius) / 2, centre, 1),
                                            Friction(d.contact_friction), PointContact{}));
  });
}

/// Matter between a lower plate, an upper one and a post beside it that both may touch.
template <class M, class L, class N>
Outcome plates(Draw& d) {
  if (d.layout == Layout::floor) {
    d.layout = Layout::boxed;
    d.k0 = -1;
  }
  return one_body_with<PlaneStrain, M, L, N>(d, [&](const M& mesh) {
    const double size = extent(mesh), gap = d.random.uniform(0, 0.05);
    const Friction friction(d.contact_friction);
    const auto plate = [&]<Name name>(Vec<double, 2> centre, double width, double height, double sign) {
      centre *= size;
      width *= size;
      height *= size;
      return rigid<name>(DistanceSurface{Box{{centre[0] - width / 2, centre[1] - height / 2},
                                             {centre[0] + width / 2, centre[1] + height / 2}}},
                         free_body(d, width * height, (square(width) + square(height)) / 12, centre, sign),
                         friction);
    };
    using V = Vec<double, 2>;
    return std::tuple(walls_of<2>(d), plate.template operator()<"lower">(V(0.55, 0.24 - gap), 0.7, 0.1, -1),
                      plate.template operator()<"upper">(V(0.55, 0.76 + gap), 0.7, 0.1, 1),
                      plate.template operator()<"post">(V(0.81, 0.5), 0.1, 0.42, 0),
                      RigidContact{Friction(d.random.uniform(0, 1))});
  });
}

}  // namespace

TEST_CASE("Random scenes with free rigid bodies end sound, or say when and why not") {
  run_scenes("rigid_more",
             {{"plane B-splines APIC USL, free disc touches points, Mohr-Coulomb double",
               disc<CartesianGrid<2>, MohrCoulomb<>, Numerics<B, Apic, Usl>>},
              {"plane B-splines FLIP MUSL, elastic between rigid bodies in contact double",
               plates<CartesianGrid<2>, LinearElastic, Numerics<B, Flip, Musl>>},
              {"triangles FLIP USL, free disc touches points, elastic float",
               disc<SimplexMesh<2, float>, LinearElastic, Numerics<LinearSimplex, Flip, Usl>>}},
             100);
}
