// Contact normals of your own: a block slides down an elastic plane, x = g (sin a - mu cos a) t^2 / 2.
// Normals from the gradients of mass are tilted at the edges of the block, which then hardly moves (0.001 m);
// here the normal is known. The plane lies level, and gravity is tilted.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/extend/own_normals.cpp -o own_normals -pthread && ./own_normals
//   prints: the block has slid 0.1188 m, exact 0.1183 m
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

/// One normal out of the first body of the scene (arenite/contact/normals.hpp). Needs nothing of the mesh.
struct PlaneNormal {
  static constexpr bool needs_mass_gradient = false;
  Vec<double, 2> out;  // unit vector

  // Out of body b, towards body a, at a node; a and b are numbers of the scene's bodies.
  template <class Fields>
  Vec<double, 2> between(const Fields&, std::size_t, std::size_t b, std::size_t) const {
    return b == 0 ? out : Vec<double, 2>(-out);
  }
};

int main() {
  const double slope = 30_deg, friction = 15_deg, g = 9.81, end = 0.3;
  const LinearElastic rock{{.density = 2000, .young = 20_MPa, .poisson = 0.2}};
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 0.4}, .cell = 0.05}},
              Numerics<QuadraticBSpline, Apic, Usl>{},
              bodies(fill<"plane">(Box{{0, 0}, {1, 0.15}}, rock, {.per_cell = 4}),
                     fill<"block">(Box{{0.1, 0.15}, {0.4, 0.3}}, rock, {.per_cell = 4})),
              walls(bottom(fixed), left(roller), right(roller)),
              gravity({g * std::sin(slope), -g * std::cos(slope)}),
              Coulomb(Friction(friction), PlaneNormal{{0, 1}})};
  double travel = 0;
  run(scene, {.end = end}, [&](const auto& s) {
    if (s.steps > 0)
      travel += s.time_step * momentum(s.template body<"block">())[0] / mass(s.template body<"block">());
  });
  const double exact = g * (std::sin(slope) - std::tan(friction) * std::cos(slope)) * end * end / 2;
  std::printf("the block has slid %.4f m, exact %.4f m\n", travel, exact);
  return std::abs(travel / exact - 1) < 0.01 ? 0 : 1;
}
