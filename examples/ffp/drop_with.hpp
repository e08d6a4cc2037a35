// One drop of one model: the choices that are made at run time meet the types that are made at compile time.
#pragma once

#include "model.hpp"
#include "record.hpp"

namespace arenite::ffp {

template <class Model>
void drop_rigid(const DropOptions& o) {
  const auto with = [&]<class AntiLocking>(AntiLocking) {
    if (o.contact == ContactKind::rigid)
      record<Model>(o, [&] { return rigid_scene<Model, AntiLocking, RigidVelocity>(o); });
    else
      record<Model>(o, [&] { return rigid_scene<Model, AntiLocking, CentreOfMass>(o); });
  };
  o.anti_locking ? with(NodalAndElementAverage{}) : with(NoAntiLocking{});
}

template <class Model>
void drop_elastic(const DropOptions& o) {
  const auto with = [&]<class AntiLocking>(AntiLocking) {
    record<Model>(o, [&] { return elastic_scene<Model, AntiLocking>(o); });
  };
  o.anti_locking ? with(NodalAndElementAverage{}) : with(NoAntiLocking{});
}

}  // namespace arenite::ffp
