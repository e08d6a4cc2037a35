// Friction of your own: an angle by point for Mohr-Coulomb or Drucker-Prager, as a policy of the law
// (arenite/law/frictional/friction.hpp). Here sand that softens as it is sheared. Sheared at a constant mean stress p,
// it carries p sin(phi), with tan(phi) falling from the peak to the residual value.
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/extend/own_friction.cpp -o own_friction -pthread && ./own_friction
//   prints: sheared by 0.200: 5064.7 Pa, exact 5064.7 Pa
#include <arenite/arenite.hpp>
#include <cstdio>
using namespace arenite;

/// tan(phi) falls linearly with the shear strain, from that of the law's parameters to a part of it.
struct Softening {
  double strain;    // over which it falls, -
  double residual;  // what is left of it then, -

  // Stored for each point, beside the history of the law; its name for files and `FillOptions::history`.
  template <class T>
  struct History {
    T sheared{0};  // shear strain that the point has seen, -
    static constexpr std::array names{"sheared"};
    auto members() { return std::tie(sheared); }
    auto members() const { return std::tie(sheared); }
  };

  // T: a scalar, or a pack of points.
  template <class T, int D>
  T slope(double peak, const StrainStep<T, D>& step, History<T>& history) const {
    using std::max, std::sqrt;
    const auto e = deviator(step.strain);
    history.sheared = history.sheared + sqrt(T(2) * contract(e, e));
    return T(peak) * max(T(T(1) - history.sheared * T((1 - residual) / strain)), T(residual));
  }
};

int main() {
  const double p = 10_kPa, phi = 40_deg;
  const Softening softening{.strain = 0.1, .residual = 0.7};
  const MohrCoulomb sand{
      {.density = 1540, .young = 20_MPa, .poisson = 0.3, .friction = phi}, ForgetsOpening{}, softening};
  Sym<double, 2> stress{{-p, -p, -p, 0}};
  decltype(sand)::History<double> history;
  StrainStep<double, 2> step;
  step.strain[3] = 0.5e-3;  // half the shear strain of a step
  double worst = 0;
  for (int k = 1; k <= 200; ++k) {
    sand.update(stress, step, history);
    const double slope = std::tan(phi) * std::max(1 - 0.3 * 1e-3 * k / 0.1, 0.7);
    const double exact = p * std::sin(std::atan(slope));
    if (k > 10) worst = std::max(worst, std::abs(stress[3] / exact - 1));  // elastic before
    if (k % 50 == 0) std::printf("sheared by %.3f: %.1f Pa, exact %.1f Pa\n", 1e-3 * k, stress[3], exact);
  }
  return worst < 1e-12 ? 0 : 1;
}
