// Body force of a manufactured solution of a neo-Hookean solid (examples/extend/laws/neo_hookean.hpp), as a function of place and time: the
// derivation stands in tests/support/manufactured.hpp.
#pragma once
#include <arenite/arenite.hpp>

/// A part that loads the points of the first body. Moduli over the density, m2/s2.
struct ManufacturedForce {
  double amplitude = 0;  ///< m, of axis-aligned displacements in a unit square
  double shear = 0, lame = 0;

  template <class Scene>
  void add_force(Scene& scene, double) {
    const auto& points = scene.body().points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const typename Scene::Shape::template Cell<typename Scene::Mesh> cell(scene.mesh, points.cell[p]);
      const auto w = cell.weights(points.position[p]);
      const V f = points.mass[p] * stretching(points.position[p], scene.time);
      for (int i = 0; i < w.size(); ++i)
        scene.fields[0].sums[cell.nodes[static_cast<std::size_t>(i)]].add_force(w[i] * f);
    }
  }

 private:
  using V = arenite::Vec<double, 2>;
  static constexpr double pi = arenite::pi;

  V stretching(const V& x, double t) const {
    V moved, f, b;
    for (int a = 0; a < 2; ++a) {
      const double s = (a == 0 ? amplitude : -amplitude) * std::sin(pi * t);
      double start = x[a];
      for (int k = 0; k < 4; ++k)
        start -= (start + s * std::sin(pi * start) - x[a]) / (1 + s * pi * std::cos(pi * start));  // Newton
      moved[a] = x[a] - start;
      f[a] = 1 + s * pi * std::cos(pi * start);
    }
    const double k = std::log(f[0] * f[1]);
    for (int a = 0; a < 2; ++a)
      b[a] = pi * pi * moved[a] * (shear - 1 - (lame * (k - 1) - shear) / (f[a] * f[a]));
    return b;
  }
};
