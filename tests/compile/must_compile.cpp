// must compile
// The control: if the harness's flags were wrong, every snippet would be refused, and this one too.
#include <arenite/core/tensor.hpp>
#include <arenite/core/units.hpp>

using namespace arenite;

int main() {
  constexpr Sym<double, 2> stress{{1_kPa, 2_kPa, 3_kPa, 0_Pa}};
  static_assert(trace(stress) > 5.9_kPa);
  return Vec<double, 3>::Zero().size() == 3 ? 0 : 1;
}
