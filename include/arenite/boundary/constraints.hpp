// Constraints: nodes that may not move freely. Parts name the directions that they block; what several parts
// block at one node becomes one projector, so that their order does not matter.
#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <arenite/core/alone.hpp>
#include <arenite/core/error.hpp>
#include <arenite/mesh/mesh.hpp>
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
  Vec<T, D> target = Vec<T, D>::Zero();  ///< lift times the part's velocity now, m/s
};

namespace detail {

/// Blocked directions at a node: as they were named, and as an orthonormal set.
template <int D>
struct Blocked {
  Mat<double, D> named = Mat<double, D>::Zero(), directions = named;  // columns
  std::array<std::size_t, static_cast<std::size_t>(D)> part{};        // that named each
  int count = 0;

  void add(Vec<double, D> n, std::size_t by) {
    n.normalize();
    const Vec<double, D> name = n;
    for (int pass = 0; pass < 2; ++pass)
      for (int k = 0; k < count; ++k) n -= directions.col(k).dot(n) * directions.col(k);
    if (count == D || !(n.norm() > 1e-6)) return;
    named.col(count) = name;
    part[static_cast<std::size_t>(count)] = by;
    directions.col(count++) = n.normalized();
  }
  Mat<double, D> projector() const {
    if (count == D) return Mat<double, D>::Zero();
    Mat<double, D> p;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        double blocked = 0;
        for (int k = 0; k < count; ++k) blocked += directions(i, k) * directions(j, k);
        p(i, j) = (i == j ? 1 : 0) - blocked;
      }
    return p;
  }
  /// Takes a part's velocity u to the one blocked velocity w with n . w = n . u along what the part named and
  /// n . w = 0 along what others did.
  Mat<double, D> lift(std::size_t of) const {
    Mat<double, D> along = Mat<double, D>::Zero();  // rows: w's share of each direction, linear in u
    for (int k = 0; k < count; ++k) {
      if (part[static_cast<std::size_t>(k)] == of) along.row(k) = named.col(k).transpose();
      for (int j = 0; j < k; ++j) along.row(k) -= named.col(k).dot(directions.col(j)) * along.row(j);
      along.row(k) /= named.col(k).dot(directions.col(k));
    }
    return directions * along;
  }
};

}  // namespace detail

/// The nodes of a mesh, to which parts add what they block.
template <class Shape, class M>
class NodeConstraints {
 public:
  using T = typename M::scalar;
  static constexpr int D = M::dimension;
  using V = Vec<double, D>;

  explicit NodeConstraints(const M& mesh)
      : mesh_{mesh}, position_(Shape::node_count(mesh)), blocked_(position_.size()) {
    for (Index i = 0; i < size(); ++i) {
      position_[i] = Shape::node_position(mesh, i).template cast<double>();
      if (!is_used(i)) continue;
      lower_ = lower_.cwiseMin(position_[i]);
      upper_ = upper_.cwiseMax(position_[i]);
    }
    if constexpr (!is_simplex_mesh<M>)  // a shape function may have nodes beyond the faces
      for (int k = 0; k < D; ++k) {
        lower_[k] = static_cast<double>(mesh.lower()[k]);
        upper_[k] = static_cast<double>(mesh.upper(k));
      }
  }

  /// The mesh is a part of a larger one, with the corners of the box around that.
  void set_whole(const V& lower, const V& upper) {
    lower_ = lower;
    upper_ = upper;
    is_part_ = true;
  }
  /// Whether it is: a wall may then catch no node.
  bool is_part() const { return is_part_; }

  const M& mesh() const { return mesh_; }
  Index size() const { return static_cast<Index>(position_.size()); }
  /// Whether a cell has node i: a mesher may leave nodes without cells behind.
  bool is_used([[maybe_unused]] Index i) const {
    if constexpr (is_simplex_mesh<M>) return !mesh_.cells_at(i).empty();
    return true;
  }
  const V& position(Index i) const { return position_[i]; }  ///< m
  const V& lower() const { return lower_; }  ///< corners of the grid, or of the box around the used nodes, m
  const V& upper() const { return upper_; }
  /// Positions closer than this count as equal, m.
  double near() const {
    return 1e3 * static_cast<double>(std::numeric_limits<T>::epsilon()) * (upper_ - lower_).norm();
  }

