// A contact of bodies of your own: two phases that lie in one place and drag each other. Where both have
// mass at a node their velocities approach each other with the time tau. Then v_1 - v_2 falls as exp(-t /
// tau), momentum is kept, and the drag dissipates the energy of the relative motion.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/extend/own_contact.cpp -o own_contact -pthread && ./own_contact
//   prints: relative velocity 0.1353 m/s (exact 0.1353), dissipated 22.088 J (exact 22.088)
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

/// The recipe is the part: it needs nothing of the mesh.
struct Drag {
  using OnlyOne = ContactOfBodies;                // a scene has one at most
  static constexpr bool separates_bodies = true;  // a velocity field for each body
  static constexpr int contact_order = 0;         // bodies with each other, before rigid bodies
  double tau;                                     // s
  double dissipated = 0;                          // since the start, J

  template <class Scene>
  ContactTally apply_impulses(Scene& scene, double dt) {
    auto& [first, second] = scene.fields;
    ContactTally tally;
    for (std::size_t i = 0; i < first.size(); ++i) {
      const double m1 = first.mass[i], m2 = second.mass[i];
      if (!(m1 > 0 && m2 > 0)) continue;
      const double mass = m1 * m2 / (m1 + m2);
      const Vec<double, 2> relative = first.velocity[i] - second.velocity[i];
      const Vec<double, 2> impulse = mass * std::expm1(-dt / tau) * relative;  // on the first
      first.velocity[i] += impulse / m1;
      second.velocity[i] -= impulse / m2;
      tally.dissipation -= impulse.dot(relative + impulse / (2 * mass));
      ++tally.nodes;
    }
    dissipated += tally.dissipation;
    return tally;
  }
  PartEnergy count_energy() const { return {.dissipated = dissipated}; }
  template <class F>
  void visit_state(F&& f) {
    f("dissipated", dissipated);
  }
};

int main() {
  on_warning([](const std::string&) {});  // that bodies lie in one place is meant
  const LinearElastic skeleton{{.density = 1500, .young = 1_MPa, .poisson = 0.3}};
  const LinearElastic filling{{.density = 500, .young = 1_MPa, .poisson = 0.3}};
  const double tau = 1e-3, end = 2e-3;
  Scene scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 0.6}, .cell = 0.1}},
              Numerics<QuadraticBSpline, Flip, Usl>{},
              bodies(fill(Box{{0.2, 0.2}, {0.8, 0.4}}, skeleton, {.per_cell = 4}),
                     fill(Box{{0.2, 0.2}, {0.8, 0.4}}, filling, {.per_cell = 4, .velocity = {1, 0, 0}})),
              Drag{.tau = tau}};
  run(scene, {.end = end});
  const auto mean = [](const auto& body) { return momentum(body)[0] / mass(body); };
  const double apart = mean(scene.body<1>()) - mean(scene.body<0>()), exact = std::exp(-end / tau);
  const double m1 = mass(scene.body<0>()), m2 = mass(scene.body<1>());
  const double lost = m1 * m2 / (m1 + m2) / 2 * (1 - exact * exact);
  const double total = momentum(scene.body<0>())[0] + momentum(scene.body<1>())[0];
  std::printf("relative velocity %.4f m/s (exact %.4f), dissipated %.3f J (exact %.3f)\n", apart, exact,
              scene.part<Drag>().dissipated, lost);
  return std::abs(apart - exact) < 0.01 && std::abs(scene.part<Drag>().dissipated / lost - 1) < 0.02 &&
                 std::abs(total / m2 - 1) < 1e-12
             ? 0
             : 1;
}
