// A beam is as stiff as its points: the second moment of n of them across it is 1 - 1 / n^2 of the section's.
#include <arenite/arenite.hpp>

#include "catch.hpp"

using namespace arenite;

namespace {

constexpr double length = 1, thickness = length / 6, cell = thickness / 2;

/// How far the tip of a cantilever, two cells thick, comes down under a weight of q L^3 / (E I) = 0.02, over what a Timoshenko beam does
/// (nu = 0, shear coefficient 5 / 6).
template <class N>
double fall(int per_axis) {
  const double weight = 0.02, density = 1000, gravity_ = 10;
  const double young = 12 * density * gravity_ * length * square(length / thickness) / weight;
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, -3 * cell}, .upper = {14 * cell, 3 * cell}, .cell = cell}},
              N{},
              bodies(fill(Box{{0, -thickness / 2}, {length, thickness / 2}},
                          LinearElastic{{.density = density, .young = young, .poisson = 0}},
                          {.per_cell = per_axis * per_axis})),
              walls(left(fixed)),
              gravity({0, -gravity_}),
              LocalDamping{.factor = 0.2}};
  const auto& points = scene.body().points;
  const auto height = [&] {  // of the outermost column of points
    double sum = 0;
    int count = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
      if (points.position[p][0] > length - cell / per_axis) sum += points.position[p][1], ++count;
    return sum / count;
  };
  const double before = height(), x = 1 - cell / (2 * per_axis);
  settle(scene, {.end = 100, .courant = 0.5});
  const double bent = weight * (square(x) * (6 - 4 * x + square(x))) / 24,
               sheared = weight * square(thickness / length) / 5 * (x - square(x) / 2);
  return (before - height()) / (bent + sheared) / length;
}

}  // namespace

TEST_CASE("A beam is as stiff as the second moment of its points") {
  for (const int per_axis : {2, 3}) {
    CAPTURE(per_axis);
    const double of_points = 1 / (1 - 1 / square(2.0 * per_axis));
    CHECK(fall<Numerics<QuadraticBSpline, Flip, Musl>>(per_axis) == Approx(of_points).epsilon(0.01));
    CHECK(fall<Numerics<QuadraticBSpline, Apic, Usl>>(per_axis) == Approx(of_points).epsilon(0.01));
    CHECK(fall<Numerics<QuadraticBSpline, Apic, MidpointStrain<Usl>>>(per_axis) ==
          Approx(of_points).epsilon(0.01));
  }
}
