// The drop as a slice of tetrahedra. Its devices and laws share kernels, which one unit compiles once.
#include "drop.hpp"
#include "drop_with.hpp"

namespace arenite::ffp {

const DropUnit slice{"slice",
                     [](const DropOptions& o) { drop_model<SliceModel>(o, drop_plain<SliceModel>); }};

}  // namespace arenite::ffp
