// Scenes at their limits: one point, points that leave, NaN, bad options, float, stiff beside soft, the full
// Courant step, sand that flies apart and is caught.
#include <arenite/arenite.hpp>
#include <limits>

#include "catch.hpp"
#include "courant.hpp"
#include "meshes.hpp"

using namespace arenite;

namespace {

LinearElastic rubber(double young = 1e6) {
  return LinearElastic{{.density = 1000, .young = young, .poisson = 0.3}};
}
CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}}; }

template <class Scene>
std::string what_of(Scene& scene, const RunOptions& options) {
  try {
    run(scene, options);
  } catch (const error& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("A single point falls freely, exactly", "[limit]") {
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0., 0.5}, {0.5, 1.}}, rubber(), {.per_cell = 1})), gravity({0, -10})};
  REQUIRE(scene.point_count() == 1);
  run(scene, {.end = 0.2});
  CHECK(std::abs(scene.body().points.velocity[0][1] + 2) <= 1e-12);
}

TEST_CASE("Points that leave the mesh are counted with their mass; without any point the run stops",
          "[limit]") {
  const auto check = [](auto scene) {
    const std::size_t all = scene.point_count();
    const double before = mass(scene.body());
    run(scene, {.end = 0.05});
    CHECK(scene.lost_points() > 0);
    CHECK(scene.point_count() > 0);
    CHECK(scene.point_count() + scene.lost_points() == all);
    CHECK(std::abs(mass(scene.body()) + scene.body().lost_mass - before) <= 1e-12 * before);
    CHECK_THROWS_AS(run(scene, {.end = 1, .max_step = 0.01}), run_error);
    CHECK(scene.point_count() == 0);
    CHECK(scene.lost_points() == all);
    CHECK(scene.time < 0.15);
    const std::string what = what_of(scene, {.end = 1, .max_step = 0.01});
    CAPTURE(what);
    CHECK(what.find(joined_text({"t = ", scene.time, " s: all ", all, " points of the scene"})) == 0);
  };
  const FillOptions flies{.per_cell = 4, .velocity = {10, 0, 0}};
  check(Scene{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0.4, 0.4}, {0.7, 0.6}}, rubber(), flies))});
  check(Scene{PlaneStrain{}, SimplexMesh<2>(test::triangles({0, 0}, {1, 1}, 10, 10)),
              Numerics<LinearSimplex, Flip>{},
              bodies(fill(Box{{0.4, 0.4}, {0.7, 0.6}}, rubber(), {.per_cell = 3, .velocity = {10, 0, 0}}))});
}

TEST_CASE("Of two bodies one may leave the mesh: one warning, and the other continues") {
  Scene scene{
      PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Apic>{},
      bodies(fill<"stays">(Box{{0., 0.}, {0.3, 0.3}}, rubber()),
             fill<"leaves">(Box{{0.7, 0.7}, {0.9, 0.9}}, rubber(), {.per_cell = 4, .velocity = {10, 0, 0}}))};
  std::vector<std::string> said;
  const WarningHook old = on_warning([&](const std::string& text) { said.push_back(text); });
  run(scene, {.end = 0.1, .watch = false});
  on_warning(old);
  CHECK(scene.body<"leaves">().points.size() == 0);
  CHECK(scene.body<"stays">().points.size() > 0);
  REQUIRE(said.size() == 1);
  CHECK(said[0].find("all points of body leaves have left the mesh") != std::string::npos);
}

