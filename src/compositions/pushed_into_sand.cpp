// Compiles `compositions::PushedIntoSand` (arenite/compositions.hpp).
#include <arenite/compositions.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template struct Scene<Axisymmetric, CartesianGrid<2>, Numerics<QuadraticBSpline>, Bodies<Fill<MohrCoulomb<>>>,
                      Walls, Gravity, Rigid<DistanceSurface<>, Prescribed>>;
template void step(compositions::PushedIntoSand&, double);
template double stable_step(const compositions::PushedIntoSand&);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
