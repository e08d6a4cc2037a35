// The rival on a grid in space: quadratic B-splines and APIC, one loop over the points for each direction, 27
// nodes a point.
#pragma once

#include <cmath>
#include <vector>

#include "plasticity.hpp"

namespace arenite::bench::rival {

template <class T, class Law>
class BSpline {
 public:
  struct Point {
    Vec3<T> x, v;
    T b[3][3];  ///< sum w v (x_i - x_p)^T, m2/s
    T mass, volume;
    Sym3<T> stress;
  };
  struct Node {
    T mass;
    Vec3<T> momentum, force;
  };

  std::vector<Point> points;
  std::vector<Node> nodes;
  Law law;
  Vec3<T> gravity{};

  /// A grid of `cells`^3 cells of edge h; the cells `from` to `to` along each axis get `along`^3 points
  /// each.
  BSpline(int cells, double h, int from, int to, int along, const Law& its_law)
      : law(its_law), across_(static_cast<std::size_t>(cells + 2)), h_(static_cast<T>(h)) {
    nodes.resize(across_ * across_ * across_);
    const double gap = h / along;
    const T volume = static_cast<T>(gap * gap * gap);
    const auto place = [&](int cell, int k) { return static_cast<T>((cell * along + k + 0.5) * gap); };
    for (int z = from; z < to; ++z)
      for (int y = from; y < to; ++y)
        for (int x = from; x < to; ++x)
          for (int i = 0; i < along * along * along; ++i)
            points.push_back({{place(x, i % along), place(y, i / along % along), place(z, i / along / along)},
                              {},
                              {},
                              volume * law.density,
                              volume,
                              {}});
  }

  double stable_step() const {
    T fastest = 0;
    for (const auto& p : points)
      fastest = std::max(fastest, p.v[0] * p.v[0] + p.v[1] * p.v[1] + p.v[2] * p.v[2]);
    return static_cast<double>(h_ / (std::sqrt(law.moduli.wave / law.density) + std::sqrt(fastest)));
  }

  void step(double time_step) {
    const T dt = static_cast<T>(time_step);
    p2g();
    update_grid(dt);
    g2p(dt);
  }

  void p2g() {
    for (auto& node : nodes) node = {};
    for (const auto& p : points) p2g(p);
  }
  void update_grid(T dt) {
    for (auto& node : nodes) {
      if (node.mass <= 0) continue;
      for (std::size_t i = 0; i < 3; ++i)  // from here on a velocity
        node.momentum[i] = (node.momentum[i] + dt * node.force[i]) / node.mass + dt * gravity[i];
    }
  }
  void g2p(T dt) {
    for (auto& p : points) gather(p, dt);
  }

 private:
  /// Node i lies at (i - 1/2) h; a point in cell c touches nodes c, c + 1, c + 2 along each axis.
  struct Stencil {
    std::size_t first[3];
    T w[3][3], dw[3][3];
  };

  Stencil stencil(const Vec3<T>& x) const {
    Stencil s;
    for (std::size_t a = 0; a < 3; ++a) {
      const T place = x[a] / h_;
      s.first[a] = static_cast<std::size_t>(place);
      const T f = place - static_cast<T>(s.first[a]);
      s.w[a][0] = (1 - f) * (1 - f) / 2;
      s.w[a][1] = static_cast<T>(0.75) - (f - static_cast<T>(0.5)) * (f - static_cast<T>(0.5));
      s.w[a][2] = f * f / 2;
      s.dw[a][0] = (f - 1) / h_;
      s.dw[a][1] = (1 - 2 * f) / h_;
      s.dw[a][2] = f / h_;
    }
    return s;
  }

  /// Calls `f(node, weight, gradient, x_i - x_p)` for the 27 nodes of a point.
  template <class F>
  void for_each_node(const Vec3<T>& x, F&& f) {
    const Stencil s = stencil(x);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i) {
          Node& node = nodes[((s.first[2] + k) * across_ + s.first[1] + j) * across_ + s.first[0] + i];
          const T w = s.w[0][i] * s.w[1][j] * s.w[2][k];
          const Vec3<T> g{s.dw[0][i] * s.w[1][j] * s.w[2][k], s.w[0][i] * s.dw[1][j] * s.w[2][k],
                          s.w[0][i] * s.w[1][j] * s.dw[2][k]};
          const auto along = [&](std::size_t a, std::size_t n) {
            return (static_cast<T>(s.first[a] + n) - static_cast<T>(0.5)) * h_ - x[a];
          };
          f(node, w, g, Vec3<T>{along(0, i), along(1, j), along(2, k)});
        }
  }

  void p2g(const Point& p) {
    const T per_inertia = 4 / (h_ * h_);
    const auto& s = p.stress;
    for_each_node(p.x, [&](Node& node, T w, const Vec3<T>& g, const Vec3<T>& d) {
      const T m = w * p.mass;
      node.mass += m;
      for (std::size_t i = 0; i < 3; ++i)
        node.momentum[i] +=
            m * (p.v[i] + per_inertia * (p.b[i][0] * d[0] + p.b[i][1] * d[1] + p.b[i][2] * d[2]));
      node.force[0] -= p.volume * (s[0] * g[0] + s[3] * g[1] + s[5] * g[2]);
      node.force[1] -= p.volume * (s[3] * g[0] + s[1] * g[1] + s[4] * g[2]);
      node.force[2] -= p.volume * (s[5] * g[0] + s[4] * g[1] + s[2] * g[2]);
    });
  }

  void gather(Point& p, T dt) {
    Vec3<T> v{};
    T b[3][3] = {}, l[3][3] = {};
    for_each_node(p.x, [&](const Node& node, T w, const Vec3<T>& g, const Vec3<T>& d) {
      for (std::size_t i = 0; i < 3; ++i) {
        v[i] += w * node.momentum[i];
        for (std::size_t j = 0; j < 3; ++j) {
          b[i][j] += w * node.momentum[i] * d[j];
          l[i][j] += node.momentum[i] * g[j];
        }
      }
    });
    p.v = v;
    for (std::size_t i = 0; i < 3; ++i) {
      p.x[i] += dt * v[i];
      for (std::size_t j = 0; j < 3; ++j) p.b[i][j] = b[i][j];
    }
    Sym3<T> e;
    Vec3<T> spin;
    increment(l, dt, e, spin);
    const T opened = law.update(p.stress, e, spin);
    p.volume *= std::exp(e[0] + e[1] + e[2] - opened);
  }

  std::size_t across_;
  T h_;
};

}  // namespace arenite::bench::rival
