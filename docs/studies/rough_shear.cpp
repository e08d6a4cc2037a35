// Rigid bodies with a rough surface that slip in Tresca soil: how much more or less than its strength s_u
// the soil resists. A plate, s_u per area; a shaft that is pulled along its axis, pi D L s_u; the sleeve of a
// cone that is pushed in, at most pi D L s_u; a disc and a vane of four blades that turn, 2 pi R^2 s_u a metre
// (of the vane an upper bound). For each contact and size of the cells the least and the greatest ratio to the
// closed form at four places of the body in the cells.
// Writes what docs/validation.py puts into docs/validation.md:
//
//   c++ -O3 -std=c++20 -isystem include -isystem /usr/include/eigen3 docs/studies/rough_shear.cpp -o shear &&
//   ./shear
//
// `./shear slow` runs at a quarter of the speed, which shows what inertia does. Some twelve minutes on one
// core; `./shear sleeve` has the sleeve alone.
#include <algorithm>
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "../../tests/support/validation.hpp"

using namespace arenite;

namespace {

constexpr double radius = 0.5, strength = 10e3, at_start = 10 * strength;  // m, Pa, Pa (the initial pressure)
const MohrCoulomb clay{
    {.density = 2000, .young = 200 * strength, .poisson = 0.3, .friction = 0, .cohesion = strength}};

enum class Form { plate, shaft, sleeve, disc, vane };

template <class Method_, class Coupling_>
struct Contact {
  using Method = Method_;
  using Coupling = Coupling_;
  static constexpr bool on_triangles = std::same_as<typename Method::Shape, LinearSimplex>;
  std::string name;
  int per_cell;
  double reach = 0.5;
  double smaller = 0;  ///< by which the surface is drawn inside of the body's, cells
};

FillOptions options(int per_cell) {
  return {.per_cell = per_cell, .stress = [](const std::array<double, 3>&) {
            return std::array<double, 6>{-at_start, -at_start, -at_start, 0, 0, 0};
          }};
}

/// Impulse over time in the last fifth of a run that takes the surface some way, m, at a speed, m/s.
template <class S, class Impulse>
double mean(S& scene, double way, double speed, const Impulse& impulse) {
  const RunOptions until{.end = 0.8 * way / speed, .courant = 0.8};
  run(scene, until);
  const double before = impulse(), from = scene.time;
  run(scene, {.end = way / speed, .courant = 0.8});
  return std::abs(impulse() - before) / (scene.time - from);
}

/// A plate along x or a shaft along y, in a periodic piece of the soil: pulled along itself.
template <class Contact>
double pull(const Contact& contact, Form form, double cell, double part, double speed) {
  const bool is_plate = form == Form::plate;
  const double face = radius + part * cell, end = cell * std::ceil(3 * radius / cell), length = 4 * cell;
  const auto ratio = [&](auto kinematics, auto grid, auto outer, int across, double area) {
    const int along = 1 - across;
    std::array<double, 3> velocity{};
    velocity[static_cast<std::size_t>(along)] = speed;
    Scene scene{kinematics,
                grid,
                typename Contact::Method{},
                bodies(fill(Inside{[=](const auto& x) { return face - x[across]; }}, clay, options(16))),
                walls(outer),
                rigid<"body">(DistanceSurface{[=](const auto& x) { return x[across] - face; }, contact.reach},
                              Prescribed{[=](double) { return velocity; }}, Friction::no_slip(),
                              typename Contact::Coupling{})};
    const auto& b = scene.template rigid<"body">();
    return mean(scene, 0.03, speed, [&] { return b.impulse[along]; }) / (area * strength);
  };
  if (is_plate)
    return ratio(PlaneStrain{},
                 periodic<0>(CartesianGrid<2>{{.lower = {0, 0}, .upper = {length, end}, .cell = cell}}),
                 top(fixed), 1, length);
  return ratio(Axisymmetric{},
               periodic<1>(CartesianGrid<2>{{.lower = {0, 0}, .upper = {end, length}, .cell = cell}}),
               right(fixed), 0, 2 * pi * face * length);
}

/// The sleeve of a cone of 60 deg, rough all over, that is pushed 2.5 diameters into a cylinder of soil, 3
/// diameters wide, under a constant pressure at its side. At the start the shoulder is at the lid: all soil
/// beside the sleeve has passed the cone. Mean over the last half diameter of what the nodes from 1 to 2
/// diameters above the shoulder got of the contact.
template <class Contact>
double push(const Contact& contact, double cell, double part, double speed) {
  const double face = radius + part * cell, way = 5 * radius, tip = 2 * radius + way,
               shoulder = tip + face / std::tan(pi / 6), lid = cell * std::ceil(shoulder / cell),
               side = cell * std::ceil(3 * radius / cell), length = 2 * radius;
  const ConeCylinder cone{{.radius = face, .apex = 60_deg, .length = lid + way, .tip = tip}};
  Scene scene{Axisymmetric{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {side + 8 * cell, lid}, .cell = cell}},
              typename Contact::Method{},
              bodies(fill(Inside{[=](const auto& x) { return std::max(-cone(x), x[0] - side); }}, clay,
                          options(contact.per_cell))),
              walls(left(roller), bottom(roller), top(roller)),
              pressure(surface(Inside{[=](const auto& x) { return side - cell - x[0]; }},
                               {.normal = Triple{1., 0., 0.}, .thickness = cell}),
                       at_start),
              rigid<"cone">(DistanceSurface{cone, contact.reach}, Prescribed{[=](double) {
                              return std::array<double, 3>{0, -speed, 0};
                            }},
                            Friction::no_slip(), typename Contact::Coupling{})};
  double impulse = 0, from = 0;
  run(scene, {.end = way / speed, .courant = 0.8}, [&](const auto& s) {
    if (speed * s.time < way - radius) {
      from = s.time;
      return;
    }
    using Shape = typename Contact::Method::Shape;
    for (const auto& t : s.template rigid<"cone">().touched_nodes) {
      const double above = Shape::node_position(s.mesh, t.node)[1] - (shoulder - speed * s.time);
      if (length <= above && above < 2 * length) impulse -= t.impulse[1];
    }
  });
  return impulse / (scene.time - from) / (2 * pi * face * length * strength);
}