TEST_CASE("Bad options of a run name the option and the rule") {
  Scene scene{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0., 0.}, {1., 0.5}}, rubber()))};
  CHECK(what_of(scene, {}).find("RunOptions.end") == 0);
  CHECK(what_of(scene, {.end = -1}).find("RunOptions.end = -1: must not lie before") == 0);
  CHECK(what_of(scene, {.end = 1, .courant = 0}).find("RunOptions.courant = 0: must be positive") == 0);
  CHECK(what_of(scene, {.end = 1, .courant = std::nan("")}).find("RunOptions.courant") == 0);
  CHECK(what_of(scene, {.end = 1, .courant = 5}).find("RunOptions.courant = 5: must be at most 1") == 0);
  CHECK(what_of(scene, {.end = 1, .max_step = -1}).find("RunOptions.max_step = -1") == 0);
  CHECK(scene.steps == 0);
  CHECK(what_of(scene, {.end = 0}).empty());
}

TEST_CASE("A NaN stops the run at its step with time, body and point", "[limit]") {
  Scene scene{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0., 0.}, {1., 0.5}}, rubber()))};
  run(scene, {.end = 0.01});
  const std::size_t steps = scene.steps;
  scene.body().points.velocity.column(1)[37] = std::numeric_limits<double>::quiet_NaN();
  const std::string what = what_of(scene, {.end = 0.02});
  CAPTURE(what);
  CHECK(what.find("t = 0.01") == 0);
  CHECK(what.find(joined_text({"step ", steps + 1})) != std::string::npos);
  CHECK(what.find("of body 0 at (") != std::string::npos);
  CHECK(scene.steps == steps + 1);
}

TEST_CASE("Sums that are not finite stop the run even where every number of every point is", "[limit]") {
  Scene scene{PlaneStrain{}, grid(), Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0., 0.}, {1., 0.5}}, rubber()))};
  step(scene, 1e-5);
  scene.finite = scene.body().finite = false;
  std::string what;
  try {
    finish(scene, 1e-5);
  } catch (const run_error& e) {
    what = e.what();
  }
  CHECK(what.find("step 2: the sums of stress and volume over the points of body 0 are not finite") !=
        std::string::npos);
}

namespace {

/// p = K (1 - J) / J, with J as history: 1 at the start, and 0 would not be finite.
class Gas {
 public:
  template <class T>
  struct History {
    T ratio{1};  // V / V0, -
    auto members() { return std::tie(ratio); }
    auto members() const { return std::tie(ratio); }
  };
  double density() const { return 1; }
  double wave_modulus() const { return 1e4; }
  template <class T, int D>
  T update(Sym<T, D>& stress, const StrainStep<T, D>& step, History<T>& history) const {
    history.ratio = history.ratio * (T(1) + trace(step.strain));
    stress = add_isotropic(Sym<T, D>{}, T(T(1e4) * (history.ratio - T(1)) / history.ratio));
    return T(0);
  }
  template <class T, int D>
  T elastic_energy(const Sym<T, D>&) const {
    return T(0);
  }
};

}  // namespace

TEST_CASE("Lanes without a point stay out of the sums, whatever a law's history begins with") {
  // Nine points: one more than a power of two, so that packs of any width have lanes left over.
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0., 0.5}, {0.5, 1.}}, Gas{}, {.per_cell = 9})), gravity({0, -10})};
  REQUIRE(scene.point_count() == 9);
  step(scene, 1e-3);
  CHECK(scene.finite);
  CHECK(scene.body().opened_volume == 0);
}

TEST_CASE("Float follows double", "[limit]") {
  const auto fall = [](auto g) {
    Scene scene{PlaneStrain{},
                g,
                Numerics<QuadraticBSpline, Apic>{},
                bodies(fill(Box{{0., 0.}, {0.5, 0.8}}, rubber(1e5), {.per_cell = 4})),
                walls(bottom(fixed), left(roller)),
                gravity({0, -9.81})};
    run(scene, {.end = 0.1, .courant = 1, .max_step = 1e-3});
    double height = 0;
    for (const auto& x : scene.body().points.position) height += static_cast<double>(x[1]);
    return height / static_cast<double>(scene.point_count());
  };
  const double exact = fall(CartesianGrid<2, double>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}});
  const double rounded = fall(CartesianGrid<2, float>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}});
  CHECK(std::abs(exact - 0.4) > 1e-3);  // it has settled
  CHECK(std::abs(rounded - exact) <= 1e-3 * std::abs(exact - 0.4));
}

