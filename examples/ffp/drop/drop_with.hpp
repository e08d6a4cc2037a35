// Drops on fitted meshes: choices made at run time select types made at compile time.
#pragma once

#include <string_view>

#include "drop.hpp"
#include "model.hpp"
#include "record.hpp"

/// Units to compile, "axisymmetric-law, slice"; empty: all.
#ifndef ARENITE_FFP_UNITS
#define ARENITE_FFP_UNITS ""
#endif

namespace arenite::ffp {

template <class Model, DropKind kind>
void drop_of_kind(const DropOptions& o) {
  record<Model>(o, [&] {
    if constexpr (kind == DropKind::elastic)
      return elastic_scene<Model>(o);
    else if constexpr (kind == DropKind::law)
      return rigid_scene<Model, NodalAndElementAverage, RigidVelocity>(o, sand_with_law(o));
    else if constexpr (kind == DropKind::centre_of_mass)
      return rigid_scene<Model, NodalAndElementAverage, CentreOfMass>(o, plain_sand(o));
    else if constexpr (kind == DropKind::no_averages)
      return rigid_scene<Model, NoAntiLocking, RigidVelocity>(o, plain_sand(o));
    else
      return rigid_scene<Model, NodalAndElementAverage, RigidVelocity>(o, plain_sand(o));
  });
}

/// Whether `unit` is `unit_of(model, kind)`.
constexpr bool is_unit(std::string_view unit, std::string_view model, DropKind kind) {
  if (!unit.starts_with(model)) return false;
  const auto rest = unit.substr(model.size());
  if (kind == DropKind::plain) return rest.empty();
  for (const auto& [word, of] : drop_kind_words)
    if (of == kind) return rest.starts_with('-') && rest.substr(1) == word;
  return false;
}

/// Units of a model.
template <class Model, DropKind... kinds>
struct DropUnits {
  DropUnits() { (add<kinds>(), ...); }

 private:
  static constexpr std::string_view asked = ARENITE_FFP_UNITS;

  /// How many of the units that are asked for satisfy `holds`.
  static constexpr int count(auto holds) {
    int found = 0;
    for (auto rest = asked; !rest.empty();) {
      const auto end = rest.find(", ");
      found += holds(rest.substr(0, end));
      rest = end == rest.npos ? std::string_view{} : rest.substr(end + 2);
    }
    return found;
  }
  template <DropKind kind>
  static void add() {
    if constexpr (asked.empty() || count([](auto unit) { return is_unit(unit, Model::name, kind); }) > 0)
      DropUnit(unit_of(Model::name, kind), drop_of_kind<Model, kind>);
  }

  static_assert(count([](auto unit) { return unit.starts_with(Model::name); }) ==
                    count([](auto unit) { return (is_unit(unit, Model::name, kinds) || ...); }),
                "ARENITE_FFP_UNITS names a drop that there is not");
};

}  // namespace arenite::ffp
