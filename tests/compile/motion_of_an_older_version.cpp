// must print: Rigid: drive(..) of a motion is now called work(..)
// errors: 1
// A motion of a user's own that books its work by the former name.
#include <arenite/arenite.hpp>

using namespace arenite;

const LinearElastic steel{{.density = 7800, .young = 2e11, .poisson = 0.3}};

struct Sinking {
  using V = Vec<double, 2>;
  static constexpr bool has_mass = false;
  V start() const { return {0, -1}; }
  V free_velocity(const V& before, const V&, double, double) const { return before; }
  template <class Body>
  V velocity_in_contact(const Body&, const V& free_velocity) const {
    return free_velocity;
  }
  V after(const V& contact_velocity, const V&, const V&, double) const { return contact_velocity; }
  V mean(const V&, const V& after) const { return after; }
  double drive(const V&, const V&, const V& mean, const V& total) const { return total.dot(mean); }
  double kinetic_energy(const V&) const { return 0; }
  bool holds(const V&) const { return true; }
};

int main() {
  const ConeCylinder cone({.radius = 0.1, .apex = 1, .length = 1});
  Scene scene{PlaneStrain{}, CartesianGrid<2>({.lower = {0, 0}, .upper = {1, 1}, .cell = 0.5}),
              Numerics<QuadraticBSpline>{}, bodies(fill(Box{{0., 0.}, {1., 1.}}, steel)),
              rigid(DistanceSurface{cone}, Sinking{}, Friction(0.1))};
}
