// The drop in space, on a grid.
#include "drop.hpp"
#include "model_space.hpp"
#include "record.hpp"

namespace arenite::ffp {

const DropUnit space{"space", [](const DropOptions& o) {
                       record<SpaceModel>(o, [&] { return space_scene_in(SpaceModel::mesh(o), o); });
                     }};

}  // namespace arenite::ffp
