// The drop of the default options as a unit of its own, which is compiled first.
#include "drop_with.hpp"

void arenite::ffp::drop_default(const DropOptions& o) { drop_of_kind<AxisymmetricModel, DropKind::plain>(o); }
