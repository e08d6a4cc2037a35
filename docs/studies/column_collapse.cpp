// Collapse of columns of sand, plane and axisymmetric, on two meshes and with both memories of separation,
// beside the correlations of Lube et al. Writes what docs/validation.py puts into docs/validation.md:
//
//   c++ -O3 -std=c++20 -isystem include -isystem /usr/include/eigen3 docs/studies/column_collapse.cpp -o
//   collapse
//   && ./collapse
//
// Some three minutes on one core.
#include <algorithm>
#include <arenite/arenite.hpp>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "../../tests/support/validation.hpp"

using namespace arenite;

namespace {

constexpr double width = 0.1;  // of half a plane column; radius of a round one, m

/// Run-out over the initial width: Lube et al. 2005 (plane), 2004 (axisymmetric), of the aspect ratio a.
double measured(bool is_plane, double a) {
  if (is_plane) return a < 1.8 ? 1.2 * a : 1.9 * std::pow(a, 2.0 / 3);  // the second from a = 2.8 on
  return a < 1.7 ? 1.24 * a : 1.6 * std::sqrt(a);
}

/// The front over the width, less 1: of columns of a tenth of the width, from the axis outwards, the last one
/// without a gap that holds matter 1/40 of the width deep, the same on each mesh. Single grains ahead of it
/// are not counted in experiments either.
template <class Kinematics, class Points>
double run_out(const Points& points) {
  const double column = width / 10;
  std::vector<double> filled, farthest;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double x = points.position[p][0];
    const auto k = static_cast<std::size_t>(x / column);
    if (k >= filled.size()) {
      filled.resize(k + 1, 0);
      farthest.resize(k + 1, 0);
    }
    filled[k] += points.volume[p] / Kinematics::thickness(points.position[p]);
    farthest[k] = std::max(farthest[k], x);
  }
  std::size_t front = 0;
  while (front + 1 < filled.size() && filled[front + 1] >= column * width / 40) ++front;
  return farthest[front] / width - 1;
}

template <class Kinematics, class Memory>
double collapse(double a, double cell) {
  const bool is_plane = std::same_as<Kinematics, PlaneStrain>;
  const MohrCoulomb<Memory> sand{{.density = 1540, .young = 1e6, .poisson = 0.3, .friction = 31_deg}};
  const double height = a * width, reach = width * (2 + 1.3 * measured(is_plane, a));
  const auto whole = [&](double x) { return cell * std::ceil(x / cell); };
  Scene scene{Kinematics{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {whole(reach), whole(1.2 * height)}, .cell = cell}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0., 0.}, {width, height}}, sand, {.per_cell = 4})),
              walls(bottom(fixed), left(roller)),
              gravity({0, -9.81})};
  run(scene, {.end = 5 * std::sqrt(height / 9.81), .courant = 0.8});
  return run_out<Kinematics>(scene.body().points);
}

}  // namespace

int main() {
  test::Validation validation("column_collapse", "measured");
  const auto compare = [&](const char* kind, bool is_plane, const char* memory, double cell, auto&& compute) {
    for (const double a : {0.5, 1.0, 2.0, 5.0}) {
      const double computed = compute(a);
      std::printf("%s; %s; cells of %g mm; a = %g: %.3f, measured %.3f\n", kind, memory, 1e3 * cell, a,
                  computed, measured(is_plane, a));
      std::fflush(stdout);
      const std::string name = joined_text({kind, "; ", memory, "; cells of ", 1e3 * cell, " mm"});
      validation.value(name, joined_text({"run-out over the width at a = ", a}), "-", computed,
                       measured(is_plane, a));
      validation.point(name, "height over width", a, "run-out over width", computed, measured(is_plane, a));
    }
  };
  for (const double cell : {width / 10, width / 20}) {
    compare("plane", true, "forgets", cell,
            [&](double a) { return collapse<PlaneStrain, ForgetsOpening>(a, cell); });
    compare("plane", true, "remembers", cell,
            [&](double a) { return collapse<PlaneStrain, RemembersOpening>(a, cell); });
    compare("axisymmetric", false, "forgets", cell,
            [&](double a) { return collapse<Axisymmetric, ForgetsOpening>(a, cell); });
    compare("axisymmetric", false, "remembers", cell,
            [&](double a) { return collapse<Axisymmetric, RemembersOpening>(a, cell); });
  }
}
