// The drop as a half-section of triangles. Its devices and laws share kernels, which one unit compiles once.
#include "drop.hpp"
#include "drop_with.hpp"

void arenite::ffp::drop_axisymmetric(const DropOptions& o) { drop_model<AxisymmetricModel>(o); }
