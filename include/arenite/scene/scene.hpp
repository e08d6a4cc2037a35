// Scene: a tuple of values. Everything that a step reads and writes is a member here; what a scene does not
// name is empty.
#pragma once

#include <algorithm>
#include <array>
#include <tuple>
#include <type_traits>

#include <arenite/particles/measures.hpp>
#include <arenite/particles/relocate.hpp>
#include <arenite/scene/doubts.hpp>
#include <arenite/scene/parts.hpp>
#include <arenite/transfer/centred_stress.hpp>
#include <arenite/transfer/deform.hpp>
#include <arenite/transfer/light_nodes.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/remap.hpp>
#include <arenite/transfer/scatter.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Sums over all steps; energies in J. Computed only in a scene with `TrackEnergy`.
struct Ledger {
  double initial_kinetic = 0;  ///< of bodies and rigid bodies
  double initial_strain = 0;   ///< recoverable, from initial stresses
  double stress_work = 0;      ///< work of the stresses: stored or used up plastically
  double gravity_work = 0;     ///< of gravity on the bodies
  double contact_dissipation = 0;
};

namespace detail {

template <class M, ExtraColumns Extra, class F>
struct body_of;
template <class M, ExtraColumns Extra, class R, class L>
struct body_of<M, Extra, Fill<R, L>> {
  using type = Body<L, typename M::scalar, M::dimension, Extra>;
};
template <class M, ExtraColumns Extra, class B>
struct bodies_of;
template <class M, ExtraColumns Extra, class... F>
struct bodies_of<M, Extra, Bodies<F...>> {
  using type = std::tuple<typename body_of<M, Extra, F>::type...>;
};

template <class M, class S>
struct bound_surface;
template <class M>
struct bound_surface<M, MeshSurface> {
  static_assert(is_simplex_mesh<M>,
                "Rigid: a MeshSurface needs a simplex mesh; on a grid use a DistanceSurface");
  using type = BoundMeshSurface<typename M::scalar, M::dimension>;
};
template <class M, class D>
struct bound_surface<M, DistanceSurface<D>> {
  using type = BoundDistanceSurface<typename M::scalar, M::dimension, D>;
};
template <class M, class R>
struct rigids_of;
template <class M, class... R>
struct rigids_of<M, Rigids<R...>> {
  using type = std::tuple<
      RigidBody<typename M::scalar, M::dimension, typename bound_surface<M, typename R::Surface>::type,
                typename R::Motion, typename R::Coupling>...>;
};

template <class M, class Motion>
struct bound_motion {
  using type = FixedMesh;
};
template <class M, class L>
struct bound_motion<M, MovingMesh<L>> {
  static_assert(is_simplex_mesh<M>, "MovingMesh: only a simplex mesh moves");
  using type = BoundMotion<M::dimension, typename M::scalar, L>;
};

template <class T, int D, class C>
struct normal_map {
  struct type {};
};
template <class T, int D>
struct normal_map<T, D, Coulomb<SurfaceOf>> {
  using type = NormalMap<T, D>;
};

}  // namespace detail

