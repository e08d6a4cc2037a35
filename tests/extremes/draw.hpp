// Contents of a random scene: constants, layout and motion, all drawn from one seed. The same seed gives
// the same scene with every compiler: neither the generator nor the distributions are those of the standard
// library.
#pragma once

#include <algorithm>
#include <arenite/arenite.hpp>
#include <cmath>
#include <cstdint>
#include <string>

namespace arenite::extremes {

/// SplitMix64 (Steele, Lea, Flood 2014, doi:10.1145/2714064.2660195).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_{mixed(seed)} {}  // neighbours would be shifted sequences
  std::uint64_t bits() { return mixed(state_ += 0x9E3779B97F4A7C15u); }
  /// In [low, high).
  double uniform(double low = 0, double high = 1) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  }
  /// In [low, high), even in the logarithm.
  double decades(double low, double high) { return low * std::pow(high / low, uniform()); }
  bool chance(double share) { return uniform() < share; }
  /// In [0, n).
  int pick(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  /// A direction in D dimensions, unit length.
  template <int D>
  Vec<double, D> direction() {
    Vec<double, D> v;
    do {
      for (int k = 0; k < D; ++k) v[k] = uniform(-1, 1);
    } while (!(v.norm() > 0.1 && v.norm() <= 1));
    return v.normalized();
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

/// Where the body lies: in the middle of a mesh without walls, in the middle of a box with walls, or on the
/// floor of such a box from side to side.
enum class Layout { free, boxed, floor };
/// Its initial velocity field.
enum class Motion { uniform, spin, stretch, noise };

/// One random scene. SI units.
struct Draw {
  explicit Draw(std::uint64_t number) : seed{number}, random{number} {
    cell = random.decades(1e-6, 1e3);
    young = random.decades(1e2, 1e11);
    poisson = random.chance(0.2) ? 0.5 - random.decades(1e-4, 0.1) : random.uniform(-0.9, 0.4999);
    density = random.decades(1e2, 1e4);
    friction = random.chance(0.1) ? 0 : random.uniform(0, 80) * pi / 180;
    cohesion = friction == 0 || random.chance(0.5) ? random.decades(1, 1e6) : 0;
    dilatancy = random.chance(0.4) ? 0 : friction * (random.chance(0.2) ? 1 : random.uniform());
    gravity = random.chance(0.3) ? 0 : random.decades(1e-2, 1e4);
    speed = gravity > 0 && random.chance(0.3) ? 0 : random.decades(1e-3, 1e3);
    courant = random.chance(0.2) ? 1 : random.uniform(0.02, 1);
    layout = static_cast<Layout>(random.pick(3));
    motion = static_cast<Motion>(random.pick(4));
    fine = random.chance(0.4);
    round = random.chance(0.5);
    smooth = random.chance(0.5);
    jitter = random.chance(0.3) ? 0 : random.uniform(0, 0.3);
    share = random.chance(0.5) ? 1 : random.uniform();
    k0 = layout == Layout::floor && random.chance(0.3) ? random.uniform(0, 1) : -1;
    contact_friction = random.chance(0.2) ? 0 : random.uniform(0, 80) * pi / 180;
    contrast = random.decades(1e-3, 1e3);
    steps = 100 + random.pick(101);
  }

  std::uint64_t seed;
  Random random;  ///< for what a composition draws beyond
  double cell;    ///< edge of a cell, m
  double young, poisson, density;
  double friction, cohesion, dilatancy;  ///< rad, Pa, rad
  double gravity, speed;                 ///< magnitudes, m/s2, m/s
  double courant;
  Layout layout;
  Motion motion;
  bool fine;                ///< more points a cell
  bool round;               ///< a disc or ball instead of a box
  bool smooth;              ///< walls: roller instead of fixed
  double jitter;            ///< of the nodes of a simplex mesh, in cell edges
  double share;             ///< of FLIP
  double k0;                ///< ratio of initial stresses; -1: no initial stress
  double contact_friction;  ///< rad
  double contrast;          ///< modulus of a second body, or mass of a rigid one, over that of the first
  int steps;
  int per_cell = 0;  ///< points a cell; 0: the few of `fill_options`

  std::string text() const {
    constexpr const char* layouts[] = {"free", "boxed", "floor"};
    constexpr const char* motions[] = {"uniform", "spin", "stretch", "noise"};
    const double degree = pi / 180;
    return joined_text({"C=",
                        courant,
                        " cell=",
                        cell,
                        " E=",
                        young,
                        " nu=",
                        poisson,
                        " rho=",
                        density,
                        " phi=",
                        friction / degree,
                        " c=",
                        cohesion,
                        " psi=",
                        dilatancy / degree,
                        " g=",
                        gravity,
                        " v=",
                        speed,
                        " v/wave=",
                        speed / wave(),
                        " ",
                        layouts[static_cast<int>(layout)],
                        " ",
                        motions[static_cast<int>(motion)],
                        round ? " round" : " box",
                        fine ? " fine" : "",
                        smooth ? " smooth" : "",
                        " jitter=",
                        jitter,
                        " flip=",
                        share,
                        " k0=",
                        k0,
                        " delta=",
                        contact_friction / degree,
                        " contrast=",
                        contrast,
                        " steps=",
                        steps});
  }

  /// Speed of pressure waves, m/s.
  double wave() const {
    return std::sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson) * density));
  }
};

}  // namespace arenite::extremes
