// The drop of an elastic penetrometer, axisymmetric.
#include "drop.hpp"
#include "drop_with.hpp"

void arenite::ffp::drop_axisymmetric_elastic(const DropOptions& o) { drop_elastic<AxisymmetricModel>(o); }
