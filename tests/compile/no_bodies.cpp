// must print: Scene: exactly one bodies(..) is needed
// A scene of nothing.
#include <arenite/arenite.hpp>

using namespace arenite;

int main() {
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, gravity({0, -9.81})};
}
