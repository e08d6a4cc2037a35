// Absorbing faces over the angle of incidence: the energy that comes back of plane waves, beside that of a
// half-space on dashpots.
#include <arenite/arenite.hpp>
#include <complex>

#include "catch.hpp"
#include "validation.hpp"

using namespace arenite;

namespace {

const LinearElastic rock{{.density = 2000, .young = 1e8, .poisson = 0.25}};
const double speed_p = std::sqrt(rock.wave_modulus() / rock.density()),
             speed_s = std::sqrt(rock.elasticity().shear() / rock.density());
constexpr double h = 1;  // m

using Complex = std::complex<double>;
using Pair = Eigen::Vector2cd;

/// Velocity and tractions on y = const of a plane wave e^{i w (t - direction . x / c)} of velocity `along`.
struct PlaneWave {
  Pair direction, along;
  double c;

  /// Stress (xx, yy, xy) over the velocity, Pa s/m.
  std::array<Complex, 3> stress() const {
    const double shear = rock.elasticity().shear(), lame = rock.wave_modulus() - 2 * shear;
    const Complex volume = direction[0] * along[0] + direction[1] * along[1];
    return {-(lame * volume + 2 * shear * direction[0] * along[0]) / c,
            -(lame * volume + 2 * shear * direction[1] * along[1]) / c,
            -shear * (direction[0] * along[1] + direction[1] * along[0]) / c};
  }
  /// Unbalanced traction: stress minus that of the dashpots (rho c v), along and across the face.
  Pair unbalanced() const {
    const auto s = stress();
    return {s[2] - rock.density() * speed_s * along[0], s[1] - rock.density() * speed_p * along[1]};
  }
};

/// Going down (up: `sign` 1) with the slowness `slow` along the face. Beyond the critical angle a pressure
/// wave dies out away from it.
PlaneWave wave(bool shear, double slow, double sign) {
  const double c = shear ? speed_s : speed_p, sine = c * slow;
  const Complex cosine =
      sine <= 1 ? Complex(std::sqrt(1 - sine * sine)) : Complex(0, -std::sqrt(sine * sine - 1));
  const Pair direction{sine, sign * cosine};
  return {direction, shear ? Pair{sign * cosine, -sine} : direction, c};
}

/// Share of the energy that dashpots of rho c_p and rho c_s at y = 0 send back of a plane wave: the
/// amplitudes of the two reflected waves balance the face (Lysmer and Kuhlemeyer 1969), and energy flows with
/// the velocity across it.
double theory(bool shear, double angle) {
  const double slow = std::sin(angle) / (shear ? speed_s : speed_p);
  const PlaneWave in = wave(shear, slow, -1), p = wave(false, slow, 1), s = wave(true, slow, 1);
  Eigen::Matrix2cd system;
  system << p.unbalanced(), s.unbalanced();
  const Pair amplitude = system.inverse() * -in.unbalanced();
  const auto flow = [](const PlaneWave& w) { return w.c * std::abs(w.direction[1].real()); };
  return (std::norm(amplitude[0]) * flow(p) + std::norm(amplitude[1]) * flow(s)) / flow(in);
}

/// A strip of the half-space, periodic along the face, on which a packet of waves runs down. All have the
/// same wave number along the face; those across it spread by 30 % to both sides.
struct Packet {
  bool shear;
  double length, angle;                          // of the middle wave, m; rad
  double across;                                 // its wave number across the face, 1/m
  std::vector<std::pair<double, double>> waves;  // wave number across, amplitude

