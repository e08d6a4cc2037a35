// One drop of one model: the choices that are made at run time meet the types that are made at compile time.
#pragma once

#include "model.hpp"
#include "record.hpp"

namespace arenite::ffp {

template <class Model, class AntiLocking>
void drop_rigid(const DropOptions& o) {
  if (o.contact == ContactKind::rigid)
    record<Model>(o, [&] { return rigid_scene<Model, AntiLocking, RigidVelocity>(o, plain_sand(o)); });
  else
    record<Model>(o, [&] { return rigid_scene<Model, AntiLocking, CentreOfMass>(o, plain_sand(o)); });
}

template <class Model, class AntiLocking>
void drop_elastic(const DropOptions& o) {
  record<Model>(o, [&] { return elastic_scene<Model, AntiLocking>(o); });
}

/// Laws with friction by point come with the default composition alone (see `check`): each more would be
/// compiled for all.
template <class Model>
void drop_with_law(const DropOptions& o) {
  record<Model>(
      o, [&] { return rigid_scene<Model, NodalAndElementAverage, RigidVelocity>(o, sand_with_law(o)); });
}

template <class Model>
void drop_model(const DropOptions& o) {
  const bool rigid = o.device == DeviceKind::rigid;
  if (o.law.kind != LawKind::mohr_coulomb)
    drop_with_law<Model>(o);
  else if (o.anti_locking)
    rigid ? drop_rigid<Model, NodalAndElementAverage>(o) : drop_elastic<Model, NodalAndElementAverage>(o);
  else
    rigid ? drop_rigid<Model, NoAntiLocking>(o) : drop_elastic<Model, NoAntiLocking>(o);
}

}  // namespace arenite::ffp
