// The drop of the default options as a separate unit, which is compiled first.
#include "drop_with.hpp"

void arenite::ffp::drop_default(const DropOptions& o) { drop_of_kind<AxisymmetricModel, DropKind::plain>(o); }
