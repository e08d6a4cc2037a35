// How do I make a soil profile with as many layers as a table lists? As a list of fills of one law, each with
// its own parameters. The ground is at rest under its weight: the reaction of the floor and the stress above
// it are compared with the exact ones.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/layers.cpp -o layers -pthread && ./layers [TABLE]
//   prints: 5 layers, weight 47.863 kN, reaction 47.861 kN; greatest error of a stress 0.29 % of the floor's
#include <arenite/arenite.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
using namespace arenite;

// 1. The table: from the top, thickness (m), density (kg/m3), Young's modulus (MPa), friction (deg).
struct Layer {
  double thickness, density, young, friction;
};
std::vector<Layer> read(std::istream& table) {
  std::vector<Layer> layers;
  for (Layer l{}; table >> l.thickness >> l.density >> l.young >> l.friction;) layers.push_back(l);
  return layers;
}
const char* const profile =
    "0.5  1540  20  34\n"
    "0.7  1620  30  36\n"
    "0.3  1450  15  33\n"
    "1.0  1680  45  37\n"
    "0.5  1720  60  38\n";

int main(int argc, char** argv) {
  std::istringstream here(profile);
  std::ifstream file(argc > 1 ? argv[1] : "");
  const auto layers = argc > 1 ? read(file) : read(here);
  double depth = 0;
  for (const Layer& l : layers) depth += l.thickness;

  // 2. A fill for each layer. All have the law MohrCoulomb<>, which is what the type of the scene names.
  const double width = 1, g = 9.81;
  double top = depth;
  std::vector<Fill<MohrCoulomb<>, "", Box<2>>> fills;
  for (const Layer& l : layers) {
    const MohrCoulomb<> soil{
        {.density = l.density, .young = l.young * 1_MPa, .poisson = 0.3, .friction = l.friction * 1_deg}};
    fills.push_back(fill(Box<2>{{0, top - l.thickness}, {width, top}}, soil,
                         {.stress = Geostatic{.surface = depth, .k0 = 0.5}}));
    top -= l.thickness;
  }

  // 3. The scene, and a hundredth of a second at rest.
  Scene scene{PlaneStrain{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {width, depth}, .cell = 0.1}},
              Numerics<QuadraticBSpline, Apic, Usl>{},
              bodies(fills),
              walls(bottom(roller), left(roller), right(roller)),
              gravity({0, -g}),
              Reactions{}};
  run(scene, {.end = 0.01});

  // 4. Weight against reaction, and the stress of each point against the weight above it.
  double weight = 0, worst = 0, above = 0, surface = depth;
  for (std::size_t k = 0; k < scene.number_of_bodies(); ++k) {
    const Layer& l = layers[k];
    weight += l.density * g * l.thickness * width;
    const auto& points = scene.body(k).points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double exact = above + l.density * g * (surface - points.position[p][1]);
      worst = std::max(worst, std::abs(-points.stress[p][1] - exact));
    }
    above += l.density * g * l.thickness;
    surface -= l.thickness;
  }
  const double reaction = -arenite::reaction(scene, "bottom").force[1];
  std::printf(
      "%zu layers, weight %.3f kN, reaction %.3f kN; greatest error of a stress %.2f %% of the floor's\n",
      scene.number_of_bodies(), weight / 1e3, std::abs(reaction) / 1e3, 100 * worst * width / weight);
  return std::abs(std::abs(reaction) / weight - 1) < 1e-3 && worst < 0.02 * weight / width ? 0 : 1;
}
