// Which unit computes a drop.
#include "drop.hpp"

namespace arenite::ffp {

const bool has_other_drops = true;

void drop_other(const DropOptions& o) {
  if (o.on_grid())
    drop_grid(o);
  else
    o.kinematics == Kinematics::slice ? drop_slice(o) : drop_axisymmetric(o);
}

}  // namespace arenite::ffp
