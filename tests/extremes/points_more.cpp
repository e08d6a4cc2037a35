// Random scenes whose points split, leave and join during the run: see runner.hpp.
#include "one_body.hpp"

using namespace arenite;
using namespace arenite::extremes;

namespace {

/// A part that removes the points in a box and fills it with new ones, once in `every` steps.
struct Renewal {
  static constexpr bool reads_start_state = false;
  Box<2> box;
  FillOptions options;
  std::size_t every;

  template <class Scene>
  void renew_points(Scene& scene) {
    if (scene.steps % every != 0) return;
    remove_points(scene, box);
    insert_points(scene, box, options);
  }
};

Renewal renewal(Draw& d, double size, FillOptions options) {
  options.stress = {};
  const Vec<double, 2> v = d.speed * d.random.direction<2>();
  options.velocity = Triple{v[0], v[1], 0};
  const double x = d.random.uniform(0.3, 0.6) * size, y = d.random.uniform(0.3, 0.6) * size;
  return {Box{{x, y}, {x + 0.2 * size, y + 0.2 * size}}, options,
          static_cast<std::size_t>(10 + d.random.pick(40))};
}
SplitPoints<> splitting(Draw& d) {
  return {{.per_cell = d.random.decades(1, 40)}, static_cast<std::size_t>(1 + d.random.pick(20))};
}

template <class M, class L, class N>
Outcome split(Draw& d) {
  return one_body_with<PlaneStrain, M, L, N>(
      d, [&](const M&) { return std::tuple(walls_of<2>(d), splitting(d)); });
}
template <class M, class L, class N>
Outcome renewed(Draw& d) {
  return one_body_with<PlaneStrain, M, L, N>(d, [&](const M& mesh) {
    return std::tuple(walls_of<2>(d), renewal(d, extent(mesh), fill_options(d, mesh)));
  });
}

using B = QuadraticBSpline;
using S = LinearSimplex;

}  // namespace

TEST_CASE("Random scenes with points that split, leave and join end sound, or say when and why not") {
  run_scenes("points_more",
             {{"plane B-splines FLIP MUSL, points split, Mohr-Coulomb double",
               split<CartesianGrid<2>, MohrCoulomb<>, Numerics<B, Flip, Musl>>},
              {"triangles FLIP USL, points leave and join, elastic double",
               renewed<SimplexMesh<2>, LinearElastic, Numerics<S, Flip, Usl>>},
              {"triangles FLIP MUSL, points split, elastic float",
               split<SimplexMesh<2, float>, LinearElastic, Numerics<S, Flip, Musl>>},
              {"plane B-splines APIC MUSL, points leave and join, Drucker-Prager remembers double",
               renewed<CartesianGrid<2>, DruckerPrager<RemembersOpening>, Numerics<B, Apic, Musl>>}},
             100);
}
