// Compiles `compositions::DroppedIntoSand` (arenite/compositions.hpp).
#include <arenite/compositions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template struct Scene<ThreeDimensional, CartesianGrid<3>, Numerics<QuadraticBSpline, Apic>,
                      Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity, Rigid<DistanceSurface<>, Guided>>;
template void step(compositions::DroppedIntoSand&, double);
template double stable_step(const compositions::DroppedIntoSand&);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
