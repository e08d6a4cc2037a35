// Kernels with cubic B-splines against the reference, and what they conserve.
#include "check_grid.hpp"

using namespace arenite;
using namespace arenite::test;

TEST_CASE("cubic B-splines: P2G, MUSL mapping and G2P are the formulas of one point") {
  check_all_references<CubicBSpline>();
}

TEST_CASE("cubic B-splines conserve mass and momentum") { check_all_conservation<CubicBSpline>(); }
