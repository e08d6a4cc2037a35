// The drop of a rigid penetrometer, axisymmetric.
#include "drop.hpp"
#include "record.hpp"

namespace arenite::ffp {
namespace {

template <class AntiLocking>
void drop_with(const DropOptions& o) {
  using Model = AxisymmetricModel;
  if (o.contact == ContactKind::rigid)
    record<Model>(rigid_scene<Model, AntiLocking, RigidVelocity>(o), o);
  else
    record<Model>(rigid_scene<Model, AntiLocking, CentreOfMass>(o), o);
}

}  // namespace

void drop_axisymmetric_rigid(const DropOptions& o) {
  o.anti_locking ? drop_with<NodalAveraging>(o) : drop_with<NoAntiLocking>(o);
}

}  // namespace arenite::ffp
