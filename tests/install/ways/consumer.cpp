// The smallest program of a user, built in each way that the README names: one header, and a number of which
// the closed form is known.
#include <cmath>
#include <cstdio>

#include <arenite/law/mohr_coulomb.hpp>
#include <arenite/version.hpp>

#if ARENITE_VERSION < 100
#error "ARENITE_VERSION must be a number that #if compares"
#endif

int main() {
  const arenite::MohrCoulomb sand{{.density = 1540, .young = 1e6, .poisson = 0.25, .friction = 0.6}};
  // version.hpp: the text and the three numbers are the same version.
  std::printf("%.*s %d.%d.%d %g\n", static_cast<int>(arenite::library_version.size()),
              arenite::library_version.data(), ARENITE_VERSION_MAJOR, ARENITE_VERSION_MINOR,
              ARENITE_VERSION_PATCH, sand.wave_modulus());
  return std::abs(sand.wave_modulus() - 1.2e6) < 1e-3 ? 0 : 1;  // E (1 - nu) / ((1 + nu)(1 - 2 nu)), Pa
}
