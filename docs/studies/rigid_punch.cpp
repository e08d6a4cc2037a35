// A rigid flat punch and a rigid ball on an elastic half-space, axisymmetric and smooth, beside the solutions
// of Boussinesq, F = 2 E* a d, and Hertz, F = 4/3 E* R^(1/2) d^(3/2): for each contact of a rigid body the
// distance from the surface at which it acts under a given load, at three sizes of the cells and four places
// of the surface in them, and its order. Writes what docs/validation.py puts into docs/validation.md:
//
//   c++ -O3 -std=c++20 -isystem include -isystem /usr/include/eigen3 docs/studies/rigid_punch.cpp -o punch &&
//   ./punch
//
// Some ten minutes on one core.
#include <algorithm>
#include <arenite/arenite.hpp>
#include <arenite/mesh/box_mesh.hpp>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "../../tests/support/validation.hpp"

using namespace arenite;

namespace {

constexpr double radius = 0.1, ball_radius = 10 * radius;  // of the punch and of the ball, m
const LinearElastic matter{{.density = 1000, .young = 1e6, .poisson = 0.3}};
constexpr double plane_modulus = 1e6 / (1 - 0.3 * 0.3);  // E*, Pa

enum class Indenter { punch, ball };

/// The load at which distances are compared, N: the ball's contact is as wide as the punch, a tenth of its
/// radius, and it goes 0.1 a deep; the punch 0.02 a.
double load_of(Indenter indenter) {
  const double d = indenter == Indenter::punch ? 0.02 * radius : radius * radius / ball_radius;
  return indenter == Indenter::punch ? 2 * plane_modulus * radius * d
                                     : 4. / 3 * plane_modulus * std::sqrt(ball_radius) * std::pow(d, 1.5);
}
/// Depth below the surface of a half-space that belongs to a force, m.
double exact_depth(Indenter indenter, double force) {
  return indenter == Indenter::punch
             ? force / (2 * plane_modulus * radius)
             : std::pow(force * 3 / 4 / plane_modulus / std::sqrt(ball_radius), 2. / 3);
}

/// Cells of `radius` / `cells` in a domain of `domain` radii, both ways.
struct Size {
  int cells;
  int domain = 4;
  double edge() const { return radius / cells; }
  double extent() const { return radius * domain; }
};

template <class Shape_, class Coupling_, int per_cell_>
struct Contact {
  using Shape = Shape_;
  using Coupling = Coupling_;
  static constexpr int per_cell = per_cell_;
  std::string name;
  double reach = 0.5;
};

/// Three cells higher than the matter at least.
template <class Shape>
auto mesh_of(const Size& s) {
  const auto across = static_cast<Index>(s.cells * s.domain);
  if constexpr (std::same_as<Shape, LinearSimplex>)
    return SimplexMesh<2>(box_mesh<2>({{0, -s.extent()}, {s.extent(), 4 * s.edge()}, {across, across + 4}}));
  else
    return CartesianGrid<2>{
        {.lower = {0, -s.extent()}, .upper = {s.extent(), 4 * s.edge()}, .cell = s.edge()}};
}

/// How deep an indenter is below the undisturbed surface, m, and what it bears there, N.
struct Rest {
  double depth, force;
};

/// Lowers an indenter until it bears each of some loads, and lets all come to rest there. `part`: how far the
/// surface lies above a line of the mesh, in cells.
template <class Contact>
std::vector<Rest> press(const Contact& contact, Indenter indenter, const Size& size, double part,
                        const std::vector<double>& loads) {
  const double edge = size.edge(), top = part * edge, start = top + 2 * edge;
  const auto down = std::make_shared<double>(0.0);  // speed, m/s
  const auto distance = [=](const auto& x) {
    if (indenter == Indenter::ball) return std::hypot(x[0], x[1] - start - ball_radius) - ball_radius;
    const double r = x[0] - radius, y = start - x[1];
    return r > 0 && y > 0 ? std::hypot(r, y) : std::max(r, y);
  };
  Scene scene{
      Axisymmetric{},
      mesh_of<typename Contact::Shape>(size),
      Numerics<typename Contact::Shape, Flip, Usl>{},
      bodies(fill(Box{{0., -size.extent()}, {size.extent(), 0.}}, matter, {.per_cell = Contact::per_cell})),
      walls(left(roller), right(roller), bottom(roller)),
      LocalDamping{},
      rigid<"indenter">(DistanceSurface{distance, contact.reach}, Prescribed{[down](double) {
                          return std::array<double, 3>{0, -*down, 0};
                        }},
                        Friction::frictionless(), typename Contact::Coupling{})};
  auto& positions = scene.template body<0>().points.position;
  for (std::size_t p = 0; p < positions.size(); ++p)
    positions.set(p, positions[p] + top * Vec<double, 2>::Unit(1));
  const auto& body = scene.template rigid<"indenter">();
  const double wave = std::sqrt(matter.wave_modulus() / matter.density());
  constexpr double courant = 0.9;
  std::vector<Rest> rests;
  for (const double load : loads) {
    *down = 5e-4 * wave;
    run(scene, {.end = scene.time + 100, .courant = courant},
        [&](const auto&) { return body.force[1] >= load ? RunFlow::stop : RunFlow::go_on; });
    *down = 0;
    run(scene, {.end = scene.time + 10 * size.extent() / wave, .courant = courant});
    const double impulse = body.impulse[1], from = scene.time;  // FLIP swings between two steps
    run(scene, {.end = from + size.extent() / wave, .courant = courant});
    rests.push_back({-body.displacement[1] - 2 * edge, (body.impulse[1] - impulse) / (scene.time - from)});
  }
  return rests;
}

/// By how much a domain of `size` holds an indenter back, m per N. Far away the solution goes as the force
/// over the distance, whatever presses: compliance of a half-space less that of a domain = c / domain, with
/// the c of the punch in domains of 8 and 16 radii; those of 4 and 6 tell how exact that is.
class FarField {
 public:
  FarField() {
    std::map<int, double> compliance;
    const double load = load_of(Indenter::punch);
    for (const int domain : {4, 6, 8, 16}) {
      const auto l = press(Contact<QuadraticBSpline, PointContact, 9>{}, Indenter::punch, {4, domain}, 0,
                           {load, 2 * load});
      compliance[domain] = (l[1].depth - l[0].depth) / (l[1].force - l[0].force);
    }
    factor_ = (compliance[16] - compliance[8]) * 16;
    const double half_space = compliance[16] + factor_ / 16;
    std::printf(
        "compliance over that of Boussinesq: %.4f; domains of 4 and 6 radii, from that: %+.2g, %+.2g\n",
        half_space * 2 * plane_modulus * radius, (compliance[4] + factor_ / 4) / half_space - 1,
        (compliance[6] + factor_ / 6) / half_space - 1);
  }
  double compliance(const Size& size) const { return factor_ / size.domain; }

