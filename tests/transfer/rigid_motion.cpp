// Matter that moves as one is not strained, wherever its points lie: on vertices, edges and faces of cells,
// beside them by round-off, and anywhere else.
#include <arenite/arenite.hpp>
#include <random>

#include "catch.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

LinearElastic rubber() { return LinearElastic{{.density = 1000, .young = 1e6, .poisson = 0.3}}; }

template <int D>
auto cube(double lower, double upper) {
  std::array<double, D> a, b;
  a.fill(lower);
  b.fill(upper);
  return std::pair{a, b};
}
template <class M>
M mesh() {
  constexpr int D = M::dimension;
  const auto [lower, upper] = cube<D>(1, 4);
  if constexpr (is_simplex_mesh<M>) {
    std::array<Index, D> bricks;
    bricks.fill(3);
    return M(box_mesh<D>({lower, upper, bricks}));
  } else if constexpr (is_rectilinear<M>) {
    return M({.x = {1, 1.5, 2.75, 4}, .y = {1, 2, 3.5, 4}});
  } else if constexpr (is_periodic<M>()) {
    return periodic<0>(CartesianGrid<D>({.lower = lower, .upper = upper, .cell = 0.5}));
  } else {
    return M({.lower = lower, .upper = upper, .cell = 1});
  }
}

/// Corners, middles and thirds of what cells are made of, each with a neighbour an ulp aside, and random
/// places.
template <int D>
std::vector<Vec<double, D>> places() {
  std::vector<Vec<double, D>> all;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(1, 4);
  for (const double x : {1.0, 1.5, 2.0, 7.0 / 3, 2.5, 2.75, 3.0, 4.0})
    for (const double y : {1.0, 2.0, 2.5, 8.0 / 3, 3.0, 4.0})
      for (const double z : D == 2 ? std::vector{0.0} : std::vector{1.0, 2.0, 2.5}) {
        const std::array<double, 3> at{x, y, z};
        Vec<double, D> place, beside, anywhere;
        for (int k = 0; k < D; ++k) {
          beside[k] = place[k] = at[static_cast<std::size_t>(k)];
          anywhere[k] = uniform(random);
        }
        const int axis = static_cast<int>(all.size()) % D;
        beside[axis] = std::nextafter(beside[axis], 2.2);
        all.insert(all.end(), {place, beside, anywhere});
      }
  return all;
}

/// Moves points rigidly, from all places, singly and in threes. Largest stress after three steps over
/// E v dt / h.
template <class... B, class Scene>
double stress_in_motion(Scene scene, bool across) {
  constexpr int D = Scene::D;
  using V = Vec<double, D>;
  const auto all = places<D>();
  const double dt = 1e-3;
  double most = 0;
  const auto fly = [&](const std::vector<V>& from, V v) {
    for (int k = 0; k < D; ++k)
      if (from[0][k] > 2.4) v[k] = -v[k];  // into the mesh
    scene.for_each_body([&](auto& body, const auto&) {
      remove_from(scene, body, [](Index) { return true; });
      typename std::remove_cvref_t<decltype(body)>::Point point;
      point.volume = 0.1;
      point.velocity = v;
      for (const V& x : from) {
        point.position = x;
        insert_into(scene, body, std::vector{point});
      }
    });
    for (int n = 0; n < 3; ++n) step(scene, dt);
    scene.for_each_body([&](const auto& body, const auto&) {
      for (std::size_t p = 0; p < body.points.size(); ++p)
        for (std::size_t c = 0; c < Sym<double, D>::size; ++c) {
          const double stress = std::abs(body.points.stress[p][c]) / (1e6 * dt);
          if (!(stress <= most)) most = stress;
        }
    });
  };
  V along = V::Zero(), slanted = V::Zero();
  along[1] = 1;
  slanted[0] = across ? 0.5 : 0, slanted[1] = 1;
  if constexpr (D == 3) slanted[2] = 0.25;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::vector<V> three{all[k], all[(k + 3) % all.size()], all[(7 * k + 1) % all.size()]};
    for (const V& v : {along, slanted}) fly({all[k]}, v), fly(three, v);
  }
  return most;
}

template <class K, class M, class N>
struct Composition {
  static double largest_stress() {
    const auto [lower, upper] = cube<M::dimension>(1, 4);
    const Box<std::size_t{M::dimension}> box{lower, upper};
    return stress_in_motion(Scene{K{}, mesh<M>(), N{}, bodies(fill(box, rubber(), {.per_cell = 1}))},
                            !K::hoop);
  }
};

using Grid = CartesianGrid<2>;
using Triangles = SimplexMesh<2>;
using Tetrahedra = SimplexMesh<3>;
template <class Shape, class Transfer, class Order, class M = Grid>
using Flat = Composition<PlaneStrain, M, Numerics<Shape, Transfer, Order>>;
template <class Shape, class Transfer, class Order, class M = Grid>
using Round = Composition<Axisymmetric, M, Numerics<Shape, Transfer, Order>>;
template <class Shape, class Transfer, class Order, class M = Tetrahedra>
using Solid = Composition<ThreeDimensional, M, Numerics<Shape, Transfer, Order>>;

}  // namespace

