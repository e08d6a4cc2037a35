// Motion of a mesh with a body: a zone that moves rigidly, a zone below it that is compressed and one above
// that is stretched.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include <arenite/core/name.hpp>
#include <arenite/core/refusals.hpp>
#include <arenite/mesh/mesh.hpp>
#include <arenite/mesh/rectilinear_grid.hpp>
#include <arenite/parallel/communicator.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A rigid body of the scene leads, by name or number. A leader has `travel(scene, axis, before, dt)`: its
/// travel along the axis since the start, m, where `before` is that of the previous step. A sum over points is
/// taken over all scenes, by `scene.communicator()`.
template <Name body = 0>
struct LedByRigid {
  template <class Scene, class T>
  T travel(const Scene& scene, int axis, T, T) const {
    return scene.template rigid<body>().displacement[axis];
  }
};
/// The mean velocity of a deformable body leads, by name or number.
template <Name which = 0>
struct LedByBody {
  template <class Scene, class T>
  T travel(const Scene& scene, int axis, T before, T dt) const {
    const auto& body = scene.template body<which>();
    double along = momentum(body)[axis], all = mass(body);
    sum_over(scene.communicator(), along, all);
    if (all == 0)
      throw run_error(joined_text(
          {"body ", which.word().empty() ? std::to_string(which.number) : std::string(which.word()),
           ", which leads the mesh, has lost all of its points"}));
    return before + static_cast<T>(static_cast<double>(dt) * along / all);
  }
};

/// Nodes of a simplex mesh, or lines of a `RectilinearGrid`, move along one axis by a share of the leader's
/// travel that depends on their initial place on the axis: 0 up to `fixed_below`, then linearly up to 1 at
/// `moving_from`, 1 up to `moving_to`, then linearly down to 0 at `fixed_above`; without the last two
/// everything above `moving_from` moves.
///
/// Values are checked when the scene is made, which throws `error`.
template <class Leader = LedByRigid<>>
struct MovingMesh {
  Leader leader{};
  double fixed_below = std::numeric_limits<double>::quiet_NaN();  ///< no motion below it, m; required, any
  double moving_from = std::numeric_limits<
      double>::quiet_NaN();  ///< its top, and what is above, moves, m; required, > fixed_below
  double moving_to = std::numeric_limits<double>::infinity();    ///< up to here, m, >= moving_from
  double fixed_above = std::numeric_limits<double>::infinity();  ///< no motion above it, m, > moving_to
  int axis = 1;                                                  ///< -, in [0, 2]
  double least = 0.05;  ///< share of its height that a zone keeps, -, in (0, 1); below it the run stops

  /// Share of the leader's travel by which a node at height y moves.
  double fraction(double y) const {
    if (y <= fixed_below || y >= fixed_above) return 0;
    if (y < moving_from) return (y - fixed_below) / (moving_from - fixed_below);
    if (y <= moving_to) return 1;
    return (fixed_above - y) / (fixed_above - moving_to);
  }
};

/// Throws `error` unless the zones of a motion in D dimensions are valid; returns it.
template <int D, class Leader>
const MovingMesh<Leader>& check_moving_mesh(const MovingMesh<Leader>& m) {
  require(m.axis >= 0 && m.axis < D, "MovingMesh.axis", m.axis, "must be an axis of the mesh");
  require(std::isfinite(m.fixed_below), "MovingMesh.fixed_below", m.fixed_below, "must be given");
  require(m.moving_from > m.fixed_below && std::isfinite(m.moving_from), "MovingMesh.moving_from",
          m.moving_from, "must be given, above fixed_below");
  require(m.moving_to >= m.moving_from, "MovingMesh.moving_to", m.moving_to,
          "must not lie below moving_from");
  const bool open = std::isinf(m.moving_to) && std::isinf(m.fixed_above);
  require(open || m.fixed_above > m.moving_to, "MovingMesh.fixed_above", m.fixed_above,
          "must lie above moving_to");
  require(open || std::isfinite(m.fixed_above), "MovingMesh.fixed_above", m.fixed_above,
          "must be given with moving_to");
  require(m.least > 0 && m.least < 1, "MovingMesh.least", m.least, "must lie in (0, 1)");
  return m;
}

/// Names the kind `OnlyOne` of parts that move the mesh: a scene has one at most.
struct MeshMotion;

/// A moving mesh in its mesh: reference positions and shares of the nodes that move, and the cells that
/// change their shape with them; of a grid those of the lines across the axis. A part that follows the
/// motion.
template <class M, class Leader>
class BoundMotion {
  static constexpr int D = M::dimension;
  using T = typename M::scalar;

 public:
  using OnlyOne = MeshMotion;
  static constexpr std::string_view state_name = "mesh_motion";
  static constexpr bool reads_start_state = false;

