// must print: Tpic needs linear simplices (use Apic on B-splines)
// TPIC's place is on simplices.
#include <arenite/arenite.hpp>

using namespace arenite;

int main() { return Numerics<QuadraticBSpline, Tpic>{}.transfer.affine ? 0 : 1; }
