// The other drops as a half-section of triangles. Their devices and laws share kernels, which one unit compiles
// once.
#include "drop.hpp"
#include "drop_with.hpp"

namespace arenite::ffp {

const DropUnit axisymmetric{"axisymmetric",
                            [](const DropOptions& o) { drop_model<AxisymmetricModel>(o, drop_default); }};

}  // namespace arenite::ffp
