// The other drops as a half-section of triangles. Their devices and laws share kernels, which one unit compiles
// once.
#include "drop_with.hpp"

namespace arenite::ffp {

const DropUnits<AxisymmetricModel, DropKind::elastic, DropKind::law, DropKind::centre_of_mass,
                DropKind::no_averages>
    axisymmetric;

}  // namespace arenite::ffp
