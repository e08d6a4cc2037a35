// Scene: a tuple of values. Everything that a step reads and writes is a member here; what a scene does not
// name is not there.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <type_traits>

#include <arenite/boundary/constraints.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/mesh/portion.hpp>
#include <arenite/parallel/communicator.hpp>
#include <arenite/part/complete.hpp>
#include <arenite/part/contact_tally.hpp>
#include <arenite/part/parts.hpp>
#include <arenite/part/roles.hpp>
#include <arenite/particles/measures.hpp>
#include <arenite/particles/relocate.hpp>
#include <arenite/transfer/g2p.hpp>
#include <arenite/transfer/light_nodes.hpp>
#include <arenite/transfer/map_back.hpp>
#include <arenite/transfer/node_correction.hpp>
#include <arenite/transfer/numerics.hpp>
#include <arenite/transfer/p2g.hpp>
#include <arenite/transfer/simplex/centred_stress.hpp>
#include <arenite/warnings/ground_at_rest.hpp>
#include <arenite/warnings/new_scene.hpp>
#include <arenite/warnings/step_check.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A scene of kinematics K, mesh M, numerics N and, in any order, `bodies(..)` (required) and parts: those of
/// the library (`walls(..)`, `gravity({..})`, `Coulomb`, `rigids(..)`, `MovingMesh`, `TrackEnergy{}`) and any
/// of your own (`part/roles.hpp`). Complete when constructed: filled, parts bound, surfaces found. Warns
/// (`on_warning`) of a box that reaches beyond the mesh, of points with another mass than their region's, of
/// bodies that overlap, and of gravity on bodies without support; its first step warns of geostatic
/// ground that is not at rest. Throws `error` where a recipe does not fit the mesh, naming value and rule.
template <class K, class M, class N, class... Given>
struct Scene {
  static_assert(shared_detail::is_complete_scene<K, M, N, Given...>());

  using Kinematics = K;
  using Mesh = M;
  using NumericsType = N;
  using T = typename M::scalar;
  static constexpr int D = M::dimension;
  using V = Vec<T, D>;
  using Shape = typename N::Shape;
  using Nodes = NodeConstraints<Shape, M>;

 private:
  using Fills = std::remove_cvref_t<decltype(shared_detail::find_bodies(std::declval<const Given&>()...))>;
  /// All values given except the bodies; the kinematics, too, if they are a part.
  using Recipes = typename decltype(shared_detail::with_recipes_of(
      shared_detail::TypesOf{}, std::declval<const K&>(), std::declval<const Given&>()...))::type;

 public:
  static constexpr std::size_t body_count = Fills::count;  ///< perhaps `counted_at_run_time`
  static_assert(body_count >= 1, "Scene: bodies(..) needs at least one fill(..)");
  using TraitsType = SceneTraits<K, M, N, body_count>;
  using Parts =
      decltype(shared_detail::with_recipes_of(std::declval<const shared_detail::Binder<TraitsType>&>(),
                                              std::declval<const K&>(), std::declval<const Given&>()...));
  static constexpr std::size_t part_count = std::tuple_size_v<Parts>;
  static_assert(
      shared_detail::singles<Parts>,
      "Scene: gravity, contact of bodies, motion of the mesh and TrackEnergy may be given once each");

  using Needs = shared_detail::needs_of<Parts>;
  static constexpr ExtraColumns extra_columns{N::extra_columns.affine, N::extra_columns.dilation,
                                              Needs::point_ids, Needs::point_columns};

 private:
  using BodiesOf = shared_detail::bodies_of<M, extra_columns, Fills>;

