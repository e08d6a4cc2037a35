// Constraints: nodes that may not move freely. Parts name the directions that they block; those of
// several parts at one node become one projector, so that the order of the parts does not matter.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/core/error.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/shape/shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A node that may not move freely: its velocity is multiplied by `projector` [D x D].
template <class T, int D>
struct Constraint {
  Index node;
  Mat<T, D> projector;
};

/// A node that a part moves: `lift` [D x D] times the part's velocity there is added to its projected
/// velocity.
template <class T, int D>
struct Drive {
  Index node;
  std::size_t part;  ///< number of the part that blocks and moves
  Mat<T, D> lift;
  Vec<T, D> target = zeros<Vec<T, D>>();  ///< lift times the part's velocity now, m/s
};

namespace detail {

/// Blocked directions at a node: as they were named, and as an orthonormal set.
template <int D>
struct Blocked {
  static constexpr auto most = static_cast<std::size_t>(D);
  std::array<Vec<double, D>, most> normals, directions;  // the first `count`
  std::array<std::size_t, most> part{}, wall{};  // numbers of the part that named each, and of its wall
  std::size_t count = 0;

  void add(Vec<double, D> n, std::size_t by, std::size_t wall_of_it);
  Mat<double, D> projector() const;
  /// Matrix L [D x D] of w = L u, u the velocity of a part: w lies in the blocked directions, n . w = n . u for
  /// the normals n that the part named and n . w = 0 for those of other parts.
  Mat<double, D> lift(std::size_t of) const;

 private:
  std::array<Vec<double, D>, most> shares(std::size_t of) const;
};

}  // namespace detail

/// The nodes of any mesh, to which parts add the directions that they block.
template <int D>
class BoundaryNodes {
 public:
  using V = Vec<double, D>;
  /// A named set of nodes of a mesh. Throws `error` if there is none of that name.
  using NodeSet = const std::vector<Index>& (*)(const void* mesh, const std::string& name);

  /// The mesh is a part of a larger one, with the corners of the box around that.
  void set_whole(const V& lower, const V& upper) {
    lower_ = lower;
    upper_ = upper;
    is_part_ = true;
  }
  /// Whether the mesh is a part of a larger one: a wall may then have no node.
  bool is_part() const { return is_part_; }

  Index size() const { return static_cast<Index>(position_.size()); }
  /// Whether a cell has node i: a mesher may leave nodes without cells.
  bool is_used(Index i) const { return used_.empty() || used_[i] != 0; }
  const V& position(Index i) const { return position_[i]; }  ///< m
  const V& lower() const { return lower_; }  ///< corners of the grid, or of the box around the used nodes, m
  const V& upper() const { return upper_; }
  /// Positions closer than this count as equal, m.
  double tolerance() const;
  /// Whether the mesh has no faces across an axis.
  bool is_periodic(int axis) const { return ((periodic_axes_ >> axis) & 1) != 0; }
  /// The nodes of a named set; null if the mesh is a grid, which has none.
  const std::vector<Index>* node_set(const std::string& name) const {
    return node_set_ != nullptr ? &node_set_(mesh_, name) : nullptr;
  }

  /// Blocks the velocity of node i along a direction of any length.
  void block(Index i, const V& direction) { blocked_[i].add(direction, part_, wall_); }
  /// The calls of `block` that follow are for wall number k of the part.
  void set_wall(std::size_t k) { wall_ = k; }
  /// The blocked directions at node i.
  const detail::Blocked<D>& blocked(Index i) const { return blocked_[i]; }

 protected:
  explicit BoundaryNodes(const void* mesh, Index count, double epsilon);
  /// Box around the used nodes.
  void find_box();

  const void* mesh_;
  NodeSet node_set_ = nullptr;
  double epsilon_;  // of the mesh's scalar
  int periodic_axes_ = 0;
  std::vector<V> position_;
  std::vector<char> used_;  // empty: all are
  std::vector<detail::Blocked<D>> blocked_;
  V lower_, upper_;
  std::size_t part_ = 0, wall_ = 0;
  bool is_part_ = false;
};

/// The nodes of a mesh.
template <class Shape, class M>
class NodeConstraints : public BoundaryNodes<M::dimension> {
  using Base = BoundaryNodes<M::dimension>;

 public:
  using T = typename M::scalar;
  static constexpr int D = M::dimension;
  using V = Vec<double, D>;

