// Parts of a scene: what a user may name after kinematics, mesh and numerics, in any order. A part is any
// value that plays a role (`part/roles.hpp`); what is not named does not exist.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/bind.hpp>
#include <arenite/core/by_body.hpp>
#include <arenite/core/name.hpp>
#include <arenite/law/pass.hpp>
#include <arenite/part/roles.hpp>
#include <arenite/particles/body.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The recipe that `bodies` makes.
template <class... Fills>
struct Bodies {
  static constexpr std::size_t count = sizeof...(Fills);

  std::tuple<Fills...> fills;

  std::size_t size() const { return count; }
  /// Calls `f(fill)` for each.
  template <class F>
  void for_each(F&& f) const {
    [&]<std::size_t... At>(std::index_sequence<At...>) { (f(std::get<At>(fills)), ...); }
    (std::make_index_sequence<count>{});
  }

  using TypeErased = Bodies<type_erased_t<Fills>...>;
  template <class M>
  TypeErased type_erased() const {
    return {std::apply(
        [](const auto&... f) { return std::tuple<type_erased_t<Fills>...>(arenite::type_erased<M>(f)...); },
        fills)};
  }
};

/// The recipe of bodies of one law, as many as a list has.
template <class F>
struct BodyList {
  static constexpr std::size_t count = counted_at_run_time;

  std::vector<F> fills;

  std::size_t size() const { return fills.size(); }
  template <class Call>
  void for_each(Call&& f) const {
    for (const F& fill : fills) f(fill);
  }

  using TypeErased = BodyList<type_erased_t<F>>;
  template <class M>
  TypeErased type_erased() const {
    TypeErased erased;
    for (const F& fill : fills) erased.fills.push_back(arenite::type_erased<M>(fill));
    return erased;
  }
};

namespace shared_detail {
template <class F>
inline constexpr bool is_fill = false;
template <class L, Name name, class Region>
inline constexpr bool is_fill<Fill<L, name, Region>> = true;
}  // namespace shared_detail

/// The deformable bodies of a scene, each made by `fill(..)`; they are numbered from 0.
template <class... Fills>
Bodies<Fills...> bodies(const Fills&... fills) {
  return {{fills...}};
}
/// Bodies of one law, as many as the list has, each with its own region, parameters and options:
/// `bodies(std::vector{fill(..), fill(..)})`; `scene.body(k)` is number k. A list of regions of several types
/// has elements `Fill<Law>`, made by `fill(AnyRegion::of<D>(region), law)`. Throws `error` if it is empty.
template <class F>
requires shared_detail::is_fill<F> BodyList<F> bodies(std::vector<F> fills) {
  static_assert(F::word.empty(), "bodies: the fills of a list have no names; they are numbered");
  require(!fills.empty(), "bodies", fills.size(), "must be at least one fill");
  return {std::move(fills)};
}
/// Refused by the compiler: what no `fill` made.
template <class... Fills>
requires(!(shared_detail::is_fill<Fills> && ...)) auto bodies(const Fills&...) {
  static_assert((shared_detail::is_fill<Fills> && ...),
                "bodies: each argument must be a fill(region, law): bodies(fill(..), fill(..)), or "
                "a std::vector of fills of one law");
  return Bodies<>{};
}

/// Parts side by side, as one value.
template <class... P>
struct PartGroup {
  std::tuple<P...> parts;

  using TypeErased = PartGroup<type_erased_t<P>...>;
  template <class M>
  TypeErased type_erased() const {
    return {std::apply(
        [](const auto&... p) { return std::tuple<type_erased_t<P>...>(arenite::type_erased<M>(p)...); },
        parts)};
  }
};
/// The rigid bodies of a scene, each made by `rigid(..)`; they are numbered from 0.
template <class... R>
PartGroup<R...> rigids(R... body) {
  return {{std::move(body)...}};
}

/// Context in which recipes are bound: the mesh, and the types of the scene.
template <class K, class M, class N, std::size_t Bodies>
struct SceneTraits {
  using Kinematics = K;
  using Mesh = M;
  using NumericsType = N;
  using Shape = typename N::Shape;
  using T = typename M::scalar;
  static constexpr int D = M::dimension;
  static constexpr std::size_t body_count = Bodies;  ///< perhaps `counted_at_run_time`
  const M& mesh;
};

