// must print: Numerics: APIC needs B-splines
// APIC's inertia tensor is singular at a node of a linear simplex.
#include <arenite/arenite.hpp>

using namespace arenite;

int main() { return Numerics<LinearSimplex, Apic>{}.transfer.affine ? 0 : 1; }
