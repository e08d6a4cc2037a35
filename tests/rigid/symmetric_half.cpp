// A free body of which a scene models one half, cut by a plane of symmetry, beside the whole: a law of nature, to round-off.
#include <arenite/arenite.hpp>

#include "catch.hpp"
#include "message.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

/// A tilted capsule falls on a block; `axis`: normal of the plane of symmetry. Linear functions, PIC and a block that stays
/// within its cells: splines, the share of FLIP and nodes with hardly any mass are not the same at a face of the grid as inside.
template <bool half>
auto scene_of(int axis) {
  const std::size_t across = static_cast<std::size_t>(axis), along = axis == 2 ? 0 : 2;
  const LinearElastic block{{.density = 1540, .young = 1_MPa, .poisson = 0.3}};
  std::array<double, 3> low{-0.12, 0, -0.12}, high{0.12, 0.24, 0.12}, a{}, b{}, spin{};
  if (half) low[across] = 0;
  a[1] = 0.21, b[1] = 0.18;
  a[along] = -0.02, b[along] = 0.05;
  spin[across] = 3;
  std::array<double, 3> centre{}, velocity{0, -2, 0};
  for (std::size_t k = 0; k < 3; ++k) centre[k] = (a[k] + b[k]) / 2;
  velocity[along] = 0.5;
  auto block_high = high;
  block_high[1] = 0.12;
  const double share = half ? 0.5 : 1;
  std::array<double, 3> pull{}, moment{};
  pull[along] = 0.3 * share;
  moment[across] = 0.01 * share;
  return Scene{ThreeDimensional{},
               CartesianGrid<3>{{.lower = low, .upper = high, .cell = 0.02}},
               Numerics<LinearGrid, Flip, Usl>{.transfer = Flip{.fraction = 0}},
               bodies(fill(Box<3>{low, block_high}, block, {.per_cell = 8})),
               walls(bottom(fixed), left(roller), right(roller), front(roller), back(roller)),
               gravity({0, -9.81, 0}),
               rigid(DistanceSurface{Capsule(a, b, 0.04)},
                     Free{.mass = 0.6 * share,
                          .inertia = {4e-4 * share, 5e-4 * share, 6e-4 * share},
                          .centre = centre,
                          .velocity = velocity,
                          .spin = spin,
                          .anchor = {.stiffness = {20 * share, 0, 20 * share},
                                     .rotational_damping = {1e-3 * share, 1e-3 * share, 1e-3 * share}},
                          .force = VectorFunction{pull[0], pull[1], pull[2]},
                          .moment = VectorFunction{moment[0], moment[1], moment[2]},
                          .symmetry = half ? axis : -1},
                     Friction(20_deg)),
               TrackEnergy{}};
}

template <class S>
auto state_of(const S& scene) {
  const auto& body = scene.template rigid<0>();
  std::vector<double> all;
  for (int k = 0; k < 3; ++k) {
    all.push_back(body.displacement[k]);
    all.push_back(body.velocity[k]);
    all.push_back(body.spin[k]);
    all.push_back(body.orientation.matrix()(k, 0));
  }
  return all;
}

}  // namespace

TEST_CASE("One half of a body, free in its plane of symmetry, goes the way of the whole") {
  const int axis = GENERATE(0, 2);
  CAPTURE(axis);
  auto half = scene_of<true>(axis);
  auto whole = scene_of<false>(axis);
  bool beside = false;  // whether a node pushed that the other half has, too
  for (int k = 0; k < 250; ++k) {
    const double dt = 0.4 * std::min(stable_step(half), stable_step(whole));
    step(half, dt);
    step(whole, dt);
    for (const auto& touch : half.rigid<0>().touched_nodes)
      beside = beside || (touch.impulse.norm() > 0 && touch.arm[axis] > 0.01);
  }
  REQUIRE(beside);
  REQUIRE(std::abs(half.rigid<0>().spin[axis] - 3) > 0.5);  // the block has turned it
  const auto a = state_of(half), b = state_of(whole);
  for (std::size_t k = 0; k < a.size(); ++k) {
    CAPTURE(k);
    CHECK(std::abs(a[k] - b[k]) < 1e-9);
  }
  // Constrained components are exactly zero.
  const auto& body = half.rigid<0>();
  for (int k = 0; k < 3; ++k) {
    if (k == axis) CHECK((body.displacement[k] == 0 && body.velocity[k] == 0));
    if (k != axis) CHECK(body.spin[k] == 0);
  }
  const Energies of_half = energies(half), of_whole = energies(whole);
  CHECK(2 * of_half.kinetic == Approx(of_whole.kinetic).epsilon(1e-9));
  CHECK(2 * of_half.external == Approx(of_whole.external).epsilon(1e-9));
  CHECK(2 * of_half.residual == Approx(of_whole.residual).margin(1e-9 * of_whole.kinetic));
}

TEST_CASE("a plane of symmetry that is not the body's is refused") {
  const auto refused = [](Free f) {
    f.mass = 1;
    f.centre = {0, 0, 0};
    return message([&] { BoundFree<double, 3>{f}; });
  };
  const auto body = [](int symmetry) {
    Free f;
    f.inertia = {1, 1, 1};
    f.symmetry = symmetry;
    return f;
  };
  CHECK(refused(body(3)) == "Free.symmetry = 3: must be -1, or in space the axis 0, 1 or 2");
  Free f = body(2);
  f.velocity = {1, 0, 0.1};
  CHECK(refused(f) ==
        "Free.velocity, spin = (1, 0, 0.1), (0, 0, 0): must be in the plane of symmetry, and about its "
        "normal, axis 2");
  f = body(2);
  f.spin = {0, 1, 0};
  CHECK(refused(f).starts_with("Free.velocity, spin = (0, 0, 0), (0, 1, 0): must be in the plane"));
  f = body(0);
  f.inertia = {1, 1, 1, 0.1, 0, 0};
  CHECK(refused(f) == "Free.inertia = 0.1: must have no products with the axis 0 of the plane of symmetry");
  f.inertia = {1, 1, 1, 0, 0.1, 0};
  CHECK(refused(f) == "nothing thrown");
  CHECK(message([&] {
          Free plane = body(2);
          plane.mass = 1;
          plane.centre = {0, 0, 0};
          BoundFree<double, 2>{plane};
        }) == "Free.symmetry = 2: must be -1, or in space the axis 0, 1 or 2");
}
