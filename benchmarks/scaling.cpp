// How the cost of a point-step grows with the number of points, and what two threads make of it: tetrahedra,
// Mohr-Coulomb, nodal averaging.
//   --short  up to 100,000 points        --huge  10,000,000 points too (some 10 GB)
#include "whole.hpp"

int main(int argc, char** argv) {
  using namespace arenite::bench;
  const bool brief = take_flag(argc, argv, "--short"), huge = take_flag(argc, argv, "--huge");
  struct Size {
    double points;
    int steps;
    bool wanted;
  };
  for (const Size& size :
       {Size{1e4, 200, true}, Size{1e5, 30, true}, Size{1e6, 10, !brief}, Size{1e7, 10, huge}})
    for (const int threads : {1, 2})
      if (size.wanted)
        add_steps("scaling/tetrahedra_mohr_coulomb/double/points:" + std::to_string(std::lround(size.points)),
                  {.steps = size.steps, .threads = threads}, [n = size.points] {
                    return tetrahedral_scene<double, arenite::NodalAveraging>(sand(), n);
                  });
  return run_benchmarks(argc, argv);
}
