// must print: transfer: sweeps must be int sweeps() const, beside swept(nodes, i)
// A number of sweeps that no loop can count to.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Half : Flip {
  double sweeps() const { return 0.5; }
};

int main() { return Numerics<QuadraticBSpline, Half>{}.transfer.affine ? 0 : 1; }
