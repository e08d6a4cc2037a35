// must print: Prescribed: the velocity must be callable as std::array<double, 3> velocity(double time) const
// A speed instead of a velocity.
#include <arenite/arenite.hpp>

using namespace arenite;

int main() {
  Prescribed motion{[](double) { return -1.0; }};
}
