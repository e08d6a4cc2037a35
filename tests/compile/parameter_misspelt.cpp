// must point here, with: LinearElasticParameters
// errors: 1
// No sentence of ours can stand here: the compilers name the parameters, and the line.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic soil{{.density = 7800, .youngs = 2e11, .poisson = 0.3}};

int main() { return soil.density() > 0; }
