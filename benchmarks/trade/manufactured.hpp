// Body forces of manufactured solutions of a neo-Hookean solid (examples/extend/laws/neo_hookean.hpp), as functions of place and time.
#pragma once
#include <arenite/arenite.hpp>

namespace manufactured {
using arenite::pi;
template <int D>
using V = arenite::Vec<double, D>;

/// Loads the points of the first body with the acceleration `solution.at(place, time)`, m/s2.
template <class Scene, class Solution>
void accelerate(Scene& scene, const Solution& solution) {
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const typename Scene::Shape::template Cell<typename Scene::Mesh> cell(scene.mesh, points.cell[p]);
    const auto w = cell.weights(points.position[p]);
    const V<Scene::D> f = points.mass[p] * solution.at(V<Scene::D>(points.position[p]), scene.time);
    for (int i = 0; i < w.size(); ++i)
      scene.fields[0].sums[cell.nodes[static_cast<std::size_t>(i)]].add_force(w[i] * f);
  }
}
}  // namespace manufactured

/// Axis-aligned displacements in a unit square or cube, along the second axis backwards: the derivation stands in tests/support/manufactured.hpp.
struct ManufacturedForce {
  double amplitude = 0;        ///< m
  double shear = 0, lame = 0;  ///< moduli over the density, m2/s2

  template <class Scene>
  void add_force(Scene& scene, double) const {
    manufactured::accelerate(scene, *this);
  }

  template <class V>
  V at(const V& x, double t) const {
    V moved, f, b;
    for (int a = 0; a < V::RowsAtCompileTime; ++a) {
      const double s = (a == 1 ? -amplitude : amplitude) * std::sin(manufactured::pi * t);
      double start = x[a];
      for (int k = 0; k < 4; ++k)
        start -= (start + s * std::sin(manufactured::pi * start) - x[a]) /
                 (1 + s * manufactured::pi * std::cos(manufactured::pi * start));  // Newton
      moved[a] = x[a] - start;
      f[a] = 1 + s * manufactured::pi * std::cos(manufactured::pi * start);
    }
    const double k = std::log(f.prod());
    for (int a = 0; a < V::RowsAtCompileTime; ++a)
      b[a] = manufactured::pi * manufactured::pi * moved[a] *
             (shear - 1 - (lame * (k - 1) - shear) / (f[a] * f[a]));
    return b;
  }
};

/// Each radius R of a ring turns by the angle g(t) h(R), h = (1 - 16 (R - 1)^2)^2, g = amplitude sin(pi t). With the shear
/// gamma = R g h' and J = 1 the stresses of the solid are s_rt = mu gamma, s_tt = mu gamma^2 and s_rr = 0 in the axes of the radius,
/// and balance of momentum gives b_r = c gamma^2 / R - R (g' h)^2, b_t = R g'' h - c (gamma' + 2 gamma / R), c = mu / density.
struct VortexForce {
  double amplitude = 0;  ///< rad
  double shear = 0;      ///< modulus over the density, m2/s2

  template <class Scene>
  void add_force(Scene& scene, double) const {
    manufactured::accelerate(scene, *this);
  }

  manufactured::V<2> at(const manufactured::V<2>& x, double t) const {
    const double r = x.norm(), d = r - 1, q = 1 - 16 * d * d;
    const double h = q * q, slope = -64 * d * q, curve = -64 * q + 2048 * d * d;
    const double g = amplitude * std::sin(manufactured::pi * t),
                 rate = amplitude * manufactured::pi * std::cos(manufactured::pi * t) * h;
    const double gamma = r * g * slope;
    const double radial = shear * gamma * gamma / r - r * rate * rate;
    const double along = -r * manufactured::pi * manufactured::pi * g * h -
                         shear * (g * slope + r * g * curve + 2 * gamma / r);
    return (radial * x + along * manufactured::V<2>(-x[1], x[0])) / r;
  }
};
