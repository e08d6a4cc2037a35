// Kernels with linear functions on a grid against the reference, and what they conserve.
#include "check_grid.hpp"

using namespace arenite;
using namespace arenite::test;

TEST_CASE("linear functions on a grid: P2G, MUSL mapping and G2P are the formulas of one point") {
  check_all_references<LinearGrid>();
}

TEST_CASE("linear functions on a grid conserve mass and momentum") { check_all_conservation<LinearGrid>(); }
