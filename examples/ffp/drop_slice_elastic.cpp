// The drop of an elastic penetrometer, as a slice of tetrahedra.
#include "drop.hpp"
#include "drop_with.hpp"

void arenite::ffp::drop_slice_elastic(const DropOptions& o) { drop_elastic<SliceModel>(o); }
