// Checks: the library's own rules for recipes, asked where Python makes them, before there is a scene.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <arenite_host/value.hpp>

namespace arenite::python {

/// Throws `error` if the values of a recipe break a rule that needs no scene. `recipe`: its class; of a
/// frictional law with its memory, "MohrCoulomb<ForgetsOpening, AnyFriction>". Of one that has no such
/// rules nothing is checked.
void check_recipe(const std::string& recipe, const Value& values);

/// The recipes that have rules.
std::vector<std::string> checked_recipes();

/// The library's frictions, each with the names of its history, and `AnyFriction`, which represents all.
std::vector<std::pair<std::string, std::vector<std::string>>> frictions();

/// Throws `error` if recipes, by their classes, do not go together: {"LinearSimplex", "Apic"}.
void check_together(const std::vector<std::string>& recipes);

/// Throws `error` if a scene of these parts in that mesh, types and values as `HostedScene` has them, breaks
/// a rule that its own constructor would report: for one that is still to be compiled.
void check_scene(std::string mesh_type, const Value& mesh, const std::vector<std::string>& types,
                 const Value& parts);

}  // namespace arenite::python
