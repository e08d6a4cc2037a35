// Manufactured solutions of a neo-Hookean solid in plane strain: motions x(X, t) with the body force that
// they take in closed form. A run from them is compared with the motion, point by point.
#pragma once

#include "../../examples/extend/laws/neo_hookean.hpp"

#include <arenite/arenite.hpp>
#include <functional>

#include "catch.hpp"

namespace arenite::test {

/// A motion that begins at rest in place: all as functions of the position X at the start and the time.
struct Motion {
  using V = Vec<double, 2>;
  std::function<V(const V&, double)> position;    ///< x, m
  std::function<V(const V&)> start_velocity;      ///< m/s
  std::function<V(const V&, double)> body_force;  ///< m/s2
  AnyRegion region;
  std::array<double, 2> lower, upper;  ///< of the mesh, m
  double end;                          ///< s
};

/// Young's modulus 1 kPa, Poisson's ratio 0.3, density 1,000 kg/m3.
inline NeoHookean manufactured_law() { return NeoHookean{Elasticity{"NeoHookean", 1000, 1000, 0.3}}; }

/// Generalised vortex (Kamojjala, Brannon, Sadeghirad and Guilkey 2015, Eng. with Computers 31, 199-213): the
/// circles of a ring 0.75 m < R < 1.25 m turn by alpha = A sin(pi t) h(R), h = ((4 R - 3)(4 R - 5))^2, which
/// neither moves nor loads its edges. Without change of volume stresses are mu (F F^T - 1), and along and
/// across the radius of the moved point
///   b_r = -R alpha_t^2 + mu / rho R alpha_R^2     b_t = R alpha_tt - mu / rho (3 alpha_R + R alpha_RR)
inline Motion vortex(double turn = 0.25) {
  const auto h = [](double r) { return square((4 * r - 3) * (4 * r - 5)); };
  const auto h1 = [](double r) { return 64 * (r - 1) * (4 * r - 3) * (4 * r - 5); };
  const auto h2 = [](double r) { return 64 * (48 * r * r - 96 * r + 47); };
  const double shear_over_density = 1000 / 2.6 / 1000;
  using V = Motion::V;
  Motion m;
  m.position = [=](const V& x, double t) {
    const double a = turn * std::sin(pi * t) * h(x.norm());
    return V(std::cos(a) * x[0] - std::sin(a) * x[1], std::sin(a) * x[0] + std::cos(a) * x[1]);
  };
  m.start_velocity = [=](const V& x) { return V(pi * turn * h(x.norm()) * V(-x[1], x[0])); };
  m.body_force = [=](const V& start, double t) {
    const V x = m.position(start, t);
    const double r = start.norm(), g = turn * std::sin(pi * t), gt = pi * turn * std::cos(pi * t);
    const double radial = -r * square(gt * h(r)) + shear_over_density * r * square(g * h1(r)),
                 around = -r * square(pi) * g * h(r) - shear_over_density * g * (3 * h1(r) + r * h2(r));
    return V((radial * x + around * V(-x[1], x[0])) / r);
  };
  m.region = AnyRegion::of<2>(Inside{[](const V& x) { return std::abs(x.norm() - 1) - 0.25; }});
  m.lower = {-1.3, -1.3};
  m.upper = {1.3, 1.3};
  m.end = 1;
  return m;
}

/// Axis-aligned displacements in a unit square between rollers (Wallstedt and Guilkey 2008,
/// doi:10.1016/j.jcp.2008.07.019): u = A sin(pi X) sin(c pi t), v = A sin(pi Y) sin(c pi t + pi), and with
/// lambda, mu, K = ln det F
///   b_x = pi^2 u (mu / rho - c^2 - (lambda (K - 1) - mu) / (rho F_xx^2)), b_y alike
inline Motion axis_aligned(double amplitude = 0.05) {
  const double c = 1, young = 1, lambda = young * 0.3 / (1.3 * 0.4), mu = young / 2.6;  // over the density
  using V = Motion::V;
  Motion m;
  m.position = [=](const V& x, double t) {
    const double s = amplitude * std::sin(c * pi * t);
    return V(x[0] + s * std::sin(pi * x[0]), x[1] - s * std::sin(pi * x[1]));
  };
  m.start_velocity = [=](const V& x) {
    return V(c * pi * amplitude * V(std::sin(pi * x[0]), -std::sin(pi * x[1])));
  };
  m.body_force = [=](const V& x, double t) {
    const double s = amplitude * std::sin(c * pi * t);
    const V moved = m.position(x, t) - x;
    const V f(1 + s * pi * std::cos(pi * x[0]), 1 - s * pi * std::cos(pi * x[1]));
    const double k = std::log(f[0] * f[1]);
    V b;
    for (int a = 0; a < 2; ++a)
      b[a] = square(pi) * moved[a] * (mu - c * c - (lambda * (k - 1) - mu) / square(f[a]));
    return b;
  };
  m.region = AnyRegion::of<2>(Box{{0, 0}, {1, 1}});
  m.lower = {0, 0};
  m.upper = {1, 1};
  m.end = 1 / c;
  return m;
}

/// Loads each point by the body force of where it began.
struct PushedAlong {
  std::function<Vec<double, 2>(const Vec<double, 2>&, double)> body_force;
  std::vector<Vec<double, 2>> start;  ///< [points] positions by id

  template <class Scene>
  void add_force(Scene& scene, double) {
    const auto& points = scene.body().points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const typename Scene::Shape::template Cell<typename Scene::Mesh> cell(scene.mesh, points.cell[p]);
      const auto w = cell.weights(points.position[p]);
      const Vec<double, 2> f = points.mass[p] * body_force(start[points.id[p]], scene.time);
      for (int i = 0; i < w.size(); ++i)
        scene.fields[0].sums[cell.nodes[static_cast<std::size_t>(i)]].add_force(w[i] * f);
    }
  }
};

/// Greatest root mean square over a run of the points' distances from where the motion takes them, m.
template <class N, class Mesh>
double error_of(const Motion& motion, const Mesh& mesh, int per_cell, const N& numerics,
                double courant = 0.5) {
  Scene scene{PlaneStrain{},
              Mesh(mesh),
              numerics,
              bodies(fill(motion.region, manufactured_law(), {.per_cell = per_cell})),
              walls(left(roller), right(roller), bottom(roller), top(roller)),
              PointIds{},
              PushedAlong{motion.body_force, {}}};
  auto& points = scene.body().points;
  auto& start = scene.template part<PushedAlong>().start;
  start.resize(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vec<double, 2> x = points.position[p];
    start[points.id[p]] = x;
    points.velocity.set(p, motion.start_velocity(x));
    if constexpr (N::Transfer::affine) {
      Mat<double, 2> gradient;
      for (int k = 0; k < 2; ++k) {
        Vec<double, 2> d = Vec<double, 2>::Zero();
        d[k] = 1e-5;
        gradient.col(k) = (motion.start_velocity(x + d) - motion.start_velocity(x - d)) / 2e-5;
      }
      points.velocity_gradient.set(p, gradient);
    }
  }
  double worst = 0;
  while (scene.time < motion.end) {
    step(scene, std::min(courant * stable_step(scene), motion.end - scene.time + 1e-12));
    double sum = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
      sum += (points.position[p] - motion.position(start[points.id[p]], scene.time)).squaredNorm();
    worst = std::max(worst, std::sqrt(sum / static_cast<double>(points.size())));
    if (!(worst < 1)) break;
  }
  return worst;
}

}  // namespace arenite::test
