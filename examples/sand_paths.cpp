// One point of sand on a path of strains, without a scene: simple shear at constant pressure, for each policy
// of friction that the library has. Writes the curves to sand_paths.csv and checks where they end. A policy
// is an argument of the law; in a scene it is used the same way: fill(region, sand).
//
//   g++ -std=c++20 -O3 -march=native -Iinclude -I/usr/include/eigen3 examples/sand_paths.cpp -o sand_paths -pthread && ./sand_paths
//   prints: mu(I)                    tau/p 0.6369, exact 0.6369
#include <arenite/arenite.hpp>
#include <arenite/io/output_file.hpp>
#include <cstdio>
#include <ostream>
using namespace arenite;

constexpr double mean_pressure = 20_kPa, angle_given = 39_deg, sheared = 0.5,
                 shearing = 100;  // Pa, rad, -, 1/s
double greatest_error = 0;

/// Shears a point and compares the last shear stress with p sin(phi) of the angle at the end, rad.
template <class Friction>
void shear(std::ostream& file, const char* name, const Friction& friction, double angle_at_end) {
  const MohrCoulombParameters constants{
      .density = 1540, .young = 20_MPa, .poisson = 0.3, .friction = angle_given, .dilatancy = 0};
  const MohrCoulomb<ForgetsOpening, Friction> sand{constants, {}, friction};

  DrivenPoint<MohrCoulomb<ForgetsOpening, Friction>, 2> point{
      .stress = {{-mean_pressure, -mean_pressure, -mean_pressure, 0}}};
  DriveStage<2> stage{.duration = sheared / shearing, .steps = 2000};
  stage.components = {strain_by(0), strain_by(0), strain_by(0), strain_by(sheared / 2)};
  drive(sand, point, stage, [&](const auto& now) {
    file << name << ',' << 2 * now.strain[3] << ',' << now.stress[3] / mean_pressure << '\n';
  });

  const double error = point.stress[3] / (mean_pressure * std::sin(angle_at_end)) - 1;
  std::printf("%-24s tau/p %.4f, exact %.4f\n", name, point.stress[3] / mean_pressure,
              std::sin(angle_at_end));
  greatest_error = std::max(greatest_error, std::abs(error));
}

void shear_all(std::ostream& file) {
  file << "policy,gamma,tau over p\n";
  const double slope = std::tan(angle_given), decades = std::log10(shearing / 2.1e-5);

  shear(file, "constant", ConstantFriction{}, angle_given);
  shear(file, "linear in the rate", LinearRateFriction{{.time = 1e-3}}, std::atan(slope + 1e-3 * shearing));

  const double inertia = shearing * 0.53e-3 / std::sqrt(mean_pressure / 2450);
  shear(file, "mu(I)", InertialFriction{}, std::atan(slope + 0.261 / (0.279 / inertia + 1)));
  shear(file, "logarithm of the rate", LogarithmicFriction{}, angle_given * (1 + 0.027 * decades));

  // Softening: the plastic strain is what the elastic strain leaves of the whole.
  const double residual = 36_deg, eta = 8, shear_modulus = 20_MPa / 2.6;
  const auto softened = [&](double peak) {
    double angle = peak;
    for (int k = 0; k < 100; ++k) {
      const double plastic = (sheared - mean_pressure * std::sin(angle) / shear_modulus) / std::sqrt(3.0);
      angle = residual + (peak - residual) * std::exp(-eta * plastic);
    }
    return angle;
  };
  const SofteningParameters softening{.residual_friction = residual, .decay = eta};
  shear(file, "softening", SofteningFriction{softening}, softened(angle_given));
  shear(file, "softening and rate", RateSofteningFriction{{.softening = softening}},
        softened(angle_given * (1 + 0.027 * decades)));
}

int main() {
  replace_file("sand_paths.csv", [](std::ostream& file) { shear_all(file); });
  return greatest_error < 1e-4 ? 0 : 1;  // of 2000 steps; it falls with their number
}
