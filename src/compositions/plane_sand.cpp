// Compiles `compositions::PlaneSand` (arenite/compositions.hpp).
#include <arenite/compositions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template struct Scene<PlaneStrain, CartesianGrid<2>, Numerics<QuadraticBSpline, Apic>,
                      Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity>;
template void step(compositions::PlaneSand&, double);
template double stable_step(const compositions::PlaneSand&);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