/// A scene of kinematics K, mesh M, numerics N and parts: `bodies(..)` (required), `walls(..)`,
/// `gravity({..})`, a contact policy, `rigids(..)`, a `MovingMesh`, `TrackEnergy{}`. Complete when
/// constructed: filled, walls resolved, surfaces found. Warns (`on_warning`) of a box that reaches beyond the
/// mesh, of bodies that lie in one place, and of gravity that nothing holds against.
template <class K, class M, class N, class... Parts>
struct Scene {
  static_assert(kinematics<K>,
                "Scene: the first value must be the kinematics: PlaneStrain, Axisymmetric or Solid");
  static_assert(mesh<M>, "Scene: the second value must be a mesh: a CartesianGrid or a SimplexMesh");
  static_assert(M::dimension == K::dimension, "Scene: mesh and kinematics must have the same dimension");
  static_assert(shape_function<typename N::Shape, M>,
                "Scene: the shape function does not fit the mesh: LinearSimplex goes with SimplexMesh, "
                "QuadraticBSpline with "
                "CartesianGrid");
  static_assert((detail::is_part<Parts> && ...),
                "Scene: a part is not known; parts are bodies(..), walls(..), gravity({..}), OneField, "
                "Coulomb, rigids(..), "
                "MovingMesh and TrackEnergy");
  static_assert(detail::count_parts<detail::is_bodies, Parts...> == 1,
                "Scene: exactly one bodies(..) is needed");
  static_assert(detail::count_parts<detail::is_walls, Parts...> <= 1 &&
                    detail::count_parts<detail::is_gravity, Parts...> <= 1 &&
                    detail::count_parts<detail::is_rigids, Parts...> <= 1 &&
                    detail::count_parts<detail::is_contact_part, Parts...> <= 1 &&
                    detail::count_parts<detail::is_motion, Parts...> <= 1,
                "Scene: each kind of part may be given once");

  using Kinematics = K;
  using Mesh = M;
  using NumericsType = N;
  using T = typename M::scalar;
  static constexpr int D = M::dimension;
  using Shape = typename N::Shape;
  using Contact = detail::picked<detail::is_contact_part, OneField, Parts...>;
  using BodyTuple = typename detail::bodies_of<M, N::extra_columns,
                                               detail::picked<detail::is_bodies, Bodies<>, Parts...>>::type;
  using RigidTuple =
      typename detail::rigids_of<M, detail::picked<detail::is_rigids, Rigids<>, Parts...>>::type;
  using Motion =
      typename detail::bound_motion<M, detail::picked<detail::is_motion, FixedMesh, Parts...>>::type;
  using Field = NodeField<T, D, N::remaps, Contact::needs_mass_gradient>;
  static constexpr std::size_t body_count = std::tuple_size_v<BodyTuple>;
  static constexpr std::size_t rigid_count = std::tuple_size_v<RigidTuple>;
  static constexpr std::size_t field_count = Contact::separate ? body_count : 1;
  static constexpr bool moves = !std::same_as<Motion, FixedMesh>;
  static constexpr bool tracks_energy = detail::count_parts<detail::is_ledger, Parts...> > 0;
  /// Whether stresses are taken at the middle of the step: where all laws are linear (see `add_half_step`).
  static constexpr bool centres_stress = []<class... B>(std::type_identity<std::tuple<B...>>) {
    return N::template centres_stress<decltype(B::law)...>;
  }(std::type_identity<BodyTuple>{});
  static_assert(body_count >= 1, "Scene: bodies(..) needs at least one fill(..)");
  static_assert(!std::same_as<Contact, Coulomb<SurfaceOf>> || body_count == 2,
                "Scene: Coulomb contact with SurfaceOf is between two bodies; for more use MassGradient");

  /// Node field of a body.
  static constexpr std::size_t field_of(std::size_t body) { return Contact::separate ? body : 0; }

