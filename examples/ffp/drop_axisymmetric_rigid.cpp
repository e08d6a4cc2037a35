// The drop of a rigid penetrometer, axisymmetric.
#include "drop.hpp"
#include "drop_with.hpp"

void arenite::ffp::drop_axisymmetric_rigid(const DropOptions& o) { drop_rigid<AxisymmetricModel>(o); }