 public:
  using BodyTuple = typename BodiesOf::type;
  static_assert(!BodiesOf::template are_laws<T> || BodiesOf::template take_lanes<N>,
                "law: update must take packs of points, not double alone: template <class T, int D> T "
                "update(Sym<T, D>& stress, const StrainStep<T, D>& step, History<T>& history) const; or say "
                "static constexpr int max_pack_width = 1 in the law");
  static constexpr auto body_names = BodiesOf::names;  ///< empty where a body has none
  static_assert(shared_detail::differ(body_names), "Scene: two bodies have one name: fill<\"name\">(..)");
  static_assert(shared_detail::differ(shared_detail::rigids_of<Parts>::found.second),
                "Scene: two rigid bodies have one name: rigid<\"name\">(..)");
  /// Whether the mesh is a part of a larger one, which other scenes share (`on_portion`).
  static constexpr bool is_portion =
      shared_detail::place_of<OnPortion>(std::type_identity<Recipes>{}) < part_count;
  static constexpr std::size_t field_count = Needs::own_fields ? body_count : 1;
  /// Whether the bodies are those of a list: of one law, in a number that only a run knows.
  static constexpr bool lists_bodies = body_count == counted_at_run_time;
  static constexpr std::size_t rigid_count = shared_detail::rigids_of<Parts>::count;
  /// Whether nodes store the velocity at the start of the step and the force separately.
  static constexpr bool has_start_state = N::reads_start_state || Needs::start_state;
  using Field = NodeField<T, D, N::maps_back, Needs::mass_gradient, N::corrects_nodes, has_start_state>;
  /// Whether the stresses of the bodies in a node field are those at mid-step: where all their
  /// laws are linear (see `add_half_step`).
  static constexpr bool centres_stress(std::size_t field) {
    return BodiesOf::template centres_stress<N, Needs::own_fields>(field);
  }
  /// Whether those of any field are.
  static constexpr bool centres_any_stress = [] {
    bool any = false;
    for (std::size_t f = 0; f < (lists_bodies ? 1 : field_count); ++f) any = any || centres_stress(f);
    return any;
  }();

  /// Node field of a body.
  static constexpr std::size_t field_of(std::size_t body) { return Needs::own_fields ? body : 0; }

  /// The types given may have arguments that the scene's type omits (`type_erased_t`).
  template <class... G>
  requires(std::same_as<std::tuple<type_erased_t<G>...>, std::tuple<Given...>>)
      Scene(K kinematics_value, M mesh_value, N numerics_value, const G&... given)
      : Scene(Nothing{}, std::move(kinematics_value), std::move(mesh_value), numerics_value,
              type_erased<M>(given)...) {}

  K kinematics;
  M mesh;
  N numerics;
  Blocks blocks;  ///< colours of the mesh's cells
  [[no_unique_address]] Parts
      parts;  ///< the recipes bound to this mesh, in the order given; then the kinematics, if a part
  ByBody<Field, field_count> fields;          ///< node fields: one, or one a body
  std::vector<GroundAtRest> at_rest;          ///< bodies that the first step checks
  BodyTuple bodies;                           ///< deformable bodies: a tuple, or a vector
  std::vector<Constraint<T, D>> constraints;  ///< of all parts
  [[no_unique_address]] std::conditional_t<Needs::drives, std::vector<Drive<T, D>>, Nothing>
      drives{};  ///< nodes that parts move
  [[no_unique_address]] typename N::template StrainAverage<T> average{};
  [[no_unique_address]] std::conditional_t<N::smooths_light_nodes, LightNodes<T, D>, Nothing> light_nodes{};

  double time = 0;       ///< s
  double time_step = 0;  ///< of the last step, s
  std::size_t steps = 0;
  StepCheck step_check;  ///< of the lengths of steps
  [[no_unique_address]] std::conditional_t<is_portion, std::optional<shared_detail::NewScene>, Nothing>
      unseen;                   ///< over a portion of a mesh: data for warnings not given yet
  bool finite = true;           ///< no number of the points, nor their sums, have become NaN or infinite
  ContactTally contact_tally;   ///< of the last step
  std::size_t limited = 0;      ///< node velocities scaled down by the velocity limit since the start
  double limited_momentum = 0;  ///< momentum that this took, N s
  V wall_impulse = zeros<V>();  ///< that constraints gave since the start, N s
  double driving_work = 0;      ///< of the parts that move nodes, since the start, J

  /// Calls `f(body, field)` for each deformable body and its node field.
  template <class F>
  void for_each_body(F&& f) {
    each_body(*this, f);
  }
  template <class F>
  void for_each_body(F&& f) const {
    each_body(*this, f);
  }
  /// Calls `f(part)` for each part, in order.
  template <class F>
  void for_each_part(F&& f) {
    each_part(*this, f, std::make_index_sequence<part_count>{});
  }
  template <class F>
  void for_each_part(F&& f) const {
    each_part(*this, f, std::make_index_sequence<part_count>{});
  }
  /// Calls `f(body)` for each rigid body.
  template <class F>
  void for_each_rigid(F&& f) {
    for_each_part([&](auto& part) {
      if constexpr (shared_detail::is_rigid<std::remove_cvref_t<decltype(part)>>) f(part);
    });
  }
  template <class F>
  void for_each_rigid(F&& f) const {
    for_each_part([&](const auto& part) {
      if constexpr (shared_detail::is_rigid<std::remove_cvref_t<decltype(part)>>) f(part);
    });
  }