  /// Blocks the velocity of node i along a direction of any length.
  void block(Index i, const V& direction) { blocked_[i].add(direction, part_); }

  /// Calls `constrain` of part number k.
  template <class Part>
  void add(const Part& part, std::size_t k = 0) {
    part_ = k;
    part.constrain(*this);
  }

  /// What is blocked at node i.
  const detail::Blocked<D>& blocked(Index i) const { return blocked_[i]; }

  /// The constrained nodes, ascending.
  std::vector<Constraint<T, D>> constraints() const {
    std::vector<Constraint<T, D>> all;
    for (Index i = 0; i < size(); ++i)
      if (blocked_[i].count > 0) all.push_back({i, blocked_[i].projector().template cast<T>()});
    return all;
  }
  /// The nodes that part number k moves, ascending.
  std::vector<Drive<T, D>> drives(std::size_t k) const {
    std::vector<Drive<T, D>> all;
    for (Index i = 0; i < size(); ++i)
      if (const Mat<double, D> lift = blocked_[i].lift(k); lift.norm() > 0)
        all.push_back({i, k, lift.template cast<T>()});
    return all;
  }

 private:
  const M& mesh_;
  std::vector<V> position_;
  std::vector<detail::Blocked<D>> blocked_;
  V lower_ = V::Constant(std::numeric_limits<double>::infinity()), upper_ = -lower_;
  std::size_t part_ = 0;
  bool is_part_ = false;
};

/// What parts (`Walls`, kinematics, ..) block on a mesh, as constrained nodes, ascending.
template <class Shape, class M, class... Parts>
std::vector<Constraint<typename M::scalar, M::dimension>> resolve(const M& mesh, const Parts&... parts) {
  NodeConstraints<Shape, M> nodes(mesh);
  (nodes.add(parts), ...);
  return nodes.constraints();
}

/// Nobody asks for the impulses of single nodes.
struct NoTaker {
  template <class V>
  constexpr void operator()(Index, const V&) const {}
};

/// Removes the blocked part of the velocities of a field. Returns the impulse that this gave to the nodes
/// that `owns(node)`, N s; `take(node, impulse)` gets that of each.
template <class T, int D, class Velocities, class Owns = OwnsAll, class Take = NoTaker>
Vec<T, D> constrain(const std::vector<Constraint<T, D>>& constraints, const std::vector<T>& mass,
                    Velocities& velocity, const Owns& owns = {}, const Take& take = {}) {
  Vec<T, D> impulse = Vec<T, D>::Zero();
  for (const auto& c : constraints) {
    const Vec<T, D> allowed = c.projector * velocity[c.node];
    if (mass[c.node] > 0 && owns(c.node)) {
      const Vec<T, D> given = mass[c.node] * (allowed - velocity[c.node]);
      impulse += given;
      take(c.node, given);
    }
    velocity[c.node] = allowed;
  }
  return impulse;
}

/// The same with nodes that are driven to their targets. Returns the work of the drives, J, too.
template <class T, int D, class Velocities, class Owns = OwnsAll, class Take = NoTaker>
std::pair<Vec<T, D>, double> constrain(const std::vector<Constraint<T, D>>& constraints,
                                       const std::vector<Drive<T, D>>& drives, const std::vector<T>& mass,
                                       Velocities& velocity, const Owns& owns = {}, const Take& take = {}) {
  double work = 0;  // impulses of a node times its target: what is allowed is normal to both
  const auto book = [&](T sign) {
    for (const auto& d : drives)
      if (owns(d.node)) work += static_cast<double>(sign * mass[d.node] * d.target.dot(velocity[d.node]));
  };
  book(-1);
  Vec<T, D> impulse = constrain(constraints, mass, velocity, owns, take);
  for (const auto& d : drives) {
    velocity[d.node] += d.target;
    if (mass[d.node] == 0 || !owns(d.node)) continue;
    const Vec<T, D> given = mass[d.node] * d.target;
    impulse += given;
    take(d.node, given);
  }
  book(1);
  return {impulse, work};
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