TEMPLATE_TEST_CASE("Linear functions: material that moves as one is not strained, wherever its points lie",
                   "", (Flat<LinearSimplex, Flip, Usl, Triangles>),
                   (Flat<LinearSimplex, Flip, Musl, Triangles>), (Flat<LinearSimplex, Flip, Usf, Triangles>),
                   (Flat<LinearSimplex, Tpic, Musl, Triangles>), (Flat<LinearSimplex, Xpic, Musl, Triangles>),
                   (Round<LinearSimplex, Fmpm, Usl, Triangles>),
                   (Composition<PlaneStrain, Triangles, Numerics<LinearSimplex, Flip, Musl, NodalAveraging>>),
                   (Solid<LinearSimplex, Flip, Usl>), (Flat<LinearGrid, Flip, Usl>),
                   (Flat<LinearGrid, Apic, Musl>), (Flat<LinearGrid, Aflip, Usf>),
                   (Round<LinearGrid, Xpic, Musl>), (Flat<LinearGrid, Flip, Usl, RectilinearGrid<2>>),
                   (Flat<LinearGrid, Flip, Musl, PeriodicGrid<Grid, 1>>),
                   (Solid<LinearGrid, Flip, Musl, CartesianGrid<3>>)) {
  CHECK(TestType::largest_stress() <= 1e-12);
}

TEMPLATE_TEST_CASE("Smooth functions: material that moves as one is not strained, wherever its points lie",
                   "", (Flat<QuadraticBSpline, Apic, Usl>), (Flat<QuadraticBSpline, Flip, Musl>),
                   (Flat<QuadraticBSpline, Flip, Usf, RectilinearGrid<2>>),
                   (Round<CubicBSpline, Flip, Usl, PeriodicGrid<Grid, 1>>), (Flat<CubicBSpline, Apic, Musl>),
                   (Flat<UGimp<2>, Aflip, Usl>), (Flat<UGimp<2>, Fmpm, Musl>)) {
  CHECK(TestType::largest_stress() <= 1e-12);
}

TEST_CASE("Two fields: bodies that move as one are not strained, wherever their points lie") {
  const Box<2> left{{1., 1.}, {2., 4.}}, right{{2., 1.}, {4., 4.}};
  Scene scene{
      PlaneStrain{}, mesh<Triangles>(), Numerics<LinearSimplex, Flip, Usl>{},
      bodies(fill<"left">(left, rubber(), {.per_cell = 4}), fill<"right">(right, rubber(), {.per_cell = 4})),
      Coulomb{Friction(0.3)}};
  CHECK(stress_in_motion(std::move(scene), true) <= 1e-12);
}

TEST_CASE("Nodes without mass: a point on a vertex feels the walls that one beside it feels") {
  const auto stress_at = [](Vec<double, 2> x) {
    Scene scene{PlaneStrain{}, mesh<Grid>(), Numerics<LinearGrid, Flip, Usl>{},
                bodies(fill(Box<2>{{2., 2.}, {3., 3.}}, rubber(), {.per_cell = 4})), walls(top(fixed))};
    remove_points(scene, [](const auto&) { return true; });
    insert_points(scene, {{.position = x, .velocity = {0.5, 1}, .volume = 0.1}});
    step(scene, 1e-4);
    return scene.body().points.stress[0];
  };
  const auto on = stress_at({2, 3}), beside = stress_at({2 + 1e-6, 3 + 1e-6});
  CHECK(beside[1] < -100);
  for (std::size_t k = 0; k < on.size; ++k) CHECK(std::abs(on[k] - beside[k]) <= 1e-3 * std::abs(beside[1]));
}

TEMPLATE_TEST_CASE("Nodes without mass: points at rest on a wall stay at rest under gravity", "",
                   (Numerics<LinearSimplex, Flip, Usl>), (Numerics<LinearSimplex, Flip, Musl>),
                   (Numerics<LinearSimplex, Flip, Usf>)) {
  Scene scene{PlaneStrain{},
              mesh<Triangles>(),
              TestType{},
              bodies(fill(Box<2>{{1., 1.}, {4., 2.}}, rubber(), {.per_cell = 4})),
              walls(bottom(roller)),
              gravity({0, -10})};
  auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p)
    points.position.set(p, {1.25 + 0.5 * static_cast<double>(p), 1});
  for (int n = 0; n < 10; ++n) step(scene, 1e-3);
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs(points.stress[p][k]) <= 1e-6);
}

TEMPLATE_TEST_CASE(
    "Nodes without mass: a body whose points lie on vertices makes no energy, and keeps momentum", "",
    (Numerics<LinearGrid, Flip, Usl>), (Numerics<LinearGrid, Flip, Musl>),
    (Numerics<LinearGrid, Apic, Usl>)) {
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}}, TestType{},
              bodies(fill(Box<2>{{0.3, 0.4}, {0.8, 0.7}}, rubber(), {.per_cell = 1})), TrackEnergy{}};
  auto& points = scene.body().points;
  Vec<double, 2> before = Vec<double, 2>::Zero(), after = before;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vec<double, 2> x = points.position[p];
    points.position.set(p, {x[0] + 0.05, x[1] + 0.05});
    points.velocity.set(p, {x[0] - 0.5, 0.3});
    before += points.mass[p] * points.velocity[p];
  }
  auto& track = scene.template part<TrackEnergy>();
  track.initial_kinetic = kinetic_energy(scene.body());
  double gain = 0;
  for (int n = 0; n < 200; ++n) {
    const double work = track.stress_work;
    step(scene, stable_step(scene));
    gain = std::max(gain, energies(scene).residual - (track.stress_work - work) / 2);
  }
  for (std::size_t p = 0; p < points.size(); ++p) after += points.mass[p] * points.velocity[p];
  CHECK(gain <= 0.02 * track.initial_kinetic);
  CHECK((after - before).norm() <= 1e-12 * before.norm());
}
