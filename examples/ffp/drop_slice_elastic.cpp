// The drop of an elastic penetrometer, as a slice of tetrahedra.
#include "drop.hpp"
#include "record.hpp"

namespace arenite::ffp {

void drop_slice_elastic(const DropOptions& o) {
  using Model = SliceModel;
  o.anti_locking ? record<Model>(elastic_scene<Model, NodalAveraging>(o), o)
                 : record<Model>(elastic_scene<Model, NoAntiLocking>(o), o);
}

}  // namespace arenite::ffp
