// Cost of each stage of a step on quadratic B-splines, beside the scalar rivals' stages.
#include "stages.hpp"
#include "whole_rivals.hpp"

int main(int argc, char** argv) {
  using namespace arenite;
  using namespace arenite::bench;
  const double n = 1e5;
  const Blocks2d fine{.cells = 320};
  add_stages("bspline_3d_apic_usl_drucker_prager", [=] { return spline_scene<double, 3>(grains(), n); });
  add_stages("bspline_3d_apic_usl_drucker_prager_rival",
             [=] { return spline_rival<double>(rival_grains<double>(), n); });
  add_stages("bspline_3d_flip_musl_drucker_prager",
             [=] { return spline_scene<double, 3, Flip, Musl>(grains(), n); });
  add_stages("bspline_2d_apic_usl_elastic", [=] { return blocks_scene<double>(fine); });
  add_stages("bspline_2d_apic_usl_elastic_rival", [=] { return blocks_rival<double>(fine); });
  add_stages("bspline_2d_flip_usl_elastic", [=] { return spline_scene<double, 2, Flip, Usl>(elastic(), n); });
  add_stages("bspline_2d_flip_musl_elastic",
             [=] { return spline_scene<double, 2, Flip, Musl>(elastic(), n); });
  return run_benchmarks(argc, argv);
}
