// must point here, with: FillOptions
// errors: 1
// No sentence of ours can stand here: the compilers name the options, and the line.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

const auto block = fill(Box{{0., 0.}, {1., 1.}}, steel, {.per_cel = 4});

int main() { return block.law.density() > 0; }
