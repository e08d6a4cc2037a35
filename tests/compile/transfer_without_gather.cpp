// must print: Numerics: the transfer lacks a member:
// errors: 1
// A transfer of a user's own whose points gather nothing.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Deaf {
  static constexpr bool affine = false;
  template <class Shape>
  static constexpr bool fits = true;
  template <class Point>
  auto particle_field(const Point& p) const {
    return VelocityField{p.velocity()};
  }
};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline, Deaf>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel))};
  run(scene, {.end = 1});
}