  explicit NodeConstraints(const M& mesh)
      : Base(&mesh, Shape::node_count(mesh), static_cast<double>(std::numeric_limits<T>::epsilon())) {
    for (Index i = 0; i < this->size(); ++i) {
      const auto x = Shape::node_position(mesh, i);
      for (int k = 0; k < D; ++k) this->position_[i][k] = static_cast<double>(x[k]);
    }
    if constexpr (is_simplex_mesh<M>) {
      this->used_.resize(this->size());
      for (Index i = 0; i < this->size(); ++i) this->used_[i] = !mesh.cells_at(i).empty();
      this->find_box();
      this->node_set_ = [](const void* from, const std::string& name) -> const std::vector<Index>& {
        return static_cast<const M*>(from)->node_set(name);
      };
    } else {  // a shape function may have nodes beyond the faces
      for (int k = 0; k < D; ++k) {
        this->lower_[k] = static_cast<double>(mesh.lower()[k]);
        this->upper_[k] = static_cast<double>(mesh.upper(k));
        this->periodic_axes_ |= arenite::is_periodic<M>(k) ? 1 << k : 0;
      }
    }
  }

  const M& mesh() const { return *static_cast<const M*>(this->mesh_); }

  /// Calls `constrain` of part number k.
  template <class Part>
  void add(const Part& part, std::size_t k = 0) {
    this->part_ = k;
    this->wall_ = 0;
    part.constrain(*this);
  }

  /// The constrained nodes, ascending.
  std::vector<Constraint<T, D>> constraints() const {
    std::vector<Constraint<T, D>> all;
    for (Index i = 0; i < this->size(); ++i)
      if (this->blocked_[i].count > 0) all.push_back({i, rounded(this->blocked_[i].projector())});
    return all;
  }
  /// The nodes that part number k moves, ascending.
  std::vector<Drive<T, D>> drives(std::size_t k) const {
    std::vector<Drive<T, D>> all;
    for (Index i = 0; i < this->size(); ++i)
      if (const Mat<double, D> lift = this->blocked_[i].lift(k); lift.norm() > 0)
        all.push_back({i, k, rounded(lift)});
    return all;
  }

 private:
  static Mat<T, D> rounded(const Mat<double, D>& m) {
    Mat<T, D> to;
    for (int k = 0; k < D * D; ++k) to.data()[k] = static_cast<T>(m.data()[k]);
    return to;
  }
};

/// The nodes that parts (`Walls`, kinematics, ..) constrain on a mesh, ascending.
template <class Shape, class M, class... Parts>
std::vector<Constraint<typename M::scalar, M::dimension>> resolve(const M& mesh, const Parts&... parts) {
  NodeConstraints<Shape, M> nodes(mesh);
  (nodes.add(parts), ...);
  return nodes.constraints();
}

/// Receives the impulses of single nodes if no part reads them: does nothing.
struct NoSink {
  template <class V>
  constexpr void operator()(Index, const V&) const {}
};

/// Removes the blocked part of the velocities of a field. Returns the impulse that this gave to the nodes
/// that `owns(node)`, N s; `take(node, impulse)` receives that of each.
template <class T, int D, class Velocities, class Owns = OwnsAll, class Take = NoSink>
Vec<T, D> constrain(const std::vector<Constraint<T, D>>& constraints, const std::vector<T>& mass,
                    Velocities& velocity, const Owns& owns = {}, const Take& take = {}) {
  Vec<T, D> impulse = zeros<Vec<T, D>>();
  for (const auto& c : constraints) {
    auto& v = velocity[c.node];
    Vec<T, D> allowed, given;
    for (int i = 0; i < D; ++i) {
      allowed[i] = c.projector(i, 0) * v[0];
      for (int k = 1; k < D; ++k) allowed[i] += c.projector(i, k) * v[k];
      given[i] = mass[c.node] * (allowed[i] - v[i]);
    }
    if (mass[c.node] > 0 && owns(c.node)) {
      for (int i = 0; i < D; ++i) impulse[i] += given[i];
      take(c.node, given);
    }
    v = allowed;
  }
  return impulse;
}