  std::size_t number_of_bodies() const {
    if constexpr (lists_bodies)
      return bodies.size();
    else
      return body_count;
  }
  /// A deformable body of a list.
  auto& body(std::integral auto number) requires lists_bodies { return listed(*this, number); }
  const auto& body(std::integral auto number) const requires lists_bodies { return listed(*this, number); }
  /// A deformable body: `body<"sand">()`, `body<0>()`, or `body()`, the only one.
  template <Name which = "">
  auto& body() {
    return body_of<which>(*this);
  }
  template <Name which = "">
  const auto& body() const {
    return body_of<which>(*this);
  }
  /// A rigid body: `rigid<"cone">()`, `rigid<0>()`, or `rigid()`, the only one.
  template <Name which = "">
  auto& rigid() {
    return std::get<rigid_place<which>()>(parts);
  }
  template <Name which = "">
  const auto& rigid() const {
    return std::get<rigid_place<which>()>(parts);
  }
  /// The first part that a recipe made: `part<TrackEnergy>()`, `part<Coulomb>()`.
  template <class Recipe>
  auto& part() {
    return std::get<part_place<shared_detail::place_of<Recipe>(std::type_identity<Recipes>{})>()>(parts);
  }
  template <class Recipe>
  const auto& part() const {
    return std::get<part_place<shared_detail::place_of<Recipe>(std::type_identity<Recipes>{})>()>(parts);
  }
  template <template <class...> class Recipe>
  auto& part() {
    return std::get<part_place<shared_detail::place_of<Recipe>(std::type_identity<Recipes>{})>()>(parts);
  }
  template <template <class...> class Recipe>
  const auto& part() const {
    return std::get<part_place<shared_detail::place_of<Recipe>(std::type_identity<Recipes>{})>()>(parts);
  }
  template <class Recipe>
  static constexpr bool has_part =
      shared_detail::place_of<Recipe>(std::type_identity<Recipes>{}) < part_count;

  template <Name which>
  static constexpr bool has_rigid = shared_detail::number_among(shared_detail::rigids_of<Parts>::found.second,
                                                                which.word(), which.number) < rigid_count;
  template <Name which>
  static constexpr std::size_t body_number() {
    return body_place<which>();
  }

  /// Number of a body; throws `error` that names the `option` if the scene has no such body.
  std::size_t number_of(const BodyName& name, std::string_view option) const {
    const std::size_t k = shared_detail::number_among(BodiesOf::names, name.word, name.number);
    const std::string shown = name.word.empty() ? std::to_string(name.number) : name.word;
    require(k < number_of_bodies(), option, shown, "must be the number or the name of a body of the scene");
    return k;
  }
  /// A body in messages: its name, or its number if it has none.
  static std::string body_name(std::size_t body) {
    const std::string_view name = body < body_names.size() ? body_names[body] : std::string_view();
    return joined_text({name.empty() ? TextPart(body) : TextPart(name)});
  }

  /// Over a portion of a mesh: gives the warnings about a new scene, once; all scenes over the mesh ask at once.
  void warn_when_new() requires is_portion {
    if (communicator().least(unseen ? 1 : 0) == 1) shared_detail::warn_about_new_scene(*this, *unseen);
    unseen.reset();
  }
  template <class Self = Scene>  // only asked for where there is one
  const auto& portion() const {
    return static_cast<const Self&>(*this).template part<OnPortion>().portion;
  }
  /// Communicator of the scenes on all portions of the mesh, for sums; `Serial` where the mesh is whole.
  const auto& communicator() const {
    if constexpr (is_portion)
      return part<OnPortion>().communicator;
    else
      return serial;
  }
  /// `owns(node)`, `owns(cell)`: whether this scene counts a node in sums, and has the points of a cell.
  auto node_owner() const {
    if constexpr (is_portion)
      return [this](Index i) { return portion().owns_node(i); };
    else
      return OwnsAll{};
  }
  auto cell_owner() const {
    if constexpr (is_portion)
      return OwnedCells<D>{portion()};
    else
      return OwnsAllCells{};
  }