  /// Throws `error` for an invalid axis, height or share.
  BoundMotion(const MovingMesh<Leader>& motion, const M& mesh) : motion_{check_moving_mesh<D>(motion)} {
    if constexpr (is_simplex_mesh<M>)
      find_nodes(mesh);
    else
      for (const T y : mesh.lines(motion_.axis)) {
        reference_.push_back(y);
        fraction_.push_back(static_cast<T>(motion_.fraction(static_cast<double>(y))));
      }
  }

  int axis() const { return motion_.axis; }
  /// Travel of the leader since the start along the axis, m.
  T travel() const { return travel_; }

  template <class Scene>
  void follow_motion(Scene& scene, double dt) {
    try {
      move(scene.mesh, motion_.leader.travel(scene, motion_.axis, travel_, static_cast<T>(dt)));
    } catch (const run_error& e) {
      throw run_error(joined_text({"t = ", scene.time + dt, " s: ", e.what()}));
    }
  }
  template <class F>
  void visit_state(F&& f) {
    f("travel", travel_);
  }
  template <class Scene>
  void follow_state(Scene& scene) {
    move(scene.mesh, travel_);
  }

  /// Moves the mesh to a travel of the leader. Throws `run_error` where a zone is used up or a cell loses its
  /// volume.
  void move(M& mesh, T travel) {
    travel_ = travel;
    const double below = 1 + static_cast<double>(travel) / (motion_.moving_from - motion_.fixed_below);
    if (!(below > motion_.least))
      throw run_error(joined_text({"the compressing zone below ", motion_.moving_from,
                                   " m is used up after a travel of ", travel, " m: ", below * 100,
                                   " % of its height is left, the limit is ", motion_.least * 100, " %"}));
    if (std::isfinite(motion_.fixed_above)) {
      const double above = 1 - static_cast<double>(travel) / (motion_.fixed_above - motion_.moving_to);
      if (!(above > motion_.least))
        throw run_error(joined_text(
            {"the zone above ", motion_.moving_to, " m is used up after a travel of ", travel, " m"}));
    }
    if constexpr (is_simplex_mesh<M>)
      move_nodes(mesh, travel);
    else if (const Index bad =
                 mesh.move(motion_.axis, [&](Index i) { return reference_[i] + fraction_[i] * travel; });
             bad != none)
      throw run_error(joined_text({"line ", bad, " of the grid along axis ", motion_.axis,
                                   " met the one before after a travel of ", travel, " m"}));
  }

 private:
  void find_nodes(const M& mesh) {
    std::vector<bool> touched(mesh.cell_count());
    for (Index i = 0; i < mesh.node_count(); ++i) {
      const double s = motion_.fraction(static_cast<double>(mesh.position(i)[motion_.axis]));
      if (s == 0) continue;
      nodes_.push_back(i);
      for (const Index c : mesh.cells_at(i)) touched[c] = true;
    }
    fraction_.assign(mesh.node_count(), T(0));
    reference_.assign(mesh.node_count(), T(0));
    for (const Index i : nodes_) {
      reference_[i] = mesh.position(i)[motion_.axis];
      fraction_[i] = static_cast<T>(motion_.fraction(static_cast<double>(reference_[i])));
    }
    for (Index c = 0; c < mesh.cell_count(); ++c) {
      if (!touched[c]) continue;
      bool as_one = true;
      for (const Index i : mesh.nodes(c)) as_one = as_one && fraction_[i] == fraction_[mesh.nodes(c)[0]];
      if (!as_one) cells_.push_back(c);
    }
  }
  void move_nodes(M& mesh, T travel) {
    const Index bad = mesh.move(nodes_, cells_, [&](Index i) {
      auto x = mesh.position(i);
      x[motion_.axis] = reference_[i] + fraction_[i] * travel;
      return x;
    });
    if (bad != none)
      throw run_error(joined_text({"cell ", bad, " at ", vector_text(mesh.position(mesh.nodes(bad)[0])),
                                   " m turned inside out after a travel of ", travel, " m"}));
  }

  MovingMesh<Leader> motion_;
  std::vector<Index> nodes_;
  std::vector<Index> cells_;             // those whose shape changes
  std::vector<T> fraction_, reference_;  // [nodes of the mesh, or lines of the grid]
  T travel_ = 0;
};

namespace detail {
/// Replaces a motion that the compiler has refused.
struct NoMotion {
  static constexpr bool separates_bodies = false;
};
}  // namespace detail

template <class Leader, class Traits>
auto bind_part(const MovingMesh<Leader>& motion, const Traits& traits) {
  constexpr bool moves = is_simplex_mesh<typename Traits::Mesh> || is_rectilinear<typename Traits::Mesh>;
  static_assert(moves, ARENITE_SAYS_RESTING_GRID);
  if constexpr (moves)
    return BoundMotion<typename Traits::Mesh, Leader>(motion, traits.mesh);
  else
    return detail::NoMotion{};  // already reported
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
