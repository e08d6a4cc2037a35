// Binding: turns a recipe, which is what a user writes, into the part of a scene, for its mesh.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <type_traits>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Turns a recipe into the part of a scene by `bind_part(recipe, traits)`, found by argument-dependent lookup
/// (ADL); a recipe without one is the part. (By the name `bind` ADL would find std::bind for a recipe with a
/// template argument of std.)
template <class Recipe, class Traits>
auto bound(const Recipe& recipe, const Traits& traits) {
  if constexpr (requires { bind_part(recipe, traits); })
    return bind_part(recipe, traits);
  else
    return recipe;
}

namespace detail {
template <class Recipe>
struct erasure {
  using type = Recipe;
};
template <class Recipe>
requires requires { typename Recipe::TypeErased; }
struct erasure<Recipe> {
  using type = typename Recipe::TypeErased;
};
}  // namespace detail

/// The type of a recipe within the type of a scene: without the types of regions, distances and other
/// functions, so that it can be written down. A recipe with such types has a member type `TypeErased` and a
/// member `type_erased<M>()` that returns one for a mesh M; all other recipes stay what they are.
template <class Recipe>
using type_erased_t = typename detail::erasure<Recipe>::type;

/// The recipe as a scene over mesh M keeps it: itself, or another one.
template <class M, class Recipe>
decltype(auto) type_erased(const Recipe& recipe) {
  if constexpr (std::is_same_v<type_erased_t<Recipe>, Recipe>)
    return (recipe);
  else
    return recipe.template type_erased<M>();
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
