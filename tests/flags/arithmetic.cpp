// Arithmetic that the library relies on, for `arithmetic.cmake` to compile with flags that change it: prints what is wrong, or exits
// with 0.
#include <algorithm>
#ifdef WITH_A_SCENE
#include <arenite/arenite.hpp>
#endif
#include <arenite/simd/elementary.hpp>
#include <arenite/tiles/exact_sum.hpp>
#include <cmath>
#include <cstdio>
#include <type_traits>
#include <vector>

using namespace arenite;

namespace {

int failures = 0;

void expect(bool good, const char* what, double value) {
  if (good) return;
  std::printf("%s: %.17g\n", what, value);
  ++failures;
}

/// The worst errors of exp(-x), relative, and of log(x).
template <class T>
void check_elementary() {
  double of_exp = 0, of_log = 0;
  const auto first = [](const T& x) {
    if constexpr (std::is_same_v<T, double>)
      return x;
    else
      return x.lanes()[0];
  };
  for (int k = 1; k < 2000; ++k) {
    const double x = 0.01 * k;
    of_exp = std::max(of_exp, std::abs(first(lane_exp_minus<T>(T(x))) / std::exp(-x) - 1));
    of_log = std::max(of_log, std::abs(first(lane_log<T>(T(x))) - std::log(x)));
  }
  expect(of_exp < 4e-15, "worst error of exp(-x)", of_exp);
  expect(of_log < 2e-15, "worst error of log(x)", of_log);
}

}  // namespace

int main(int argc, char**) {
  check_elementary<double>();
  check_elementary<Pack<double, 4>>();

  const double scale = argc;  // 1, which the compiler does not know
  ExactSum sum;
  std::vector<double> parts{1e16, 1.25, -1e16, 3e-17, 0x1p-1074};
  for (double& x : parts) x *= scale;
  for (int turn = 0; turn < 2; ++turn, std::reverse(parts.begin(), parts.end()))
    for (const double x : parts) sum.add(x);
  expect(sum.value() == 2.5, "exact sum, 2.5", sum.value());

#ifdef WITH_A_SCENE
  // Told when the scene is made, or seen: a step of NaN is refused.
  try {
    const LinearElastic rock{{.density = 2000, .young = 1_MPa, .poisson = 0.3}};
    Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.25}},
                Numerics<QuadraticBSpline, Flip, Musl>{},
                bodies(fill(Box{{0.25, 0.25}, {0.75, 0.75}}, rock, {.per_cell = 4}))};
    step(scene, std::sqrt(-scale));
    expect(false, "a step of NaN was taken", scene.time);
  } catch (const error& told) {
    std::puts(told.what());
  }
#endif
  return failures;
}
