// Three elastic blocks that fall in a unit square: the problem of the 88-line MLS-MPM (Hu et al. 2018), with
// its places, speed of sound and gravity, on a grid as fine as wanted; the blocks' edges lie on the grid's
// lines.
#pragma once

#include <arenite/arenite.hpp>

#include "rivals/mls.hpp"

namespace arenite::bench {

struct Blocks2d {
  int cells = 80;  ///< along an edge of the square, a multiple of 20
  int along = 3;   ///< points a cell along an axis
  static constexpr double density = 1000, young = 1e7, poisson = 0.2, gravity = 200;
  static constexpr double half = 0.1;
  static constexpr double centre[3][2] = {{0.55, 0.45}, {0.45, 0.65}, {0.55, 0.85}};
};

template <class T, class Shape = QuadraticBSpline>
auto blocks_scene(const Blocks2d& o) {
  const LinearElastic law{{.density = o.density, .young = o.young, .poisson = o.poisson}};
  const auto in_a_block = [](const Vec<double, 2>& x) {
    for (const auto& c : Blocks2d::centre)
      if (std::abs(x[0] - c[0]) < Blocks2d::half && std::abs(x[1] - c[1]) < Blocks2d::half) return -1.0;
    return 1.0;
  };
  return Scene{PlaneStrain{},
               CartesianGrid<2, T>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 1.0 / o.cells}},
               Numerics<Shape, Apic, Usl>{},
               bodies(fill(Inside{in_a_block}, law, {.per_cell = o.along * o.along})),
               walls(bottom(fixed), left(roller), right(roller)),
               arenite::gravity({0, -o.gravity})};
}

template <class T>
rival::Mls<T> blocks_rival(const Blocks2d& o) {
  rival::Mls<T> rival(o.cells, o.density, o.young, o.poisson);
  const auto in_a_block = [&](double x, double y) {
    for (const auto& c : o.centre)
      if (std::abs(x - c[0]) < o.half && std::abs(y - c[1]) < o.half) return true;
    return false;
  };
  rival.fill(in_a_block, o.along);
  rival.gravity = static_cast<T>(o.gravity);
  rival.walls = true;
  return rival;
}

}  // namespace arenite::bench
