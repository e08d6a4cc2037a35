// must print: transfer: iterations must be int iterations() const, beside iterated(nodes, i)
// A number of iterations that no loop can count to.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Half : Flip {
  double iterations() const { return 0.5; }
};

int main() { return Numerics<QuadraticBSpline, Half>{}.transfer.affine ? 0 : 1; }
