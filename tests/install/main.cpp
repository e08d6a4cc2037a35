// A user's program: everything comes from the installed package.
#include <cmath>
#include <cstdio>

#include "other.hpp"

using namespace arenite;

int main() {
  // TODO(scene): run a small scene here and in other.cpp.
  const double here = trace(Sym<double, 3>{{1_kPa, 2_kPa, 3_kPa, 0, 0, 0}});
  const double there = mean_stress_elsewhere();
  std::printf("mean stress %g Pa here, %g Pa in the other unit, on %d threads\n", here / 3, there, threads());
  return std::abs(here / 3 - there) < 1e-9 ? 0 : 1;
}
