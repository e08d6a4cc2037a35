// The rival on tetrahedra: the textbook's method with linear shape functions, FLIP and MUSL, as a loop over
// an array of points. Optionally with the nodal averaging of the volumetric strain.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <arenite/mesh/mesh_data.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "plasticity.hpp"

namespace arenite::bench::rival {

template <class T, class Law>
class Tetrahedra {
 public:
  struct Point {
    Vec3<T> x, v;
    T mass, volume;
    Sym3<T> stress;
    std::uint32_t cell;
  };
  struct Node {
    Vec3<T> x;
    bool fixed_along[3] = {};
    T mass;
    Vec3<T> momentum, force, old_velocity, velocity, strain_velocity;
    T dilation, weight;  // of the averaging
  };
  struct Cell {
    std::uint32_t node[4];
    std::uint32_t neighbour[4];
    T gradient[4][3];
    T dilation, weight;
  };

  std::vector<Point> points;
  std::vector<Node> nodes;
  std::vector<Cell> cells;
  Law law;
  bool averages = false;
  Vec3<T> gravity{};

  /// `order`: 3 puts a lattice of 10 points into each cell, 4 puts 20.
  Tetrahedra(const MeshData<3>& mesh, int order, const Law& its_law) : law(its_law) {
    for (const auto& x : mesh.nodes) {
      nodes.push_back({});
      for (std::size_t i = 0; i < 3; ++i) nodes.back().x[i] = static_cast<T>(x[static_cast<int>(i)]);
    }
    const auto places = lattice(order);
    for (const auto& corners : mesh.cells) add_cell(mesh, corners, places);
    find_neighbours();
  }

  /// Fixes nodes on faces of the box [0, size]^3: rollers at both ends of x and z, all of the bottom.
  void close_box(double size) {
    const T far = static_cast<T>(size * (1 - 1e-6)), near = static_cast<T>(size * 1e-6);
    for (auto& node : nodes) {
      const bool bottom = node.x[1] < near;
      for (std::size_t i = 0; i < 3; ++i)
        node.fixed_along[i] = bottom || (i != 1 && (node.x[i] < near || node.x[i] > far));
    }
  }

  double stable_step() const {
    T fastest = 0;
    for (const auto& p : points)
      fastest = std::max(fastest, p.v[0] * p.v[0] + p.v[1] * p.v[1] + p.v[2] * p.v[2]);
    return static_cast<double>(least_size_ / (std::sqrt(law.moduli.wave / law.density) + std::sqrt(fastest)));
  }

  void step(double time_step) {
    const T dt = static_cast<T>(time_step);
    relocate();
    p2g();
    update_grid(dt);
    map_back();
    g2p(dt);
  }

  /// Walks from cell to cell; a point that leaves the mesh is removed.
  void relocate() {
    const T outside = -64 * std::numeric_limits<T>::epsilon();
    for (std::size_t p = 0; p < points.size();) {
      Point& point = points[p];
      for (int steps = 0; point.cell != none && steps < 64; ++steps) {
        T w[4];
        weights(cells[point.cell], point.x, w);
        const auto least = std::min_element(w, w + 4) - w;
        if (w[least] >= outside) break;
        point.cell = cells[point.cell].neighbour[least];
      }
      if (point.cell == none) {
        point = points.back();
        points.pop_back();
      } else {
        ++p;
      }
    }
  }

  void p2g() {
    for (auto& node : nodes) {
      node.mass = 0;
      node.momentum = {};
      node.force = {};
    }
    for (const auto& p : points) {
      const Cell& cell = cells[p.cell];
      T w[4];
      weights(cell, p.x, w);
      for (int k = 0; k < 4; ++k) {
        Node& node = nodes[cell.node[k]];
        const T* g = cell.gradient[k];
        const auto& s = p.stress;
        const T m = w[k] * p.mass;
        node.mass += m;
        for (std::size_t i = 0; i < 3; ++i) node.momentum[i] += m * p.v[i];
        node.force[0] -= p.volume * (s[0] * g[0] + s[3] * g[1] + s[5] * g[2]);
        node.force[1] -= p.volume * (s[3] * g[0] + s[1] * g[1] + s[4] * g[2]);
        node.force[2] -= p.volume * (s[5] * g[0] + s[4] * g[1] + s[2] * g[2]);
      }
    }
  }

