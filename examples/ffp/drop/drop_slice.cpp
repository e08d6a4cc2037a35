// The drop as a slice of tetrahedra. Its devices and laws share kernels, which one unit compiles once.
#include "drop_with.hpp"

namespace arenite::ffp {

const DropUnits<SliceModel, DropKind::plain, DropKind::elastic, DropKind::law, DropKind::centre_of_mass,
                DropKind::no_averages>
    slice;

}  // namespace arenite::ffp
