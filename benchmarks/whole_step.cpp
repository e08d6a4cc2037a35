// Whole steps of one scene of each family, in float and double, on one thread and two, each beside its rival.
//   --short  20,000 points and fewer steps: whether it works, not how fast it is
#include "whole.hpp"
#include "whole_rivals.hpp"

namespace arenite::bench {
namespace {

struct Size {
  double points;
  int steps, rival_steps;
};

/// A scene on one thread and two, and its rival on one.
template <class Make, class MakeRival>
void add(const std::string& name, const Size& size, Make make, MakeRival make_rival) {
  for (const int threads : {1, 2})
    add_steps("step/" + name + "/arenite", {.steps = size.steps, .threads = threads}, make);
  add_steps("step/" + name + "/rival", {.steps = size.rival_steps}, make_rival);
}

template <class T>
void add_scalar(const Size& size, const std::string& scalar) {
  const double n = size.points;
  add(
      "tetrahedra_mohr_coulomb/" + scalar, size,
      [n] { return tetrahedral_scene<T, NodalAveraging>(sand(), n); },
      [n] { return tetrahedral_rival<T>(rival_sand<T>(), n, true); });
  // The problem at its published size (5,000 points) and at that of the other scenes.
  const Blocks2d published, fine{.cells = n > 5e4 ? 320 : 160};
  add(
      "bspline_2d_elastic_88_lines/" + scalar, {0, 10 * size.steps, 10 * size.rival_steps},
      [=] { return blocks_scene<T>(published); }, [=] { return blocks_rival<T>(published); });
  add(
      "bspline_2d_elastic/" + scalar, size, [=] { return blocks_scene<T>(fine); },
      [=] { return blocks_rival<T>(fine); });
  // With the gradients of the rival.
  for (const auto& [word, o] :
       {std::pair{"bspline_2d_elastic_88_lines_mls/", published}, {"bspline_2d_elastic_mls/", fine}})
    add_steps("step/" + (word + scalar) + "/arenite",
              {.steps = o.cells == 80 ? 10 * size.steps : size.steps, .threads = 1},
              [o = o] { return blocks_scene<T, MlsGradient<QuadraticBSpline>>(o); });
}

}  // namespace
}  // namespace arenite::bench

int main(int argc, char** argv) {
  using namespace arenite::bench;
  const Size size = take_flag(argc, argv, "--short") ? Size{2e4, 10, 5} : Size{1e5, 30, 10};
  check_rivals();
  const double n = size.points;
  add_scalar<double>(size, "double");
  add_scalar<float>(size, "float");
  add(
      "tetrahedra_elastic/double", size,
      [n] { return tetrahedral_scene<double, arenite::NoAntiLocking>(PlainElastic{elastic()}, n); },
      [n] { return tetrahedral_rival<double>(rival_elastic<double>(), n, false); });
  add(
      "bspline_3d_drucker_prager/double", size, [n] { return spline_scene<double, 3>(grains(), n); },
      [n] { return spline_rival<double>(rival_grains<double>(), n); });
  return run_benchmarks(argc, argv);
}