  void update_grid(T dt) {
    for (auto& node : nodes) {
      if (node.mass <= 0) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        node.old_velocity[i] = node.momentum[i] / node.mass;
        node.velocity[i] = node.old_velocity[i] + dt * (node.force[i] / node.mass + gravity[i]);
        if (node.fixed_along[i]) node.velocity[i] = 0;
        node.momentum[i] = 0;
      }
    }
  }

  /// FLIP, and the new momenta back to the nodes.
  void map_back() {
    for (auto& p : points) {
      const Cell& cell = cells[p.cell];
      T w[4];
      weights(cell, p.x, w);
      for (int k = 0; k < 4; ++k) {
        const Node& node = nodes[cell.node[k]];
        for (std::size_t i = 0; i < 3; ++i) p.v[i] += w[k] * (node.velocity[i] - node.old_velocity[i]);
      }
      for (int k = 0; k < 4; ++k)
        for (std::size_t i = 0; i < 3; ++i) nodes[cell.node[k]].momentum[i] += w[k] * p.mass * p.v[i];
    }
    for (auto& node : nodes)
      for (std::size_t i = 0; i < 3; ++i)
        node.strain_velocity[i] = node.mass > 0 && !node.fixed_along[i] ? node.momentum[i] / node.mass : 0;
  }

  void g2p(T dt) {
    if (averages) average(dt);
    for (auto& p : points) {
      const Cell& cell = cells[p.cell];
      T w[4];
      weights(cell, p.x, w);
      T l[3][3] = {};
      for (int k = 0; k < 4; ++k) {
        const Node& node = nodes[cell.node[k]];
        for (std::size_t i = 0; i < 3; ++i) {
          p.x[i] += dt * w[k] * node.velocity[i];
          for (std::size_t j = 0; j < 3; ++j) l[i][j] += node.strain_velocity[i] * cell.gradient[k][j];
        }
      }
      Sym3<T> e;
      Vec3<T> spin;
      increment(l, dt, e, spin);
      if (averages) {
        const T change = (cell.dilation - (e[0] + e[1] + e[2])) / 3;
        for (std::size_t i = 0; i < 3; ++i) e[i] += change;
      }
      const T opened = law.update(p.stress, e, spin);
      p.volume *= std::exp(e[0] + e[1] + e[2] - opened);
    }
  }

 private:
  void weights(const Cell& cell, const Vec3<T>& x, T (&w)[4]) const {
    const Vec3<T>& origin = nodes[cell.node[0]].x;
    w[0] = 1;
    for (int k = 1; k < 4; ++k) {
      const T* g = cell.gradient[k];
      w[k] = g[0] * (x[0] - origin[0]) + g[1] * (x[1] - origin[1]) + g[2] * (x[2] - origin[2]);
      w[0] -= w[k];
    }
  }

  /// Volumetric strain: nodes take the mean of their cells by volume of points, cells the mean of their
  /// nodes.
  void average(T dt) {
    for (auto& cell : cells) cell.weight = 0;
    for (auto& node : nodes) node.dilation = node.weight = 0;
    for (const auto& p : points) cells[p.cell].weight += p.volume;
    for (auto& cell : cells) {
      if (cell.weight <= 0) continue;
      T divergence = 0;
      for (int k = 0; k < 4; ++k)
        for (std::size_t i = 0; i < 3; ++i)
          divergence += nodes[cell.node[k]].strain_velocity[i] * cell.gradient[k][i];
      for (const auto n : cell.node) {
        nodes[n].dilation += cell.weight * dt * divergence;
        nodes[n].weight += cell.weight;
      }
    }
    for (auto& cell : cells) {
      if (cell.weight <= 0) continue;
      cell.dilation = 0;
      for (const auto n : cell.node) cell.dilation += nodes[n].dilation / nodes[n].weight / 4;
    }
  }

