// The drop on a grid. Its kinds of contact share kernels, which one unit compiles once.
#include "drop.hpp"
#include "model_grid.hpp"
#include "record.hpp"

namespace arenite::ffp {

const DropUnit grid{"grid", [](const DropOptions& o) {
                      if (o.contact_kind() == ContactKind::points)
                        record<GridModel>(o, [&] { return grid_scene<PointContact>(o); });
                      else
                        record<GridModel>(o, [&] { return grid_scene<RigidVelocity>(o); });
                    }};

}  // namespace arenite::ffp
