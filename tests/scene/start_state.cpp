// Scenes in which nothing reads the velocity at the start of the step nor the forces of the nodes: they sum
// both as one momentum, and run as those that keep them apart.
#include <arenite/arenite.hpp>

#include "catch.hpp"

using namespace arenite;

namespace {

/// A part that may read what it likes, and reads nothing.
struct Reader {
  template <class Scene>
  double stable_step(const Scene&) const {
    return std::numeric_limits<double>::infinity();
  }
};

const LinearElastic rubber{{.density = 1000, .young = 1e6, .poisson = 0.3}};
using Affine = Numerics<QuadraticBSpline, Apic, Usl>;
CartesianGrid<2> square() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.1}}; }
CartesianGrid<3> cube() {
  return CartesianGrid<3>{{.lower = {0, 0, 0}, .upper = {0.6, 0.6, 0.6}, .cell = 0.1}};
}

/// A block that stands on the floor of the grid, pushed down and to the side.
template <class N, class K, class M, class... Parts>
auto block(K kinematics, const M& grid, Parts... parts) {
  Box<M::dimension> box;
  box.lower.fill(0.1);
  box.upper.fill(0.4);
  box.lower[1] = 0;
  return Scene{kinematics,
               grid,
               N{},
               bodies(fill(box, rubber, {.per_cell = M::dimension == 2 ? 4 : 8, .velocity = {0.1, -0.5, 0}})),
               walls(bottom(fixed), right(roller)),
               driven(left(roller), {0.05, 0, 0}),
               gravity(Triple{0, -9.81, 0}),
               Reactions{},
               parts...};
}

template <class Points>
double difference(const Points& a, const Points& b) {
  std::vector<double> numbers, sizes;
  a.for_each_column([&](const auto& column) {
    double size = 0;
    for (const auto value : column) size = std::max(size, std::abs(static_cast<double>(value)));
    for (const auto value : column) {
      numbers.push_back(static_cast<double>(value));
      sizes.push_back(size > 0 ? size : 1);
    }
  });
  double worst = 0;
  std::size_t k = 0;
  b.for_each_column([&](const auto& column) {
    for (const auto value : column) {
      worst = std::max(worst, std::abs(static_cast<double>(value) - numbers[k]) / sizes[k]);
      ++k;
    }
  });
  return worst;
}

/// Runs both, and compares points, energies and reactions.
template <class One, class Apart>
void check_equal(One one, Apart apart) {
  STATIC_REQUIRE(!One::has_start_state);
  STATIC_REQUIRE(Apart::has_start_state);
  const RunOptions options{.end = 0.05, .courant = 0.5};
  run(one, options);
  run(apart, options);
  REQUIRE(one.steps > 40);
  CHECK(difference(one.body().points, apart.body().points) <= 1e-12);
  const double kinetic = kinetic_energy(apart.body()), strain = strain_energy(apart.body());
  CHECK(std::abs(kinetic_energy(one.body()) - kinetic) <= 1e-12 * (kinetic + strain));
  CHECK(std::abs(strain_energy(one.body()) - strain) <= 1e-12 * (kinetic + strain));
  const auto floor = reaction(one, "bottom"), same = reaction(apart, "bottom");
  CHECK((floor.impulse - same.impulse).norm() <= 1e-12 * same.impulse.norm());
  CHECK(same.impulse.norm() > 0);
}

}  // namespace

TEST_CASE("Momentum and forces summed as one move the points as sums apart do, with the same energies") {
  check_equal(block<Affine>(PlaneStrain{}, square()), block<Affine>(PlaneStrain{}, square(), Reader{}));
  using MappedBack = Numerics<QuadraticBSpline, Apic, Musl>;
  check_equal(block<MappedBack>(Axisymmetric{}, square()),
              block<MappedBack>(Axisymmetric{}, square(), Reader{}));
  check_equal(block<Affine>(ThreeDimensional{}, cube()), block<Affine>(ThreeDimensional{}, cube(), Reader{}));
}

TEMPLATE_TEST_CASE(
    "A point exactly on a free face gives its impulse to the node beside it, which has no mass", "", Usl,
    Musl) {
  const CartesianGrid<2> coarse{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.25}};  // exact in binary
  const auto after_a_step = [&](auto... parts) {
    Scene scene{PlaneStrain{},
                coarse,
                Numerics<QuadraticBSpline, Apic, TestType>{},
                bodies(fill(Box{{0.25, 0.25}, {0.5, 0.5}}, rubber, {.per_cell = 1})),
                gravity({0, -9.81}),
                parts...};
    auto& points = scene.body().points;
    points.position.set(0, {0.35, 1.0});
    Sym<double, 2> stress;
    stress[1] = -1e4;
    points.stress.set(0, stress);
    step(scene, 1e-4);
    return scene;
  };
  const auto one = after_a_step();
  const auto apart = after_a_step(Reader{});
  const auto& p = one.body().points;
  const auto& q = apart.body().points;
  CHECK((p.position[0] - q.position[0]).norm() <= 1e-14);
  CHECK((p.velocity[0] - q.velocity[0]).norm() <= 1e-13 * q.velocity[0].norm());
  CHECK(std::abs(p.stress[0](1, 1) - q.stress[0](1, 1)) <= 1e-13 * 1e4);
  CHECK(q.velocity[0].norm() > 0);
  CHECK((TestType::maps_back || std::abs(q.stress[0](1, 1) + 1e4) > 1));  // strained, with USL
}

TEST_CASE("Sums stay apart where the transfer, the order of the step, a part or the shape reads them") {
  const auto filled = bodies(fill(Box{{0.1, 0.1}, {0.4, 0.4}}, rubber));
  const auto keeps = [&](auto numerics, auto... parts) {
    return decltype(Scene{PlaneStrain{}, square(), numerics, filled, parts...})::has_start_state;
  };
  CHECK(!keeps(Affine{}));
  CHECK(!keeps(Numerics<CubicBSpline, Apic, Musl>{}));
  CHECK(keeps(Numerics<LinearGrid, Apic, Usl>{}));
  CHECK(keeps(Numerics<QuadraticBSpline, Flip, Usl>{}));
  CHECK(keeps(Numerics<QuadraticBSpline, Apic, Usf>{}));
  CHECK(keeps(Affine{}, Reader{}));
  CHECK(keeps(Affine{}, LocalDamping{}));
  CHECK(keeps(Affine{}, body_force([](const auto&, double) { return std::array{0.0, -1.0, 0.0}; })));
}
