// Parts of a scene: what a user may name after kinematics, mesh and numerics, in any order. What is not named
// has an empty default.
#pragma once

#include <initializer_list>
#include <tuple>
#include <utility>

#include <arenite/boundary/walls.hpp>
#include <arenite/contact/contact.hpp>
#include <arenite/mesh/motion.hpp>
#include <arenite/particles/body.hpp>
#include <arenite/rigid/rigid_body.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Acceleration on everything, m/s2.
struct Gravity {
  std::array<double, 3> g{};
};
/// `gravity({0, -9.81})`: as many components as the scene has dimensions, or fewer.
inline Gravity gravity(std::initializer_list<double> g) {
  require(g.size() <= 3, "gravity: components", g.size(), "must be at most 3");
  Gravity out;
  std::copy(g.begin(), g.end(), out.g.begin());
  return out;
}

template <class... Fills>
struct Bodies {
  std::tuple<Fills...> fills;
};
/// The deformable bodies of a scene, each made by `fill(..)`; they are numbered from 0.
template <class... Fills>
Bodies<Fills...> bodies(Fills... fills) {
  return {{std::move(fills)...}};
}

template <class... R>
struct Rigids {
  std::tuple<R...> bodies;
};
/// The rigid bodies of a scene, each made by `rigid(..)`; they are numbered from 0.
template <class... R>
Rigids<R...> rigids(R... body) {
  return {{std::move(body)...}};
}

/// Asks for the energy ledger: works of stresses and external forces are summed at each step. Without it they
/// are not computed.
struct TrackEnergy {};
struct NoLedger {};

namespace detail {

template <class P>
struct is_bodies : std::false_type {};
template <class... F>
struct is_bodies<Bodies<F...>> : std::true_type {};
template <class P>
struct is_rigids : std::false_type {};
template <class... R>
struct is_rigids<Rigids<R...>> : std::true_type {};
template <class P>
struct is_walls : std::is_same<P, Walls> {};
template <class P>
struct is_gravity : std::is_same<P, Gravity> {};
template <class P>
struct is_contact_part : std::bool_constant<is_contact<P>> {};
template <class P>
struct is_motion : std::false_type {};
template <class L>
struct is_motion<MovingMesh<L>> : std::true_type {};
template <class P>
struct is_ledger : std::is_same<P, TrackEnergy> {};

template <class P>
inline constexpr bool is_part =
    is_bodies<P>::value || is_rigids<P>::value || is_walls<P>::value || is_gravity<P>::value ||
    is_contact_part<P>::value || is_motion<P>::value || is_ledger<P>::value;

template <template <class> class Is, class... P>
inline constexpr int count_parts = (0 + ... + int(Is<P>::value));

/// The one part of a kind among those given, or a default.
template <template <class> class Is, class Default>
Default pick() {
  return {};
}
template <template <class> class Is, class Default, class First, class... Rest>
auto pick(const First& first, const Rest&... rest) {
  if constexpr (Is<First>::value)
    return first;
  else
    return pick<Is, Default>(rest...);
}
template <template <class> class Is, class Default, class... P>
using picked = decltype(pick<Is, Default>(std::declval<const P&>()...));

}  // namespace detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