  Scene(K kinematics_value, M mesh_value, N numerics_value, Parts... parts)
      : kinematics{kinematics_value},
        mesh{std::move(mesh_value)},
        numerics{numerics_value},
        blocks{make_blocks(mesh)},
        fields{make_fields(std::make_index_sequence<field_count>{})},
        bodies{make_bodies(detail::pick<detail::is_bodies, Bodies<>>(parts...))},
        constraints{resolve<Shape>(detail::pick<detail::is_walls, Walls>(parts...), mesh, K::hoop)},
        contact{detail::pick<detail::is_contact_part, OneField>(parts...)},
        rigids{make_rigids(detail::pick<detail::is_rigids, Rigids<>>(parts...))},
        motion{make_motion(detail::pick<detail::is_motion, FixedMesh>(parts...))} {
    share_out();
    for_each_body([&](auto& body, const auto&) { body.points.settle(body.cells, blocks); });
    numerics.transfer.check();
    numerics.anti_locking.check();
    const auto g = detail::pick<detail::is_gravity, Gravity>(parts...).g;
    for (std::size_t k = 0; k < 3; ++k) {
      require(std::isfinite(g[k]), "gravity", g[k], "must be finite");
      if (k < D)
        gravity[static_cast<int>(k)] = static_cast<T>(g[k]);
      else
        require(g[k] == 0, "gravity", g[k], "must be zero along an axis that the scene does not have");
    }
    if constexpr (tracks_energy) {
      for_each_body([&](const auto& body, const auto&) {
        ledger.initial_kinetic += kinetic_energy(body);
        ledger.initial_strain += strain_energy(body);
      });
      for_each_rigid([&](const auto& body) { ledger.initial_kinetic += body.kinetic_energy(); });
    }
    if constexpr (std::same_as<Contact, Coulomb<SurfaceOf>>) {
      require(contact.normals.body < 2, "SurfaceOf.body", contact.normals.body, "must be 0 or 1");
      const auto surface = surface_of<K>(mesh, contact.normals.region, constraints);
      normals.body = contact.normals.body;
      normals.out.assign(mesh.node_count(), Vec<T, D>::Zero());
      for (std::size_t k = 0; k < surface.nodes.size(); ++k)
        normals.out[surface.nodes[k]] = surface.normals[k];
    }
    detail::doubt(*this, detail::pick<detail::is_bodies, Bodies<>>(parts...).fills);
  }

  K kinematics;
  M mesh;
  N numerics;
  Blocks blocks;                              ///< colours of the mesh's cells
  std::array<Field, field_count> fields;      ///< node fields: one, or one a body
  BodyTuple bodies;                           ///< deformable bodies
  std::vector<Constraint<T, D>> constraints;  ///< from the walls
  Contact contact;
  RigidTuple rigids;
  [[no_unique_address]] Motion motion;
  Vec<T, D> gravity = Vec<T, D>::Zero();  ///< m/s2
  [[no_unique_address]] typename detail::normal_map<T, D, Contact>::type normals{};
  [[no_unique_address]] std::conditional_t<N::AntiLocking::averages_strain, VolumetricAverage<T>,
                                           detail::Nothing>
      average{};
  [[no_unique_address]] std::conditional_t<N::smooths_light_nodes, LightNodes<T, D>, detail::Nothing>
      light_nodes{};
  [[no_unique_address]] std::conditional_t<tracks_energy, Ledger, NoLedger> ledger{};

  double time = 0;       ///< s
  double time_step = 0;  ///< of the last step, s
  std::size_t steps = 0;
  bool finite = true;  ///< no number of the points, nor their sums, have become NaN or infinite
  /// Impulse that contact with other bodies gave each deformable body in the last step, N s.
  [[no_unique_address]] std::conditional_t<Contact::separate, std::array<Vec<T, D>, body_count>,
                                           detail::Nothing>
      contact_impulse{};
  /// MUSL: bodies that pushed on each other in the last step, node by node.
  [[no_unique_address]] std::conditional_t<Contact::separate && N::remaps, std::vector<ContactPair<T, D>>,
                                           NoContactPairs>
      contact_pairs{};
  ContactTally contact_tally;   ///< of the last step
  std::size_t limited = 0;      ///< node velocities scaled down by the velocity limit since the start
  double limited_momentum = 0;  ///< momentum that this took, N s
  Vec<T, D> wall_impulse = Vec<T, D>::Zero();  ///< that the walls gave since the start, N s

  /// Calls `f(body, field)` for each deformable body and its node field.
  template <class F>
  void for_each_body(F&& f) {
    each_body(*this, f, std::make_index_sequence<body_count>{});
  }
  template <class F>
  void for_each_body(F&& f) const {
    each_body(*this, f, std::make_index_sequence<body_count>{});
  }
  template <class F>
  void for_each_rigid(F&& f) {
    std::apply([&](auto&... r) { (f(r), ...); }, rigids);
  }
  template <class F>
  void for_each_rigid(F&& f) const {
    std::apply([&](const auto&... r) { (f(r), ...); }, rigids);
  }