/// A disc, or a vane with blades a quarter of its radius thick, turns in a square of soil.
template <class Contact>
double turn(const Contact& contact, Form form, double cell, double part, double speed) {
  const double half = cell * std::ceil(2 * radius / cell), blade = radius / 8, in = contact.smaller * cell;
  const Vec<double, 2> centre(part * cell, 0.7 * part * cell);
  const auto distance = [=](const auto& x) {
    const double a = std::abs(x[0] - centre[0]), b = std::abs(x[1] - centre[1]);
    if (form == Form::disc) return std::hypot(a, b) - (radius - in);
    const auto bar = [=](double along, double across) {
      const double u = along - (radius - in), v = across - (blade - in);
      return u > 0 && v > 0 ? std::hypot(u, v) : std::max(u, v);
    };
    return std::min(bar(a, b), bar(b, a));
  };
  const auto mesh = [&] {
    const auto n = static_cast<Index>(std::lround(2 * half / cell));
    if constexpr (Contact::on_triangles)
      return SimplexMesh<2>(box_mesh<2>({{-half, -half}, {half, half}, {n, n}}));
    else
      return CartesianGrid<2>{{.lower = {-half, -half}, .upper = {half, half}, .cell = cell}};
  };
  const double spin = speed / radius;
  Scene scene{
      PlaneStrain{},
      mesh(),
      typename Contact::Method{},
      bodies(fill(Inside{[=](const auto& x) { return -distance(x); }}, clay, options(contact.per_cell))),
      walls(left(fixed), right(fixed), bottom(fixed), top(fixed)),
      rigid<"body">(DistanceSurface{distance, contact.reach},
                    PrescribedPose{.centre = {centre[0], centre[1]},
                                   .spin =
                                       [=](double) {
                                         return std::array<double, 3>{0, 0, spin};
                                       }},
                    Friction::no_slip(), typename Contact::Coupling{})};
  const auto& b = scene.template rigid<"body">();
  return mean(scene, 0.03, speed, [&] { return b.angular_impulse[0]; }) /
         (2 * pi * square(radius) * strength);
}