  /// Sum of the parts' accelerations now, m/s2.
  V acceleration() const {
    V sum = zeros<V>();
    for_each_part([&](const auto& part) {
      if constexpr (accelerates<std::remove_cvref_t<decltype(part)>, Scene>) {
        const V own = part.acceleration(time);
        for (int k = 0; k < D; ++k) sum[k] += own[k];
      }
    });
    return sum;
  }

  /// Gives each thread cells with an equal number of points.
  void balance_threads() {
    blocks.balance_threads([&](Index c) {
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
  template <Name which, class Self>
  static auto& body_of(Self& self) {
    constexpr std::size_t place = body_place<which>();
    if constexpr (lists_bodies)
      return self.bodies[place];  // already reported
    else
      return std::get<place>(self.bodies);
  }
  template <Name which>
  static constexpr std::size_t body_place() {
    static_assert(!lists_bodies, "Scene: the bodies of a list are numbered at run time: say body(number)");
    constexpr std::size_t k = shared_detail::number_among(BodiesOf::names, which.word(), which.number);
    static_assert(k < body_count,
                  "Scene: no such body; say body<\"name\">() of fill<\"name\">(..), or "
                  "body<number>(); body() is the only one");
    return k < body_count && !lists_bodies ? k : 0;  // already reported
  }
  template <Name which>
  static constexpr std::size_t rigid_place() {
    constexpr auto found = shared_detail::rigids_of<Parts>::found;
    constexpr std::size_t k = shared_detail::number_among(found.second, which.word(), which.number);
    static_assert(k < rigid_count,
                  "Scene: no such rigid body; say rigid<\"name\">() of rigid<\"name\">(..), "
                  "or rigid<number>(); rigid() is the only one");
    if constexpr (rigid_count > 0)
      return found.first[k < rigid_count ? k : 0];
    else
      return 0;
  }
  template <std::size_t Place>
  static constexpr std::size_t part_place() {
    static_assert(Place < part_count, "Scene: no part was made of such a recipe");
    return Place < part_count ? Place : 0;
  }

  Scene(Nothing, K kinematics_value, M&& mesh_value, N numerics_value, const Given&... given);

  static Parts bind(const M& mesh, const K& kinematics, const Given&... given) {
    static_assert(shared_detail::check_all_roles<Scene>(std::type_identity<Parts>{}));
    const TraitsType traits{mesh};
    return shared_detail::with_recipes_of(shared_detail::Binder<TraitsType>{traits}, kinematics, given...);
  }

#ifdef __clang__
  /// No macro reports -fno-honor-nans and -fno-honor-infinities (compare core/requirements.hpp).
  static void require_special_values() {
    const volatile double nan = std::numeric_limits<double>::quiet_NaN();
    const volatile double infinite = std::numeric_limits<double>::infinity();
    require(
        std::isnan(nan) && !std::isfinite(infinite), "The compiler's flags", "as given",
        "must let Arenite see NaN and infinity: compile without -fno-honor-nans and -fno-honor-infinities");
  }
#endif

  void find_constraints() {
    Nodes nodes(mesh);
    if constexpr (is_portion) nodes.set_whole(portion().lower, portion().upper);
    std::size_t number = 0;
    for_each_part([&](const auto& part) {
      if constexpr (constrains<std::remove_cvref_t<decltype(part)>, Scene>) nodes.add(part, number);
      ++number;
    });
    constraints = nodes.constraints();
    if constexpr (Needs::drives) {
      number = 0;
      for_each_part([&](const auto& part) {
        if constexpr (drives_nodes<std::remove_cvref_t<decltype(part)>, Scene>)
          for (const auto& drive : nodes.drives(number)) drives.push_back(drive);
        ++number;
      });
    }
    for_each_part([&](auto& part) {
      if constexpr (requires { part.connect_walls(*this, nodes); }) part.connect_walls(*this, nodes);
    });
  }

  static Blocks make_blocks(const M& mesh) {
    Index size;
    if constexpr (is_simplex_mesh<M>) {
      // Long runs of points, which memory serves best, but blocks enough to share out.
      size = std::clamp<Index>(mesh.cell_count() / 128, 24, 800);
    } else {
      // As many layers of cells as share nodes: a block then shares nodes only with its two neighbours, so
      // that two colours are enough.
      size = Shape::halo * (mesh.cell_count() / mesh.cells(D - 1));
    }
    return Blocks(mesh.cell_count(), Shape::node_count(mesh), size,
                  [&](Index c) { return typename Shape::template Cell<M>(mesh, c).nodes; });
  }

  template <class Self, class Number>
  static auto& listed(Self& self, Number number) {
    require(std::cmp_less(number, self.bodies.size()) && std::cmp_greater_equal(number, 0), "Scene::body",
            number, "must be less than number_of_bodies()");
    return self.bodies[static_cast<std::size_t>(number)];
  }
  auto make_fields([[maybe_unused]] std::size_t body_number) const {
    if constexpr (field_count == counted_at_run_time)
      return std::vector<Field>(body_number, Field(Shape::node_count(mesh), centres_stress(0)));
    else
      return [&]<std::size_t... At>(std::index_sequence<At...>) {
        return std::array<Field, field_count>{Field(Shape::node_count(mesh), centres_stress(At))...};
      }
    (std::make_index_sequence<field_count>{});
  }

  template <class Recipe>
  BodyTuple make_bodies(const Recipe& recipe) {
    const auto grounds = shared_detail::grounds_of(*this, recipe);
    at_rest = shared_detail::grounds_at_rest<M>(recipe, grounds);
    const auto made = [&](const auto& fill, std::size_t number) {
      return make_body<K, extra_columns>(mesh, fill, cell_owner(), grounds[number]);
    };
    if constexpr (lists_bodies) {
      BodyTuple all;
      for (const auto& fill : recipe.fills) all.push_back(made(fill, all.size()));
      return all;
    } else {
      return [&]<std::size_t... At>(std::index_sequence<At...>) {
        return BodyTuple{made(std::get<At>(recipe.fills), At)...};
      }
      (std::make_index_sequence<body_count>{});
    }
  }

  template <class Self, class F>
  static void each_body(Self& self, F& f) {
    if constexpr (lists_bodies)
      for (std::size_t k = 0; k < self.bodies.size(); ++k) f(self.bodies[k], self.fields[field_of(k)]);
    else
      [&]<std::size_t... At>(std::index_sequence<At...>) {
        (f(std::get<At>(self.bodies), self.fields[field_of(At)]), ...);
      }
    (std::make_index_sequence<body_count>{});
  }
  template <class Self, class F, std::size_t... At>
  static void each_part([[maybe_unused]] Self& self, [[maybe_unused]] F& f, std::index_sequence<At...>) {
    (f(std::get<At>(self.parts)), ...);
  }
};

template <class K, class M, class N, class... Given>
Scene(K, M, N, Given...)
    -> Scene<shared_detail::refused_unless<shared_detail::is_complete_scene<K, M, N, Given...>(), K>, M, N,
             type_erased_t<Given>...>;
/// Two values cannot be a scene: without this guide the compiler would say so in its own words.
template <class K, class M>
Scene(K, M)
    -> Scene<shared_detail::refused_unless<shared_detail::is_complete_scene<K, M, void>(), K>, M, void>;

/// Replaces a scene that the compiler has refused: the mistake is already reported.
template <class M, class N, class... Given>
struct Scene<shared_detail::Refused, M, N, Given...> {
  Scene(const auto&...) {}
};
template <class... Given>
using RefusedScene = Scene<shared_detail::Refused, Given...>;

// Not within the class: there it would be inline, and compiled again in each unit in spite of an `extern
// template`.
template <class K, class M, class N, class... Given>
Scene<K, M, N, Given...>::Scene(Nothing, K kinematics_value, M&& mesh_value, N numerics_value,
                                const Given&... given)
    : kinematics{kinematics_value},
      mesh{std::move(mesh_value)},
      numerics{numerics_value},
      blocks{make_blocks(mesh)},
      parts{bind(mesh, kinematics, given...)},
      fields{make_fields(shared_detail::find_bodies(given...).size())},
      bodies{make_bodies(shared_detail::find_bodies(given...))} {
#ifdef __clang__
  require_special_values();
#endif
  balance_threads();
  for_each_body([&](auto& body, const auto&) { body.points.place_by_thread(body.cells, blocks); });
  find_constraints();
  for_each_part([&](auto& part) {
    if constexpr (connects<std::remove_reference_t<decltype(part)>, Scene>) part.connect(*this);
  });
  const auto& recipe = shared_detail::find_bodies(given...);
  if constexpr (!is_portion)
    shared_detail::warn_about_new_scene(*this, shared_detail::new_scene(*this, recipe));
  else if (!drops_warnings())
    unseen = shared_detail::new_scene(*this, recipe);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