 private:
  double factor_;
};

/// Distance from the surface at which a contact acts, in cells, at places of the surface in them: that of an
/// indenter in a half-space which bears the same, from where the indenter is.
struct Distances {
  double least, greatest;
};

template <class Contact>
Distances acts_at(const Contact& contact, Indenter indenter, const Size& size, const FarField& far) {
  std::vector<double> all;
  for (const double part : {0., 0.25, 0.5, 0.75}) {
    const Rest r = press(contact, indenter, size, part, {load_of(indenter)}).front();
    const double depth = r.depth + far.compliance(size) * r.force;
    all.push_back((exact_depth(indenter, r.force) - depth) / size.edge());
  }
  return {std::ranges::min(all), std::ranges::max(all)};
}

template <class Contact>
void measure(const Contact& contact, const FarField& far, test::Validation& table) {
  for (const Indenter indenter : {Indenter::punch, Indenter::ball}) {
    const std::string what = contact.name + (indenter == Indenter::punch ? "; flat punch" : "; ball");
    double before = 0;
    for (const int cells : {4, 8, 16}) {
      const Distances d = acts_at(contact, indenter, {cells}, far);
      const std::string at = joined_text({"; cells of a / ", cells});
      std::printf("%s%s: %.3f to %.3f cells\n", what.c_str(), at.c_str(), d.least, d.greatest);
      std::fflush(stdout);
      table.value(what, "least distance" + at, "cells", d.least, 0);
      table.value(what, "greatest distance" + at, "cells", d.greatest, 0);
      const double error = std::max(std::abs(d.least), std::abs(d.greatest)) / cells;
      if (before != 0) table.value(what, "order of the larger one" + at, "-", std::log2(before / error), 1);
      before = error;
    }
  }
}

}  // namespace

int main() {
  test::Validation table("rigid_punch");
  const FarField far;
  measure(Contact<QuadraticBSpline, RigidVelocity, 4>{"B-splines; nodes; reach 0.5"}, far, table);
  measure(Contact<QuadraticBSpline, RigidVelocity, 4>{"B-splines; nodes; reach 0", 0}, far, table);
  measure(Contact<QuadraticBSpline, PointContact, 9>{"B-splines; points"}, far, table);
  measure(Contact<LinearSimplex, RigidVelocity, 3>{"triangles; nodes; reach 0.5"}, far, table);
  measure(Contact<LinearSimplex, RigidVelocity, 3>{"triangles; nodes; reach 0", 0}, far, table);
}
