// Whole steps on equal cells, on the same lines as a rectilinear grid, and round periodic axes: what the
// kinds of grid cost beside each other.
//   --short  20,000 points and fewer steps: whether it works, not how fast it is
#include "scenes.hpp"
#include "whole.hpp"

namespace arenite::bench {
namespace {

/// About `points` points on a grid that `make(lower, upper, h)` gives.
template <int D, class Make>
auto scene_on(Make&& make, double points) {
  constexpr int per_cell = D == 3 ? 8 : 4;
  const double k = std::round(std::pow(points / per_cell, 1.0 / D)), h = 0.02;
  using Kinematics = std::conditional_t<D == 3, ThreeDimensional, PlaneStrain>;
  Box<D> box;
  box.lower.fill(2 * h);
  box.upper.fill((k + 2) * h);
  Scene scene{Kinematics{}, make((k + 4) * h, h), Numerics<QuadraticBSpline, Apic, Usl>{},
              bodies(fill(box, elastic(), {.per_cell = per_cell})), gravity(Triple{0, -9.81, 0})};
  stir(scene, 0.5);
  return scene;
}

template <int D>
CartesianGrid<D> equal(double upper, double h) {
  typename CartesianGrid<D>::Parameters p{.cell = h};
  p.lower.fill(0);
  p.upper.fill(upper);
  return CartesianGrid<D>(p);
}
template <int D>
RectilinearGrid<D> lines(double upper, double h) {
  std::vector<double> at;
  for (double i = 0; i <= std::round(upper / h); ++i) at.push_back(i * h);
  return RectilinearGrid<D>{{.x = at, .y = at, .z = D == 3 ? at : std::vector<double>{}}};
}

template <int D>
void add(const std::string& name, double points, int steps) {
  add_steps("grids/" + name + "/equal", {.steps = steps}, [=] { return scene_on<D>(equal<D>, points); });
  add_steps("grids/" + name + "/rectilinear", {.steps = steps},
            [=] { return scene_on<D>(lines<D>, points); });
  add_steps("grids/" + name + "/periodic", {.steps = steps}, [=] {
    return scene_on<D>([](double upper, double h) { return periodic<0>(equal<D>(upper, h)); }, points);
  });
}

}  // namespace
}  // namespace arenite::bench

int main(int argc, char** argv) {
  using namespace arenite::bench;
  const bool is_short = take_flag(argc, argv, "--short");
  const double points = is_short ? 2e4 : 1e5;
  add<2>("plane", points, is_short ? 10 : 30);
  add<3>("space", points, is_short ? 5 : 20);
  return run_benchmarks(argc, argv);
}
