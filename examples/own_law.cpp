// A law of your own: a struct with five members is all that a scene asks for. Here a metal with linear
// hardening (von Mises), whose plastic strain is its history; a rod of it hits a wall (Taylor's test). Laws
// that know the time, and one whose stiffness depends on the state: extend/laws.
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

/// Rate-independent: stress depends on the path of the strain, not on the time or the number of steps that it
/// takes.
class HardeningMetal {
 public:
  // History: scalars with a tie of them; each becomes a column. Points begin with these values.
  template <class T>
  struct History {
    T plastic{0};  // equivalent plastic strain, -
    auto members() { return std::tie(plastic); }
    auto members() const { return std::tie(plastic); }
  };

  /// Yield stress in uniaxial tension, Pa: `strength` + `hardening` times the plastic strain.
  HardeningMetal(const Elasticity& elasticity, double strength, double hardening)
      : elasticity_{elasticity}, strength_{strength}, hardening_{hardening} {}

  double density() const { return elasticity_.density(); }
  double wave_modulus() const { return elasticity_.wave_modulus(); }

  // T: a scalar or a pack of points, so that branches are written as `max` and `select`.
  template <class T, int D>
  T update(Sym<T, D>& stress, const StrainStep<T, D>& step, History<T>& history) const {
    using std::max, std::sqrt;
    const Sym<T, D> trial = turned(stress, step.spin) + elasticity_.stress(step.strain);
    const Sym<T, D> deviatoric = deviator(trial);
    const T equivalent = sqrt(T(1.5) * contract(deviatoric, deviatoric));
    const T excess = max(T(equivalent - T(strength_) - T(hardening_) * history.plastic), T(0));
    const T flow = excess * T(1 / (3 * elasticity_.shear() + hardening_));  // radial return
    stress = trial - deviatoric * T(T(3 * elasticity_.shear()) * flow / max(equivalent, T(1e-30)));
    history.plastic = history.plastic + flow;
    return T(0);  // nothing separates
  }

  template <class T, int D>
  T elastic_energy(const Sym<T, D>& stress) const {
    return elasticity_.energy(stress);
  }

 private:
  Elasticity elasticity_;
  double strength_, hardening_;
};

int main() {
  const double shear = 43e9, strength = 400e6, hardening = 100e6;  // copper, Pa
  const HardeningMetal copper({"HardeningMetal", 8930, 2 * 1.35 * shear, 0.35}, strength, hardening);

  // A law works without a scene. Sheared to gamma, the metal bears the yield stress in shear and G H/(3 G +
  // H) of the strain beyond it, in 10 steps as in 1000.
  const double gamma = 0.1, yield = strength / std::sqrt(3.0);
  const double tangent = shear * hardening / (3 * shear + hardening);
  const double exact = yield + tangent * (gamma - yield / shear);
  for (const int steps : {10, 100, 1000}) {
    Sym<double, 3> stress;
    HardeningMetal::History<double> history;
    StrainStep<double, 3> step;
    step.strain[3] = gamma / 2 / steps;
    for (int k = 0; k < steps; ++k) copper.update(stress, step, history);
    std::printf("sheared in %4d steps: %.6f MPa, exact: %.6f MPa\n", steps, stress[3] / 1e6, exact / 1e6);
    if (!(std::abs(stress[3] / exact - 1) < 1e-12)) return 1;
  }

  const double length = 32.4e-3, radius = 3.2e-3;
  Scene scene{Axisymmetric{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {9.6e-3, 33.6e-3}, .cell = 0.8e-3}},
              Numerics<QuadraticBSpline, Apic>{},
              bodies(fill(Box{{0, 0}, {radius, length}}, copper, {.per_cell = 4, .velocity = {0, -227, 0}})),
              walls(left(roller), bottom(roller))};
  run(scene, {.end = 80e-6, .courant = 0.4});
  double top = 0, plastic = 0;
  const auto& points = scene.body().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    top = std::max(top, points.position[p][1]);
    plastic = std::max(plastic, points.load_history(p).plastic);
  }
  std::printf("the rod of %.1f mm is %.2f mm long, plastic strain up to %.2f\n", length * 1e3, top * 1e3,
              plastic);
}
