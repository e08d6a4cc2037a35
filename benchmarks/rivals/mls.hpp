// The rival in the plane: moving least squares MPM in its shortest form (Hu et al. 2018,
// doi:10.1145/3197517.3201293): APIC's affine matrix serves as velocity gradient, and force and momentum go
// to the nodes as one product. Its law is linear elasticity with the Jaumann rate, which costs less than the
// polar decomposition of the published example.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tensor.hpp"

namespace arenite::bench::rival {

template <class T>
class Mls {
 public:
  struct Point {
    T x[2], v[2];
    T c[2][2];  ///< velocity gradient, 1/s
    T mass, volume;
    T stress[4];  ///< xx, yy, zz, xy
  };
  struct Node {
    T mass, momentum[2];
  };

  std::vector<Point> points;
  std::vector<Node> nodes;
  Moduli<T> moduli;
  T density;
  T gravity = 0;       ///< downward, m/s2
  bool walls = false;  ///< bottom fixed, sides rollers

  /// A unit square of cells^2 cells.
  Mls(int cells, double rho, double young, double poisson)
      : moduli(young, poisson),
        density(static_cast<T>(rho)),
        cells_(cells),
        across_(static_cast<std::size_t>(cells + 2)),
        h_(static_cast<T>(1.0 / cells)) {
    nodes.resize(across_ * across_);
  }

  /// along^2 points a cell, where `inside(x, y)`.
  template <class Inside>
  void fill(Inside&& inside, int along) {
    const double gap = 1.0 / (cells_ * along);
    const auto volume = static_cast<T>(gap * gap);
    const auto place = [&](int cell, int k) { return (cell * along + k + 0.5) * gap; };
    for (int j = 0; j < cells_; ++j)
      for (int i = 0; i < cells_; ++i)
        for (int k = 0; k < along * along; ++k) {
          const double x = place(i, k % along), y = place(j, k / along);
          if (inside(x, y))
            points.push_back({{static_cast<T>(x), static_cast<T>(y)}, {}, {}, volume * density, volume, {}});
        }
  }

  double stable_step() const {
    T fastest = 0;
    for (const auto& p : points) fastest = std::max(fastest, p.v[0] * p.v[0] + p.v[1] * p.v[1]);
    return static_cast<double>(h_ / (std::sqrt(moduli.wave / density) + std::sqrt(fastest)));
  }

  void step(double time_step) {
    const T dt = static_cast<T>(time_step);
    p2g(dt);
    update_grid(dt);
    g2p(dt);
  }

  /// Force and momentum in one: the affine part of both is a product with the way to the node.
  void p2g(T dt) {
    const T per_inertia = 4 / (h_ * h_);
    std::fill(nodes.begin(), nodes.end(), Node{});
    for (const auto& p : points) {
      std::size_t first[2];
      T w[2][3];
      stencil(p.x, first, w);
      const T k = dt * p.volume * per_inertia;
      const T a[2][2] = {{p.mass * p.c[0][0] - k * p.stress[0], p.mass * p.c[0][1] - k * p.stress[3]},
                         {p.mass * p.c[1][0] - k * p.stress[3], p.mass * p.c[1][1] - k * p.stress[1]}};
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i) {
          const T dx = offset(first[0] + i, p.x[0]), dy = offset(first[1] + j, p.x[1]);
          const T weight = w[0][i] * w[1][j];
          Node& node = nodes[(first[1] + j) * across_ + first[0] + i];
          node.mass += weight * p.mass;
          node.momentum[0] += weight * (p.mass * p.v[0] + a[0][0] * dx + a[0][1] * dy);
          node.momentum[1] += weight * (p.mass * p.v[1] + a[1][0] * dx + a[1][1] * dy);
        }
    }
  }

  void update_grid(T dt) {
    for (std::size_t j = 0; j < across_; ++j)
      for (std::size_t i = 0; i < across_; ++i) {
        Node& node = nodes[j * across_ + i];
        if (node.mass <= 0) continue;
        node.momentum[0] /= node.mass;  // from here on a velocity
        node.momentum[1] = node.momentum[1] / node.mass - dt * gravity;
        if (!walls) continue;
        if (j < 2) node.momentum[0] = node.momentum[1] = 0;
        if (i < 2 || i + 2 >= across_) node.momentum[0] = 0;
      }
  }

  void g2p(T dt) {
    for (auto& p : points) gather(p, dt, 4 / (h_ * h_));
  }

 private:
  /// Node i lies at (i - 1/2) h.
  T offset(std::size_t i, T x) const { return (static_cast<T>(i) - static_cast<T>(0.5)) * h_ - x; }

  void stencil(const T (&x)[2], std::size_t (&first)[2], T (&w)[2][3]) const {
    for (int a = 0; a < 2; ++a) {
      const T place = x[a] / h_;
      first[a] = static_cast<std::size_t>(place);
      const T f = place - static_cast<T>(first[a]);
      w[a][0] = (1 - f) * (1 - f) / 2;
      w[a][1] = static_cast<T>(0.75) - (f - static_cast<T>(0.5)) * (f - static_cast<T>(0.5));
      w[a][2] = f * f / 2;
    }
  }

  void gather(Point& p, T dt, T per_inertia) {
    std::size_t first[2];
    T w[2][3];
    stencil(p.x, first, w);
    T v[2] = {}, b[2][2] = {};
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i) {
        const T dx = offset(first[0] + i, p.x[0]), dy = offset(first[1] + j, p.x[1]);
        const T weight = w[0][i] * w[1][j];
        const Node& node = nodes[(first[1] + j) * across_ + first[0] + i];
        for (int a = 0; a < 2; ++a) {
          const T share = weight * node.momentum[a];
          v[a] += share;
          b[a][0] += share * dx;
          b[a][1] += share * dy;
        }
      }
    for (int a = 0; a < 2; ++a) {
      p.v[a] = v[a];
      p.x[a] += dt * v[a];
      for (int d = 0; d < 2; ++d) p.c[a][d] = per_inertia * b[a][d];
    }
    const T xx = dt * p.c[0][0], yy = dt * p.c[1][1];
    const T xy = dt * (p.c[0][1] + p.c[1][0]) / 2, spin = dt * (p.c[0][1] - p.c[1][0]) / 2;
    auto& s = p.stress;
    const T volumetric = moduli.lame * (xx + yy), turn = 2 * spin * s[3];
    const T shear = spin * (s[1] - s[0]) + 2 * moduli.shear * xy;
    s[0] += turn + volumetric + 2 * moduli.shear * xx;
    s[1] += -turn + volumetric + 2 * moduli.shear * yy;
    s[2] += volumetric;
    s[3] += shear;
    p.volume *= std::exp(xx + yy);
  }

  int cells_;
  std::size_t across_;
  T h_;
};

}  // namespace arenite::bench::rival
