// must print: Numerics: on linear simplices MUSL maps back velocities without a gradient
// A damped TPIC hands a node another velocity than it took: the cells' edge masses do not know which.
#include <arenite/arenite.hpp>

using namespace arenite;

struct Damped : Tpic {
  template <class Shape>
  static constexpr bool returns_unchanged = false;
};

int main() { return Numerics<LinearSimplex, Damped, Musl>{}.transfer.affine ? 0 : 1; }
