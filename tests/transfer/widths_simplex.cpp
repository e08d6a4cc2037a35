// Packs of any width on simplices.
#include "compare.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

template <std::size_t Bytes>
using Averaged = Numerics<LinearSimplex, Flip, Musl, NodalAndElementAverage, Bytes>;

}  // namespace

TEST_CASE("points of simplices computed one by one or two, four, eight at once agree") {
  check_widths<Averaged, PlaneStrain>(sample_mesh<2>(4), 7);
  check_widths<Averaged, Axisymmetric>(sample_mesh<2>(4), 7);
  check_widths<Averaged, ThreeDimensional>(sample_mesh<3>(3), 10);
}
