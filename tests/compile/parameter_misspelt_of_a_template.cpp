// must point here, with: MohrCoulombParameters
// Only g++ names the parameters of a law that is a template; its two errors are one.
#include <arenite/arenite.hpp>

using namespace arenite;

const MohrCoulomb soil{{.density = 7800, .young = 2e11, .poisson = 0.3, .frction = 0.2}};

int main() { return soil.density() > 0; }
