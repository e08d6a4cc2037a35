// must print: NodalAveraging and ElementAverage work on linear simplices; on B-splines use NoAntiLocking
// Nodal averaging needs one volumetric strain a cell.
#include <arenite/arenite.hpp>

using namespace arenite;

int main() { return sizeof(Numerics<QuadraticBSpline, Flip, Musl, NodalAveraging>); }