TEST_CASE("A stiff body on one a million times softer, at once", "[limit]") {
  Scene scene{
      PlaneStrain{},
      grid(),
      Numerics<QuadraticBSpline, Apic>{},
      bodies(fill(Box{{0., 0.}, {1., 0.5}}, rubber(1e4)), fill(Box{{0.3, 0.5}, {0.7, 0.7}}, rubber(1e10))),
      walls(bottom(fixed), left(roller), right(roller)),
      gravity({0, -10})};
  run(scene, {.end = 5e-4, .courant = test::courant(scene, 0.5)});
  CHECK(scene.lost_points() == 0);
  for (const auto& v : scene.body<1>().points.velocity) {
    REQUIRE(v.norm() <= 10 * 5e-4 * 1.01);
    REQUIRE(std::abs(v[0]) <= 1e-3 * 10 * 5e-4);
  }
}

TEST_CASE("Courant number 1: an elastic body on splines still swings, with no energy gained", "[limit]") {
  Scene scene{PlaneStrain{},
              grid(),
              Numerics<QuadraticBSpline, Apic, Usl>{},
              bodies(fill(Box{{0., 0.}, {1., 0.5}}, rubber(), {.per_cell = 4})),
              walls(bottom(fixed), left(roller), right(roller)),
              gravity({0, -9.81}),
              TrackEnergy{}};
  run(scene, {.end = 1, .courant = 1});
  const Energies e = energies(scene);
  CHECK(e.residual <= 0.01 * std::abs(e.external));
}

namespace {

/// A layer thrown up, the higher the faster, so that it is stretched to over twice its height before it falls
/// back. Returns its greatest height at rest, m.
template <class Law>
double throw_and_catch(const Law& law) {
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.5, 1.5}, .cell = 0.05}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0., 0.}, {0.5, 0.3}}, law, {.per_cell = 4})),
              walls(bottom(roller), left(roller), right(roller)),
              gravity({0, -9.81}),
              TrackEnergy{}};
  auto& body = scene.body();
  for (std::size_t p = 0; p < body.points.size(); ++p)
    body.points.velocity.column(1)[p] = 10 * body.points.position[p][1];
  double highest = 0;
  const double energy = kinetic_energy(body);
  run(scene, {.end = 1.5, .courant = test::courant(scene, 0.5)}, [&](const auto& s) {
    for (const auto& x : body.points.position) highest = std::max(highest, x[1]);
    REQUIRE(kinetic_energy(body) + strain_energy(body) <=
            energy * 1.01 + s.template part<TrackEnergy>().gravity_work);
  });
  CHECK(highest > 0.6);
  CHECK(scene.lost_points() == 0);
  double volume = 0, top = 0, speed = 0;
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    volume += body.points.volume[p];
    top = std::max(top, body.points.position[p][1]);
    speed = std::max(speed, body.points.velocity[p].norm());
  }
  CAPTURE(volume / body.initial_volume, top, speed, mean_volume_ratio(body));
  CHECK(volume / body.initial_volume <= 1.001);
  CHECK(volume / body.initial_volume >= 0.98);
  CHECK(speed <= 0.1);
  return top;
}

constexpr MohrCoulombParameters sand{
    .density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35 * pi / 180};

}  // namespace

TEST_CASE("Sand thrown apart and caught again does not blow up: stress comes back, swollen volume does not",
          "[limit]") {
  // Without memory it carries stress as soon as it is compressed: it rests stretched. With memory it closes
  // first.
  const double forgets = throw_and_catch(MohrCoulomb{sand}),
               remembers = throw_and_catch(MohrCoulomb<RemembersOpening>{sand});
  CHECK(forgets <= 0.7);
  CHECK(remembers <= 0.75 * forgets);
}