  Packet(bool is_shear, double of_length, double of_angle)
      : shear{is_shear}, length{of_length}, angle{of_angle}, across{2 * pi / length * std::cos(angle)} {
    for (int k = -20; k <= 20; ++k) {
      const double share = std::cos(pi / 2 * k / 20.5);
      waves.emplace_back(across * (1 + 0.3 * k / 20.5), share * share);
    }
  }
  double c() const { return shear ? speed_s : speed_p; }
  /// Whole cells; the wave number along the face follows from it.
  double width() const { return angle == 0 ? 4 * h : std::round(length / std::sin(angle) / h) * h; }
  double along() const { return angle == 0 ? 0 : 2 * pi / width(); }
  double height() const { return std::round(9 * 2 * pi / across / h) * h; }
  /// Time at which all of the packet has reached the face.
  double time() const {
    const double slowest = across * 0.75;
    return 7.5 * 2 * pi / across / (c() * slowest / std::hypot(slowest, along()));
  }
  double theory_of_all() const {
    double back = 0, all = 0;
    for (const auto& [k, amplitude] : waves) {
      back += amplitude * amplitude * theory(shear, std::atan2(along(), k));
      all += amplitude * amplitude;
    }
    return back / all;
  }
};

auto strip(const Packet& packet, const AbsorbingOptions& options) {
  Scene scene{
      PlaneStrain{},
      periodic<0>(CartesianGrid<2>{{.lower = {0, 0}, .upper = {packet.width(), packet.height()}, .cell = h}}),
      Numerics<QuadraticBSpline, Flip, Musl>{},
      bodies(fill(Box{{0., 0.}, {packet.width(), packet.height()}}, rock)), absorbing(bottom(), options)};
  auto& points = scene.body().points;
  const double middle = 3.6 * 2 * pi / packet.across;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const auto x = points.position[n];
    Vec<double, 2> velocity = Vec<double, 2>::Zero();
    std::array<double, 3> stress{};
    for (const auto& [k, amplitude] : packet.waves) {
      const double number = std::hypot(k, packet.along());
      const PlaneWave w = wave(packet.shear, packet.along() / number / packet.c(), -1);
      const double v = 1e-6 * amplitude * std::cos(packet.along() * x[0] - k * (x[1] - middle));
      const auto of_wave = w.stress();
      for (int i = 0; i < 2; ++i) velocity[i] += v * w.along[i].real();
      for (std::size_t i = 0; i < 3; ++i) stress[i] += v * of_wave[i].real();
    }
    points.velocity.set(n, velocity);
    auto tensor = points.stress[n];
    tensor[0] = stress[0], tensor[1] = stress[1], tensor[3] = stress[2];
    tensor[2] = 0.25 * (stress[0] + stress[1]);
    points.stress.set(n, tensor);
  }
  return scene;
}
/// Kinetic energy of the nodes, J: half of a running wave's. Points have more: what varies within a cell,
/// which nodes do not see, FLIP leaves where it was.
double energy(const auto& scene) {
  const auto& field = scene.fields[0];
  double sum = 0;
  for (std::size_t i = 0; i < field.size(); ++i) sum += field.mass[i] * field.velocity[i].squaredNorm() / 2;
  return sum;
}

/// Energy after all waves have reached the face over that of the first step.
double share_left(const Packet& packet, const AbsorbingOptions& options = {}) {
  auto scene = strip(packet, options);
  step(scene, 0.5 * stable_step(scene));
  const double sent = energy(scene);
  run(scene, {.end = packet.time(), .courant = 0.5});
  return energy(scene) / sent;
}

/// Holds what comes back at these angles against the theory.
void check(double length, std::initializer_list<double> angles, double bound,
           test::Validation* validation = nullptr) {
  for (const bool shear : {false, true})
    for (const double degrees : angles) {
      const Packet packet(shear, length, degrees * pi / 180);
      const double share = share_left(packet), exact = packet.theory_of_all();
      INFO((shear ? "S, " : "P, ") << degrees << " degrees");
      CHECK(std::abs(share - exact) <= bound);
      if (validation == nullptr) continue;
      const char* name = shear ? "shear waves" : "pressure waves";
      const double shown = exact > 1e-12 ? exact : 0;  // at a right angle, but for round-off
      validation->value(name, joined_text({"energy reflected at ", degrees, " deg"}), "-", share, shown);
      validation->point(name, "angle of incidence (deg)", degrees, "energy reflected", share, shown);
    }
}

}  // namespace

TEST_CASE("Of waves at an angle as much energy comes back as from a half-space on dashpots") {
  const Packet all_back(true, 16 * h, pi / 6);
  CHECK(std::abs(share_left(all_back, {.pressure_wave = 0, .shear_wave = 0}) - 1) <= 0.05);
  check(16 * h, {30}, 0.008);
}

TEST_CASE("The same from 0 to 70 degrees, with longer waves: the table of docs/validation.md", "[.]") {
  test::Validation validation("absorbing_angles", "theory");
  check(24 * h, {0, 10, 20, 30, 40, 50, 60, 70}, 0.015, &validation);
}
