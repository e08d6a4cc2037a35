// Conservation of mass and momentum on quadratic B-splines.
#include "check_grid.hpp"

using namespace arenite;
using namespace arenite::test;

TEST_CASE("quadratic B-splines conserve mass and momentum") { check_all_conservation<QuadraticBSpline>(); }
