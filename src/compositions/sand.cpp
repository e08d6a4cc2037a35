// Compiles `compositions::Sand` (arenite/compositions.hpp).
#include <arenite/compositions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template struct Scene<ThreeDimensional, CartesianGrid<3>, Numerics<QuadraticBSpline, Apic>,
                      Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity>;
template void step(compositions::Sand&, double);
template double stable_step(const compositions::Sand&);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
