// Frictional walls: a block slides down an incline (gravity is tilted instead) or stays, against closed
// forms.
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>

#include "catch.hpp"
#include "state_buffer.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

const LinearElastic rubber{{.density = 1000, .young = 1e7, .poisson = 0.3}};
constexpr double g = 9.81, h = 0.05, height = 0.1;
const Friction friction(20_deg);

/// Stress (xx, yy, zz, xy), Pa, of a wide block on a slope that rests or slides steadily.
auto steady(double slope) {
  return [=](const std::array<double, 3>& x) {
    const double above = rubber.density() * g * (height - x[1]),
                 shear = std::min(std::sin(slope), friction.coefficient() * std::cos(slope));
    return std::array<double, 6>{0, -above * std::cos(slope), 0, above * shear};
  };
}

template <class M, class N>
auto block(M mesh, N numerics, double slope, std::array<double, 3> velocity = {},
           const FrictionalWallOptions& options = {}, double start = 0.3) {
  return Scene{
      PlaneStrain{},
      std::move(mesh),
      numerics,
      bodies(fill(Box{{start, 0.}, {start + 0.4, height}}, rubber,
                  {.per_cell = is_simplex_mesh<M> ? 6 : 4, .velocity = velocity, .stress = steady(slope)})),
      frictional(bottom(), friction, options),
      frictional(left(), friction),
      gravity({g * std::sin(slope), -g * std::cos(slope)}),
      Reactions{},
      TrackEnergy{}};
}
CartesianGrid<2> grid() { return CartesianGrid<2>{{.lower = {0, 0}, .upper = {1.6, 0.4}, .cell = h}}; }
auto on_grid(auto... a) { return block(grid(), Numerics<QuadraticBSpline, Apic, Usl>{}, a...); }
auto on_triangles(auto... a) {
  return block(SimplexMesh<2>(box_mesh<2>({{0, 0}, {1.6, 0.4}, {32, 8}})), Numerics<LinearSimplex>{}, a...);
}

Vec<double, 2> centre(const auto& scene) {
  Vec<double, 2> sum = Vec<double, 2>::Zero();
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) sum += points.mass[p] * points.position[p];
  return sum / mass(scene.body());
}

}  // namespace

TEST_CASE("A block slides down an incline with g (sin a - mu cos a), and stays below the angle of friction") {
  test::Validation validation("incline");
  const auto check = [&](const std::string& name, auto&& make) {
    for (const double degrees : {10.0, 15.0, 25.0, 45.0}) {
      INFO(name << ", " << degrees << " deg");
      const double slope = degrees * pi / 180, end = 0.3;
      auto scene = make(slope);
      const double start = centre(scene)[0], weight = mass(scene.body()) * g;
      run(scene, {.end = end, .courant = 0.5});
      const double pull = std::sin(slope) - friction.coefficient() * std::cos(slope);
      const double travel = pull > 0 ? g * pull * end * end / 2 : 0, moved = centre(scene)[0] - start;
      const auto floor = reaction(scene, "bottom").impulse;
      const Energies e = energies(scene);
      if (travel > 0) {
        CHECK(std::abs(moved / travel - 1) <= 0.005);
        CHECK(std::abs(-floor[0] / floor[1] / friction.coefficient() - 1) <= 0.02);
        CHECK(std::abs(e.contact / (friction.coefficient() * weight * std::cos(slope) * travel) - 1) <= 0.05);
      } else {
        CHECK(std::abs(moved) <= 1e-3 * g * std::sin(slope) * end * end / 2);
        CHECK(std::abs(-floor[0] / (weight * std::sin(slope) * end) - 1) <= 0.01);
      }
      CHECK(std::abs(floor[1] / (weight * std::cos(slope) * end) - 1) <= 0.01);
      CHECK(std::abs(e.residual) <= 0.02 * e.external + 1e-6 * weight * height);
      // The impulse of the walls is the momentum minus the impulse of gravity, to round-off.
      const Vec<double, 2> given = weight * scene.time * Vec<double, 2>(std::sin(slope), -std::cos(slope));
      CHECK((momentum(scene.body()) - given - floor - reaction(scene, "left").impulse).norm() <=
            1e-11 * given.norm());
      validation.value(name, joined_text({"travel at ", degrees, " deg"}), "m", moved, travel);
    }
  };
  check("B-splines; APIC; USL", [](double slope) { return on_grid(slope); });
  check("triangles; FLIP; MUSL", [](double slope) { return on_triangles(slope); });
}

TEST_CASE("Material leaves a frictional wall unless it adheres, and touches two walls at a corner") {
  const auto check = [](auto&& make) {
    auto parts = make(0.0, std::array<double, 3>{0, 1, 0}, FrictionalWallOptions{}),
         held = make(0.0, std::array<double, 3>{0, 1, 0}, FrictionalWallOptions{.separates = false});
    run(parts, {.end = 0.1, .courant = 0.5});
    run(held, {.end = 0.1, .courant = 0.5});
    CHECK(centre(parts)[1] > height / 2 + 0.7 * (0.1 - g * 0.005));
    CHECK(std::abs(centre(held)[1] - height / 2) <= 0.02);
    // Thrown into the corner of two walls it stays in the mesh.
    auto corner = make(0.0, std::array<double, 3>{-1, -1, 0}, FrictionalWallOptions{}, 0.0);
    run(corner, {.end = 0.05, .courant = 0.1});  // the balance of an impact is of the step's order
    CHECK(corner.lost_points() == 0);
    CHECK(reaction(corner, "left").impulse[0] > 0);
    CHECK(energies(corner).contact > 0);
    CHECK(energies(corner).residual <= 0.01 * mass(corner.body()));
  };
  check([](auto... a) { return on_grid(a...); });
  check([](auto... a) { return on_triangles(a...); });
}

TEST_CASE("Frictional walls: the same bits on any number of threads and after a restored state") {
  const int before = threads();
  const auto state = [](int n) {
    set_threads(n);
    auto scene = on_triangles(0.4);
    for (int k = 0; k < 30; ++k) step(scene, 1e-4);
    return test::StateBuffer(scene);
  };
  const auto one = state(1);
  for (const int n : {2, 3}) CHECK(test::StateBuffer::first_difference(state(n), one) == "");
  set_threads(before);
  auto a = on_triangles(0.4), b = on_triangles(0.4);
  one.restore(a);
  one.restore(b);
  for (int k = 0; k < 10; ++k) step(a, 1e-4), step(b, 1e-4);
  CHECK(test::StateBuffer::first_difference(test::StateBuffer(a), test::StateBuffer(b)) == "");
  CHECK(energies(a).contact == energies(b).contact);
}
