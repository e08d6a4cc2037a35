// must print: out_of_balance: the scene does not keep the forces of its nodes: name a part that damps
// APIC with USL on B-splines sums momentum and forces as one where no part reads them.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline, Apic, Usl>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel))};
  settle(scene, {.end = 1});
}
