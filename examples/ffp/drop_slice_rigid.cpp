// The drop of a rigid penetrometer, as a slice of tetrahedra.
#include "drop.hpp"
#include "drop_with.hpp"

void arenite::ffp::drop_slice_rigid(const DropOptions& o) { drop_rigid<SliceModel>(o); }
