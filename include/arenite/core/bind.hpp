// Binding: what a user writes (a recipe) becomes what it means in a scene's mesh.
#pragma once

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// What `bind_part(recipe, site)`, found by argument-dependent look-up, makes of a recipe; where there is
/// none the recipe is its own meaning. (`bind` alone would be std::bind, where a recipe holds a type of std.)
template <class Recipe, class Site>
auto bound(const Recipe& recipe, const Site& site) {
  if constexpr (requires { bind_part(recipe, site); })
    return bind_part(recipe, site);
  else
    return recipe;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