template <class Contact>
void measure(const Contact& contact, const std::vector<Form>& forms, double speed, test::Validation& table,
             const std::vector<int>& all_cells = {8, 16, 32}) {
  static const std::array<std::string, 5> names{"plate", "shaft", "sleeve", "disc", "vane"};
  for (const Form form : forms)
    for (const int cells : all_cells) {
      std::vector<double> all;
      for (const double part : {0., 0.25, 0.5, 0.75}) {
        const double cell = 2 * radius / cells;
        if (form >= Form::disc)
          all.push_back(turn(contact, form, cell, part, speed));
        else if constexpr (!Contact::on_triangles)
          all.push_back(form == Form::sleeve ? push(contact, cell, part, speed)
                                             : pull(contact, form, cell, part, speed));
      }
      const auto [least, greatest] = std::ranges::minmax(all);
      const std::string what = names[static_cast<std::size_t>(form)] + "; " + contact.name;
      const std::string at = joined_text({"; ", cells, " cells across"});
      std::printf("%s%s: %.3f to %.3f\n", what.c_str(), at.c_str(), least, greatest);
      std::fflush(stdout);
      table.value(what, "least ratio" + at, "-", least, 1);
      table.value(what, "greatest ratio" + at, "-", greatest, 1);
    }
}

}  // namespace

int main(int count, char** words) {
  const std::string asked = count > 1 ? words[1] : "";
  const double wave = std::sqrt(clay.wave_modulus() / clay.density()),
               speed = (asked == "slow" ? 1.25e-4 : 5e-4) * wave;
  using Splines = Numerics<QuadraticBSpline, Apic, Usl>;
  test::Validation table("rough_shear");
  const std::vector<Form> turning{Form::disc, Form::vane},
      all{Form::plate, Form::shaft, Form::disc, Form::vane};
  // The way of the cone is long: eight times as fast, with FLIP, which takes nothing from the sheared layer.
  using SplinesFlip = Numerics<QuadraticBSpline, Flip, Usl>;
  const double fast = 4e-3 * wave;
  measure(Contact<SplinesFlip, RigidVelocity>{"FLIP; nodes; reach 0.5", 4}, {Form::sleeve}, fast, table,
          {8, 16});
  measure(Contact<SplinesFlip, RigidVelocity>{"FLIP; nodes; reach 0", 4, 0}, {Form::sleeve}, fast, table,
          {8, 16});
  measure(Contact<SplinesFlip, PointContact>{"FLIP; points", 9}, {Form::sleeve}, fast, table, {8, 16});
  if (asked == "sleeve") return 0;
  measure(Contact<Splines, RigidVelocity>{"B-splines; nodes; reach 0.5", 4}, all, speed, table);
  measure(Contact<Splines, RigidVelocity>{"B-splines; nodes; reach 0", 4, 0}, all, speed, table);
  measure(Contact<Splines, PointContact>{"B-splines; points", 9}, all, speed, table);
  measure(Contact<Splines, RigidVelocity>{"B-splines; nodes; reach 0.5; a cell smaller", 4, 0.5, 1},
          {Form::disc}, speed, table);
  measure(
      Contact<Numerics<LinearSimplex, Flip, Usl, NodalAveraging>, RigidVelocity>{
          "triangles; nodes; reach 0.5", 6},
      turning, speed, table);
}