  /// Gives each thread cells with as many points as the others'.
  void share_out() {
    blocks.share_out([&](Index c) {
      std::size_t n = 0;
      for_each_body([&](const auto& body, const auto&) { n += body.cells[c].size(); });
      return n;
    });
  }

  std::size_t point_count() const {
    std::size_t n = 0;
    for_each_body([&](const auto& body, const auto&) { n += body.points.size(); });
    return n;
  }
  std::size_t lost_points() const {
    std::size_t n = 0;
    for_each_body([&](const auto& body, const auto&) { n += body.lost; });
    return n;
  }

 private:
  static Blocks make_blocks(const M& mesh) {
    Index size;
    if constexpr (is_simplex_mesh<M>) {
      // Long runs of points, which memory serves best, but blocks enough to share out.
      size = std::clamp<Index>(mesh.cell_count() / 128, 24, 800);
    } else {
      // Two layers of cells: a block then shares nodes with its two neighbours alone, so that two colours are
      // enough.
      size = 2 * mesh.cell_count() / mesh.cells(D - 1);
    }
    return Blocks(mesh.cell_count(), Shape::node_count(mesh), size,
                  [&](Index c) { return typename Shape::template Cell<M>(mesh, c).nodes; });
  }

  template <std::size_t... I>
  std::array<Field, field_count> make_fields(std::index_sequence<I...>) const {
    return {((void)I, Field(Shape::node_count(mesh)))...};
  }

  template <class... F>
  BodyTuple make_bodies(const Bodies<F...>& recipe) const {
    return std::apply(
        [&](const auto&... fill) { return BodyTuple{make_body<K, N::extra_columns>(mesh, fill)...}; },
        recipe.fills);
  }

  template <class R>
  auto make_rigid(const R& recipe) const {
    using Surface = typename detail::bound_surface<M, typename R::Surface>::type;
    recipe.motion.check();
    const auto bind = [&] {
      if constexpr (std::same_as<typename R::Surface, MeshSurface>)
        return Surface(surface_of<K>(mesh, recipe.surface.region, constraints));
      else
        return Surface(recipe.surface);
    };
    RigidBody<T, D, Surface, typename R::Motion, typename R::Coupling> body{bind(), recipe.motion,
                                                                            recipe.friction};
    if constexpr (R::Motion::free) {
      for (std::size_t k = 0; k < D; ++k)
        body.axis[static_cast<int>(k)] = static_cast<T>(recipe.motion.axis[k]);
      require(body.axis.norm() > 0, "Guided.axis", body.axis.transpose(),
              "must have a length in the scene's dimensions");
      require(!K::hoop || body.axis[0] == 0, "Guided.axis", body.axis.transpose(),
              "must be the axis of symmetry (0, 1) in an axisymmetric scene");
      body.axis.normalize();
      body.velocity = static_cast<T>(recipe.motion.velocity) * body.axis;
    }
    return body;
  }

  template <class... R>
  RigidTuple make_rigids(const Rigids<R...>& recipe) const {
    return std::apply([&](const auto&... r) { return RigidTuple{make_rigid(r)...}; }, recipe.bodies);
  }

  template <class P>
  Motion make_motion(const P& part) const {
    if constexpr (moves) {
      static_assert(P::Leader::index < (P::Leader::rigid ? rigid_count : body_count),
                    "MovingMesh: the leader must be a body of the scene");
      return Motion(part, mesh);
    } else {
      return {};
    }
  }

  template <class Self, class F, std::size_t... I>
  static void each_body(Self& self, F& f, std::index_sequence<I...>) {
    (f(std::get<I>(self.bodies), self.fields[field_of(I)]), ...);
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
