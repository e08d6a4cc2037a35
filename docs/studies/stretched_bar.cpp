// At which stretch a bar parts: neo-Hookean (nu = 0.3), ten cells long, fixed at its lower end, rollers at its sides, drawn by a body
// force that grows for 3 s. Prints the rows of docs/limits.md ("Stretched bodies"): the stretch at the wall, by the closed form of the
// force, when the reaction fell below half of the weight; with local damping of 0.7 and of 0.1, at the Courant number 0.5.
//
//   c++ -O3 -march=native -std=c++20 -isystem include -isystem /usr/include/eigen3 docs/studies/stretched_bar.cpp -o bar && ./bar
#include <arenite/arenite.hpp>
#include <cmath>
#include <cstdio>

#include "../../examples/extend/laws/neo_hookean.hpp"

using namespace arenite;

namespace {

constexpr double young = 1e6, density = 1000, length = 1, width = 0.4, over = 3,
                 most = 1.5 * young / density / length;
const Elasticity rubber{"rubber", density, young, 0.3};

/// Under the nominal stress P = (G (l^2 - 1) + lame ln l) / l, Pa.
double stretch_under(double nominal) {
  double low = 1, high = 6;
  for (int k = 0; k < 60; ++k) {
    const double l = (low + high) / 2;
    ((rubber.shear() * (l * l - 1) + rubber.lame() * std::log(l)) / l < nominal ? low : high) = l;
  }
  return low;
}

template <class Numerics, class Mesh, class... Splits>
void part(const Mesh& mesh, int per_cell, double damping, const Splits&... splits) {
  Scene scene{PlaneStrain{},
              mesh,
              Numerics{},
              bodies(fill<"bar">(Box{{0, 0}, {width, length}}, NeoHookean{rubber}, {.per_cell = per_cell})),
              walls(left(roller), right(roller), bottom(fixed)),
              gravity({0, most}, Ramp{.over = over}),
              LocalDamping{.factor = damping},
              Reactions{},
              splits...};
  const auto weight = [&] { return density * most * scene.time / over * length * width; };
  bool parts = false;
  try {
    run(scene, {.end = over, .watch = false}, every(0.005, [&](const auto& s) {
          parts = s.time > 0.1 && -reaction(s, "bottom").force[1] < weight() / 2;
          return parts ? RunFlow::stop : RunFlow::go_on;
        }));
  } catch (const error&) {
    parts = true;
  }
  const double stretch = stretch_under(weight() / width);
  std::printf(parts ? " %.2f |" : " above %.1f |", parts ? stretch : stretch - 0.05);
  std::fflush(stdout);
}

template <class Numerics, class... Splits>
void row(const char* name, std::initializer_list<int> points, const Splits&... splits) {
  for (const double damping : {0.7, 0.1}) {
    std::printf("| %s; damping %.1f |", name, damping);
    for (const int per_cell : points)
      part<Numerics>(CartesianGrid<2>{{.lower = {0, 0}, .upper = {width, 6}, .cell = 0.1}}, per_cell, damping,
                     splits...);
    std::printf("\n");
  }
}

}  // namespace

int main() {
  on_warning([](std::string_view) {});
  std::printf("| shape function, points a cell | 4 | 9 | 16 | 25 |\n|---|---|---|---|---|\n");
  row<Numerics<QuadraticBSpline>>("`QuadraticBSpline`", {4, 9, 16, 25});
  row<Numerics<QuadraticBSpline, Flip, Usl>>("`QuadraticBSpline`, FLIP with USL", {4, 9, 16});
  row<Numerics<QuadraticBSpline, Aflip>>("`QuadraticBSpline`, AFLIP", {4, 9, 16});
  row<Numerics<CubicBSpline>>("`CubicBSpline`", {4, 9, 16, 25});
  row<Numerics<LinearGrid>>("`LinearGrid`", {4, 9, 16, 25});
  row<Numerics<UGimp<2>>>("`UGimp<2>`", {4});
  row<Numerics<UGimp<3>>>("`UGimp<3>`", {9});
  row<Numerics<QuadraticBSpline>>("`QuadraticBSpline`, `SplitPoints` with `per_cell = 16`", {4, 9},
                                  SplitPoints<"bar">{{.per_cell = 16}});
}