  /// Barycentric lattice, drawn in so that equal weights integrate quadratics: the mean of the squares of the
  /// four coordinates over a tetrahedron is 1/10.
  static std::vector<std::array<double, 4>> lattice(int order) {
    std::vector<std::array<double, 4>> places;
    double spread = 0;
    for (int a = 0; a < order; ++a)
      for (int b = 0; a + b < order; ++b)
        for (int c = 0; a + b + c < order; ++c) {
          const double n = order - 1;
          places.push_back({a / n, b / n, c / n, (n - a - b - c) / n});
          for (const double q : places.back()) spread += (q - 0.25) * (q - 0.25);
        }
    const double inset = std::sqrt(4 * (0.1 - 0.0625) / (spread / static_cast<double>(places.size())));
    for (auto& place : places)
      for (double& q : place) q = 0.25 + inset * (q - 0.25);
    return places;
  }

  void add_cell(const MeshData<3>& mesh, std::array<Index, 4> corners,
                const std::vector<std::array<double, 4>>& places) {
    const auto edges = [&] {
      Eigen::Matrix3d m;
      for (std::size_t k = 0; k < 3; ++k)
        m.col(static_cast<int>(k)) = mesh.nodes[corners[k + 1]] - mesh.nodes[corners[0]];
      return m;
    };
    if (edges().determinant() < 0) std::swap(corners[2], corners[3]);
    const Eigen::Matrix3d inverse = edges().inverse();
    const double volume = edges().determinant() / 6;
    Cell cell{};
    double steepest = inverse.colwise().sum().norm();
    for (int k = 0; k < 3; ++k) {
      steepest = std::max(steepest, inverse.row(k).norm());
      for (int i = 0; i < 3; ++i) {
        cell.gradient[k + 1][i] = static_cast<T>(inverse(k, i));
        cell.gradient[0][i] -= cell.gradient[k + 1][i];
      }
    }
    least_size_ = std::min(least_size_, static_cast<T>(1 / steepest));
    std::copy(corners.begin(), corners.end(), cell.node);
    const T share = static_cast<T>(volume / static_cast<double>(places.size()));
    for (const auto& place : places) {
      Point p{{}, {}, share * law.density, share, {}, static_cast<std::uint32_t>(cells.size())};
      for (std::size_t i = 0; i < 3; ++i) {
        double x = 0;
        for (std::size_t k = 0; k < 4; ++k) x += place[k] * mesh.nodes[corners[k]][static_cast<int>(i)];
        p.x[i] = static_cast<T>(x);
      }
      points.push_back(p);
    }
    cells.push_back(cell);
  }

  void find_neighbours() {
    std::map<std::array<std::uint32_t, 3>, std::pair<std::uint32_t, std::size_t>> open;
    for (std::uint32_t c = 0; c < cells.size(); ++c)
      for (std::size_t k = 0; k < 4; ++k) {
        std::array<std::uint32_t, 3> face{};
        for (std::size_t i = 0, j = 0; i < 4; ++i)
          if (i != k) face[j++] = cells[c].node[i];
        std::sort(face.begin(), face.end());
        cells[c].neighbour[k] = none;
        const auto [other, first] = open.try_emplace(face, c, k);
        if (first) continue;
        const auto [d, m] = other->second;
        cells[c].neighbour[k] = d;
        cells[d].neighbour[m] = c;
        open.erase(other);
      }
  }

  T least_size_ = std::numeric_limits<T>::infinity();
};

}  // namespace arenite::bench::rival
