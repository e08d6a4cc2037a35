// The other drops as a half-section of triangles. Their devices and laws share kernels, which one unit compiles
// once.
#include "drop.hpp"
#include "drop_with.hpp"

void arenite::ffp::drop_axisymmetric(const DropOptions& o) { drop_model<AxisymmetricModel>(o, drop_default); }