/// Removes the blocked part of the velocities of a field and adds the targets of its driven nodes, m/s. Returns
/// the impulse that this gave, N s, and the work of the drives, J; `owns` and `take` as above.
template <class T, int D, class Velocities, class Owns = OwnsAll, class Take = NoSink>
std::pair<Vec<T, D>, double> constrain(const std::vector<Constraint<T, D>>& constraints,
                                       const std::vector<Drive<T, D>>& drives, const std::vector<T>& mass,
                                       Velocities& velocity, const Owns& owns = {}, const Take& take = {}) {
  double work = 0;  // impulses of a node times its target: what is allowed is normal to both
  const auto record = [&](T sign) {
    for (const auto& d : drives)
      if (owns(d.node)) work += static_cast<double>(sign * mass[d.node] * d.target.dot(velocity[d.node]));
  };
  record(-1);
  Vec<T, D> impulse = constrain(constraints, mass, velocity, owns, take);
  for (const auto& d : drives) {
    velocity[d.node] += d.target;
    if (mass[d.node] == 0 || !owns(d.node)) continue;
    const Vec<T, D> given = mass[d.node] * d.target;
    impulse += given;
    take(d.node, given);
  }
  record(1);
  return {impulse, work};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <algorithm>
#include <cmath>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

template <int D>
ARENITE_COLD void Blocked<D>::add(Vec<double, D> n, std::size_t by, std::size_t wall_of_it) {
  const auto normalize = [&n] {
    const double length = std::sqrt(dot(n, n));
    for (int i = 0; i < D && length > 0; ++i) n[i] /= length;
    return length;
  };
  normalize();
  const Vec<double, D> name = n;
  for (int pass = 0; pass < 2; ++pass)
    for (std::size_t k = 0; k < count; ++k) {
      const double along = dot(directions[k], n);
      for (int i = 0; i < D; ++i) n[i] -= along * directions[k][i];
    }
  if (count == most || !(normalize() > 1e-6)) return;
  normals[count] = name;
  part[count] = by;
  wall[count] = wall_of_it;
  directions[count++] = n;
}

template <int D>
ARENITE_COLD Mat<double, D> Blocked<D>::projector() const {
  Mat<double, D> p;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      double blocked = 0;
      for (std::size_t k = 0; k < count; ++k) blocked += directions[k][i] * directions[k][j];
      p(i, j) = count == most ? 0 : (i == j ? 1 : 0) - blocked;
    }
  return p;
}

/// w's share of each direction, linear in u. A separate function, so that `lift` calls one: in a function that calls none
/// g++ 12 with AVX wrongly assumes that an array on the stack is aligned (its bug 109780).
template <int D>
ARENITE_COLD std::array<Vec<double, D>, Blocked<D>::most> Blocked<D>::shares(std::size_t of) const {
  std::array<Vec<double, D>, most> along;
  for (std::size_t k = 0; k < count; ++k) {
    along[k] = part[k] == of ? normals[k] : zeros<Vec<double, D>>();
    for (std::size_t j = 0; j < k; ++j) along[k] -= normals[k].dot(directions[j]) * along[j];
    along[k] /= normals[k].dot(directions[k]);
  }
  return along;
}

template <int D>
ARENITE_COLD Mat<double, D> Blocked<D>::lift(std::size_t of) const {
  const auto along = shares(of);
  Mat<double, D> all = zeros<Mat<double, D>>();
  for (std::size_t k = count; k-- > 0;)
    for (int column = 0; column < D; ++column)
      for (int row = 0; row < D; ++row)
        all(row, column) = directions[k][row] * along[k][column] + all(row, column);
  return all;
}

}  // namespace detail

template <int D>
ARENITE_COLD BoundaryNodes<D>::BoundaryNodes(const void* mesh, Index count, double epsilon)
    : mesh_{mesh}, epsilon_{epsilon}, position_(count), blocked_(count) {}

template <int D>
ARENITE_COLD void BoundaryNodes<D>::find_box() {
  for (int k = 0; k < D; ++k) {
    lower_[k] = std::numeric_limits<double>::infinity();
    upper_[k] = -lower_[k];
    for (Index i = 0; i < size(); ++i) {
      if (!is_used(i)) continue;
      lower_[k] = std::min(lower_[k], position_[i][k]);
      upper_[k] = std::max(upper_[k], position_[i][k]);
    }
  }
}

template <int D>
ARENITE_COLD double BoundaryNodes<D>::tolerance() const {
  V size;
  for (int k = 0; k < D; ++k) size[k] = upper_[k] - lower_[k];
  return 1e3 * epsilon_ * std::sqrt(dot(size, size));
}

#define ARENITE_INSTANCES(D)          \
  template struct detail::Blocked<D>; \
  template class BoundaryNodes<D>;
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