namespace shared_detail {

template <class P>
inline constexpr bool is_bodies = false;
template <class... F>
inline constexpr bool is_bodies<Bodies<F...>> = true;
template <class F>
inline constexpr bool is_bodies<BodyList<F>> = true;

template <class P>
inline constexpr bool is_group = false;
template <class... P>
inline constexpr bool is_group<PartGroup<P...>> = true;

/// `f(recipe, ..)` of a scene's recipes but its bodies: groups opened, in order. Of those given the first `Left`
/// are still to be opened; each then goes to the end.
template <std::size_t, class F>
auto with_recipes(const F& f) {
  return f();
}
template <std::size_t Left, class F, class First, class... Rest>
auto with_recipes(const F& f, const First& first, const Rest&... rest) {
  if constexpr (Left == 0)
    return f(first, rest...);
  else if constexpr (is_bodies<First>)
    return with_recipes<Left - 1>(f, rest...);
  else if constexpr (is_group<First>)
    return std::apply([&](const auto&... part) { return with_recipes<Left - 1>(f, rest..., part...); },
                      first.parts);
  else
    return with_recipes<Left - 1>(f, rest..., first);
}
/// The kinematics come last, if they are a part.
template <class F, class K, class... Given>
auto with_recipes_of(const F& f, const K& kinematics, const Given&... given) {
  if constexpr (plays_a_role<K>)
    return with_recipes<sizeof...(Given) + 1>(f, given..., kinematics);
  else
    return with_recipes<sizeof...(Given)>(f, given...);
}

/// The types of recipes.
struct TypesOf {
  template <class... P>
  std::type_identity<std::tuple<P...>> operator()(const P&...) const {
    return {};
  }
};
/// Binds recipes.
template <class Traits>
struct Binder {
  const Traits& traits;
  template <class... P>
  auto operator()(const P&... recipe) const {
    return std::tuple<decltype(bound(recipe, traits))...>{bound(recipe, traits)...};
  }
};

/// The bodies among the values given; none: no bodies.
inline Bodies<> find_bodies() { return {}; }
template <class First, class... Rest>
decltype(auto) find_bodies(const First& first, const Rest&... rest) {
  if constexpr (is_bodies<First>)
    return (first);
  else
    return find_bodies(rest...);
}

template <class M, ExtraColumns Extra, class F>
struct body_of;
template <class M, ExtraColumns Extra, class L, Name name>
struct body_of<M, Extra, Fill<L, name>> {
  using Law = L;
  using type = Body<L, typename M::scalar, M::dimension, Extra>;
  static constexpr std::string_view word = name.word();
};
template <class M, ExtraColumns Extra, class B>
struct bodies_of;
template <class M, ExtraColumns Extra, class... F>
struct bodies_of<M, Extra, Bodies<F...>> {
  using type = std::tuple<typename body_of<M, Extra, F>::type...>;
  static constexpr std::array<std::string_view, sizeof...(F)> names{body_of<M, Extra, F>::word...};
  /// Whether all are laws; `Body` reports what a type lacks that is none.
  template <class T>
  static constexpr bool are_laws = (constitutive_law<typename body_of<M, Extra, F>::Law, T, M::dimension> &&
                                    ...);
  /// Whether a law accepts packs of as many points as a scene with numerics N passes to it. Wrong constants
  /// of the law for packs are reported by `Body`.
  template <class N, class Law>
  static constexpr bool takes_lanes_of() {
    if constexpr (wishes_packs_rightly<Law>) {
      using T = typename M::scalar;
      return takes_lanes<Law, typename LawLanes<Law, T, N::template width<T>>::type, M::dimension>;
    }
    return true;
  }
  template <class N>
  static constexpr bool take_lanes = (takes_lanes_of<N, typename body_of<M, Extra, F>::Law>() && ...);
  /// Whether the stresses of the bodies in a node field are those at mid-step: where the laws of
  /// all of them are linear. `Apart`: each body has a field.
  template <class N, bool Apart>
  static constexpr bool centres_stress(std::size_t field) {
    if constexpr (Apart)
      return std::array{N::template centres_stress<typename body_of<M, Extra, F>::Law>...}[field];
    else
      return N::template centres_stress<typename body_of<M, Extra, F>::Law...>;
  }
};
template <class M, ExtraColumns Extra, class F>
struct bodies_of<M, Extra, BodyList<F>> : bodies_of<M, Extra, Bodies<F>> {
  using type = std::vector<typename body_of<M, Extra, F>::type>;
  static constexpr std::array<std::string_view, 0> names{};
  template <class N, bool Apart>
  static constexpr bool centres_stress(std::size_t) {
    return N::template centres_stress<typename body_of<M, Extra, F>::Law>;
  }
};

/// Requirements of all parts together.
template <class Parts>
struct needs_of;
template <class... P>
struct needs_of<std::tuple<P...>> {
  static constexpr bool own_fields = (separates_bodies<P> || ...);
  static constexpr bool mass_gradient = (needs_mass_gradient<P> || ...);
  static constexpr bool point_ids = (needs_point_ids<P> || ...);
  static constexpr int point_columns = (0 + ... + arenite::point_columns<P>);
  static constexpr bool drives = (names_driven_velocity<P> || ...);
  static constexpr bool stress_work = (names_take_stress_work<P> || ...);
  static constexpr bool wall_impulses = (names_take_wall_impulse<P> || ...);
  static constexpr bool mapped_momenta = (names_take_mapped_momentum<P> || ...);
  static constexpr bool start_state = (reads_start_state<P> || ...);
  static constexpr bool moves_rigid_bodies = (arenite::moves_rigid_bodies<P> || ...);
  static constexpr bool contact = (names_apply_impulses<P> || ...);
};

/// The parts that are rigid bodies: their places among all parts, and their names.
template <class P>
inline constexpr bool is_rigid = requires {
  P::is_rigid_body;
};
template <class Parts>
struct rigids_of;
template <class... P>
struct rigids_of<std::tuple<P...>> {
  static constexpr std::size_t count = (0 + ... + std::size_t(is_rigid<P>));
  static constexpr auto found = [] {
    std::pair<std::array<std::size_t, count>, std::array<std::string_view, count>> all{};
    std::size_t place = 0, number = 0;
    [[maybe_unused]] const auto look = [&]<class Q>(std::type_identity<Q>) {
      if constexpr (is_rigid<Q>) {
        all.first[number] = place;
        all.second[number++] = Q::name.word();
      }
      ++place;
    };
    (look(std::type_identity<P>{}), ...);
    return all;
  }();
};

/// Number of the one of these names that is meant; as many as there are if there is none. Neither a word nor
/// a number: the only one.
template <std::size_t Count>
constexpr std::size_t number_among(const std::array<std::string_view, Count>& names, std::string_view word,
                                   int number) {
  if (!word.empty()) {
    std::size_t k = 0;
    while (k < Count && names[k] != word) ++k;
    return k;
  }
  if (number >= 0) return static_cast<std::size_t>(number);
  return Count == 1 ? 0 : Count;
}

/// Whether no two of these names are equal; empty ones are none.
template <std::size_t Count>
constexpr bool differ(const std::array<std::string_view, Count>& names) {
  for (std::size_t a = 0; a < Count; ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (!names[a].empty() && names[a] == names[b]) return false;
  return true;
}

/// Place of the part made of a recipe R, or of a template of recipes; as many as there are if there is none.
template <class R, class... P>
constexpr std::size_t place_of(std::type_identity<std::tuple<P...>>) {
  std::size_t k = 0;
  (void)((std::same_as<P, R> || (++k, false)) || ...);
  return k;
}
template <class P, template <class...> class R>
inline constexpr bool is_made_of = false;
template <class... A, template <class...> class R>
inline constexpr bool is_made_of<R<A...>, R> = true;
template <template <class...> class R, class... P>
constexpr std::size_t place_of(std::type_identity<std::tuple<P...>>) {
  std::size_t k = 0;
  (void)((is_made_of<P, R> || (++k, false)) || ...);
  return k;
}

/// Whether no two parts are of a kind of which a scene has one (`using OnlyOne = ..`).
template <class A, class B>
concept same_kind = std::same_as<typename A::OnlyOne, typename B::OnlyOne>;
template <class P, class... All>
inline constexpr bool is_single = (0 + ... + int(same_kind<P, All>)) <= 1;
template <class Parts>
inline constexpr bool singles = false;
template <class... P>
inline constexpr bool singles<std::tuple<P...>> = (is_single<P, P...> && ...);

}  // namespace shared_detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
