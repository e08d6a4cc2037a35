// One drop of one model: the choices that are made at run time meet the types that are made at compile time.
#pragma once

#include "record.hpp"

namespace arenite::ffp {

template <class Model>
void drop_rigid(const DropOptions& o) {
  const auto with = [&]<class AntiLocking>(AntiLocking) {
    if (o.contact == ContactKind::rigid)
      record<Model>(rigid_scene<Model, AntiLocking, RigidVelocity>(o), o);
    else
      record<Model>(rigid_scene<Model, AntiLocking, CentreOfMass>(o), o);
  };
  o.anti_locking ? with(NodalAndElementAverage{}) : with(NoAntiLocking{});
}

template <class Model>
void drop_elastic(const DropOptions& o) {
  o.anti_locking ? record<Model>(elastic_scene<Model, NodalAndElementAverage>(o), o)
                 : record<Model>(elastic_scene<Model, NoAntiLocking>(o), o);
}

}  // namespace arenite::ffp
