// Shared by the rivals: plain arrays as tensors, Hooke's law with the Jaumann rate, and a linear elastic
// law. The rivals are what a good engineer writes first: structs of points, scalar loops, branches; no packs,
// no sorting, and nothing of the library but its meshes and the places of its points.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace arenite::bench::rival {

template <class T>
using Vec3 = std::array<T, 3>;

/// Symmetric tensor: xx, yy, zz, xy, yz, zx (of the tensor, not engineering strains).
template <class T>
using Sym3 = std::array<T, 6>;

/// Elastic moduli, Pa.
template <class T>
struct Moduli {
  T lame, shear, bulk, wave;
  Moduli(double young, double poisson) {
    const double g = young / (2 * (1 + poisson)), k = young / (3 * (1 - 2 * poisson));
    lame = static_cast<T>(k - 2 * g / 3);
    shear = static_cast<T>(g);
    bulk = static_cast<T>(k);
    wave = static_cast<T>(k + 4 * g / 3);
  }
};

/// Trial stress of a step with strain e and spin (W_xy, W_yz, W_zx): s + W s - s W + lambda tr(e) I + 2 G e.
template <class T>
void elastic_step(Sym3<T>& s, const Sym3<T>& e, const Vec3<T>& spin, const Moduli<T>& m) {
  const T a = spin[0], b = spin[1], c = spin[2];
  const T volumetric = m.lame * (e[0] + e[1] + e[2]);
  const T xx = 2 * (a * s[3] - c * s[5]);
  const T yy = 2 * (b * s[4] - a * s[3]);
  const T zz = 2 * (c * s[5] - b * s[4]);
  const T xy = a * (s[1] - s[0]) - c * s[4] + b * s[5];
  const T yz = b * (s[2] - s[1]) - a * s[5] + c * s[3];
  const T zx = c * (s[0] - s[2]) - b * s[3] + a * s[4];
  const Sym3<T> turn{xx + volumetric, yy + volumetric, zz + volumetric, xy, yz, zx};
  for (std::size_t i = 0; i < 6; ++i) s[i] += turn[i] + 2 * m.shear * e[i];
}

/// Strain and spin of one step from the velocity gradient l [3][3], 1/s.
template <class T>
void increment(const T (&l)[3][3], T dt, Sym3<T>& e, Vec3<T>& spin) {
  const T half = dt / 2;
  e = {dt * l[0][0],
       dt * l[1][1],
       dt * l[2][2],
       half * (l[0][1] + l[1][0]),
       half * (l[1][2] + l[2][1]),
       half * (l[2][0] + l[0][2])};
  spin = {half * (l[0][1] - l[1][0]), half * (l[1][2] - l[2][1]), half * (l[2][0] - l[0][2])};
}

/// Linear elasticity. Each law of a rival has `moduli`, `density` and `update(s, e, spin)`, which returns
/// what opened without stress.
template <class T>
struct LinearElastic {
  Moduli<T> moduli;
  T density;
  LinearElastic(double rho, double young, double poisson)
      : moduli(young, poisson), density(static_cast<T>(rho)) {}
  T update(Sym3<T>& s, const Sym3<T>& e, const Vec3<T>& spin) const {
    elastic_step(s, e, spin, moduli);
    return 0;
  }
};

}  // namespace arenite::bench::rival
