// Kernels with quadratic B-splines against the reference.
#include "check_grid.hpp"

using namespace arenite;
using namespace arenite::test;

TEST_CASE("quadratic B-splines: P2G, MUSL mapping and G2P are the formulas of one point") {
  check_all_references<QuadraticBSpline>();
}
