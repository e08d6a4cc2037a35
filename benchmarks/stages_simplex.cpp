// Cost of each stage of a step on triangles and tetrahedra, beside the scalar rivals' stages.
#include "stages.hpp"
#include "whole_rivals.hpp"

int main(int argc, char** argv) {
  using namespace arenite;
  using namespace arenite::bench;
  const double n = 1e5;
  add_stages("tetrahedra_flip_musl_averaged_mohr_coulomb",
             [=] { return tetrahedral_scene<double, NodalAveraging>(sand(), n); });
  add_stages("tetrahedra_flip_musl_averaged_mohr_coulomb_rival",
             [=] { return tetrahedral_rival<double>(rival_sand<double>(), n, true); });
  add_stages("tetrahedra_flip_musl_averaged_mohr_coulomb_float",
             [=] { return tetrahedral_scene<float, NodalAveraging>(sand(), n); });
  add_stages("tetrahedra_flip_musl_elastic",
             [=] { return tetrahedral_scene<double, NoAntiLocking>(elastic(), n); });
  add_stages("tetrahedra_flip_musl_elastic_rival",
             [=] { return tetrahedral_rival<double>(rival_elastic<double>(), n, false); });
  add_stages("tetrahedra_tpic_usl_elastic",
             [=] { return tetrahedral_scene<double, NoAntiLocking, Tpic, Usl>(elastic(), n); });
  add_stages("triangles_flip_musl_elastic",
             [=] { return triangular_scene<PlaneStrain, NoAntiLocking, Flip, Musl>(elastic(), n); });
  add_stages("triangles_tpic_usl_elastic",
             [=] { return triangular_scene<PlaneStrain, NoAntiLocking, Tpic, Usl>(elastic(), n); });
  add_stages("axisymmetric_flip_musl_both_averages_mohr_coulomb",
             [=] { return triangular_scene<Axisymmetric, NodalAndElementAverage, Flip, Musl>(sand(), n); });
  return run_benchmarks(argc, argv);
}
