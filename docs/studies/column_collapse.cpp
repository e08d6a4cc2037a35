// Collapse of columns of sand, plane and axisymmetric, on two meshes and with both memories of separation, and what each choice of a model makes
// of three plane ones, beside the correlations of Lube et al. Writes what docs/validation.py puts into docs/validation.md:
//
//   c++ -O3 -march=native -std=c++20 -isystem include -isystem /usr/include/eigen3 docs/studies/column_collapse.cpp -o collapse && ./collapse
//
// Some ten minutes on one core.
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

/// A model of a collapse; each row of the second table differs from this one in one choice.
struct Model {
  double cell = width / 20;  // m
  double courant = 0.8;
  unsigned per_cell = 4;
  MohrCoulombParameters sand{.density = 1540, .young = 1e6, .poisson = 0.3, .friction = 31_deg};
  Flip flip{.time = 0.1};
};

template <class Kinematics, class Memory = ForgetsOpening, class Transfer = Flip, class Order = Musl>
double collapse(double a, const Model& model) {
  const double height = a * width, cell = model.cell,
               reach = width * (2 + 1.3 * measured(std::same_as<Kinematics, PlaneStrain>, a));
  const auto whole = [&](double x) { return cell * std::ceil(x / cell); };
  Numerics<QuadraticBSpline, Transfer, Order> numerics;
  if constexpr (std::same_as<Transfer, Flip>) numerics.transfer = model.flip;
  Scene scene{Kinematics{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {whole(reach), whole(1.2 * height)}, .cell = cell}},
              numerics,
              bodies(fill(Box{{0., 0.}, {width, height}}, MohrCoulomb<Memory>{model.sand},
                          {.per_cell = model.per_cell})),
              walls(bottom(fixed), left(roller)),
              gravity({0, -9.81})};
  run(scene, {.end = 5 * std::sqrt(height / 9.81), .courant = model.courant});
  return run_out<Kinematics>(scene.body().points);
}

}  // namespace

int main() {
  test::Validation columns("column_collapse", "measured"), choices("column_collapse_choices", "measured");
  const auto compare = [&](const std::string& name, bool is_plane, auto& table,
                           std::initializer_list<double> ratios, auto&& compute) {
    for (const double a : ratios) {
      const double computed = compute(a);
      std::printf("%s; a = %g: %.3f, measured %.3f\n", name.c_str(), a, computed, measured(is_plane, a));
      std::fflush(stdout);
      table.value(name, joined_text({"run-out over the width at a = ", a}), "-", computed,
                  measured(is_plane, a));
      if (&table == &columns)
        table.point(name, "height over width", a, "run-out over width", computed, measured(is_plane, a));
    }
  };
  for (const double cell : {width / 10, width / 20}) {
    const auto column = [&](const char* kind, bool is_plane, auto&& compute) {
      compare(joined_text({kind, "; cells of ", 1e3 * cell, " mm"}), is_plane, columns, {0.5, 1.0, 2.0, 5.0},
              compute);
    };
    const Model model{.cell = cell};
    column("plane; forgets", true, [&](double a) { return collapse<PlaneStrain>(a, model); });
    column("plane; remembers", true,
           [&](double a) { return collapse<PlaneStrain, RemembersOpening>(a, model); });
    column("axisymmetric; forgets", false, [&](double a) { return collapse<Axisymmetric>(a, model); });
    column("axisymmetric; remembers", false,
           [&](double a) { return collapse<Axisymmetric, RemembersOpening>(a, model); });
  }

  const auto choice = [&](const char* name, auto&& compute) {
    compare(name, true, choices, {0.5, 1.0, 2.0}, compute);
  };
  const auto changed = [&](const char* name, auto&& change) {
    Model model;
    change(model);
    choice(name, [&](double a) { return collapse<PlaneStrain>(a, model); });
  };
  changed("the model", [](Model&) {});
  changed("cells of 10 mm", [](Model& m) { m.cell *= 2; });
  changed("cells of 2.5 mm", [](Model& m) { m.cell /= 2; });
  changed("9 points a cell", [](Model& m) { m.per_cell = 9; });
  changed("Courant number 0.4", [](Model& m) { m.courant = 0.4; });
  changed("Courant number 0.2", [](Model& m) { m.courant = 0.2; });
  changed("FLIP", [](Model& m) { m.flip = {}; });
  choice("AFLIP", [](double a) { return collapse<PlaneStrain, ForgetsOpening, Aflip>(a, {}); });
  choice("APIC", [](double a) { return collapse<PlaneStrain, ForgetsOpening, Apic>(a, {}); });
  choice("APIC; Courant number 0.2",
         [](double a) { return collapse<PlaneStrain, ForgetsOpening, Apic>(a, {.courant = 0.2}); });
  choice("FLIP with a time; USL",
         [](double a) { return collapse<PlaneStrain, ForgetsOpening, Flip, Usl>(a, {}); });
  choice("remembers its opening", [](double a) { return collapse<PlaneStrain, RemembersOpening>(a, {}); });
  changed("friction 28 deg", [](Model& m) { m.sand.friction = 28_deg; });
  changed("friction 34 deg", [](Model& m) { m.sand.friction = 34_deg; });
  changed("dilatancy 5 deg", [](Model& m) { m.sand.dilatancy = 5_deg; });
  changed("E = 10 MPa", [](Model& m) { m.sand.young = 1e7; });
}
