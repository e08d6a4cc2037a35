// One drop of one model: the choices that are made at run time meet the types that are made at compile time.
#pragma once

#include "model.hpp"
#include "record.hpp"

namespace arenite::ffp {

/// A drop that differs from the default in its model alone.
template <class Model>
void drop_plain(const DropOptions& o) {
  record<Model>(o,
                [&] { return rigid_scene<Model, NodalAndElementAverage, RigidVelocity>(o, plain_sand(o)); });
}

/// What differs from the default in more than one way is refused by `check`: each composition more would be
/// compiled for all. `plain`: runs a drop that does not differ.
template <class Model>
void drop_model(const DropOptions& o, void (*plain)(const DropOptions&)) {
  using Averages = NodalAndElementAverage;
  if (o.device == DeviceKind::elastic)
    record<Model>(o, [&] { return elastic_scene<Model>(o); });
  else if (o.law.kind != LawKind::mohr_coulomb)
    record<Model>(o, [&] { return rigid_scene<Model, Averages, RigidVelocity>(o, sand_with_law(o)); });
  else if (o.contact_kind() == ContactKind::centre_of_mass)
    record<Model>(o, [&] { return rigid_scene<Model, Averages, CentreOfMass>(o, plain_sand(o)); });
  else if (o.averages())
    plain(o);
  else
    record<Model>(o, [&] { return rigid_scene<Model, NoAntiLocking, RigidVelocity>(o, plain_sand(o)); });
}

}  // namespace arenite::ffp
