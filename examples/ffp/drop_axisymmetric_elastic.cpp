// The drop of an elastic penetrometer, axisymmetric.
#include "drop.hpp"
#include "record.hpp"

namespace arenite::ffp {

void drop_axisymmetric_elastic(const DropOptions& o) {
  using Model = AxisymmetricModel;
  o.anti_locking ? record<Model>(elastic_scene<Model, NodalAveraging>(o), o)
                 : record<Model>(elastic_scene<Model, NoAntiLocking>(o), o);
}

}  // namespace arenite::ffp
