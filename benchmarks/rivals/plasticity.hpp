// The rivals of the library's plastic laws: Mohr-Coulomb and Drucker-Prager for one point, as in a textbook.
#pragma once

#include <algorithm>

#include "tensor.hpp"

namespace arenite::bench::rival {

/// Mohr-Coulomb: principal stresses by the trigonometric formula, return to plane, edge or apex by branches
/// (Clausen, Damkilde, Andersen 2007), and the way back by the tensor's eigenprojections.
template <class T>
struct MohrCoulomb {
  Moduli<T> moduli;
  T density;

  MohrCoulomb(double rho, double young, double poisson, double friction, double cohesion = 0,
              double dilatancy = 0)
      : moduli(young, poisson), density(static_cast<T>(rho)) {
    const double sin = std::sin(friction), sin_flow = std::sin(dilatancy);
    const double k = (1 + sin) / (1 - sin), flow = (1 + sin_flow) / (1 - sin_flow);
    const double sc = 2 * cohesion * std::cos(friction) / (1 - sin);
    slope_ = static_cast<T>(k);
    strength_ = static_cast<T>(sc);
    apex_ = static_cast<T>(cohesion / std::tan(friction));
    // Falls of stress per unit of plastic flow on the plane of s1, s3 and on its two neighbours.
    const auto fall = [&](double a, double b, double c) {
      const double sum = moduli.lame * (a + b + c);
      return std::array<double, 3>{sum + 2 * moduli.shear * a, sum + 2 * moduli.shear * b,
                                   sum + 2 * moduli.shear * c};
    };
    const auto r = fall(flow, 0, -1), r_extension = fall(0, flow, -1), r_compression = fall(flow, -1, 0);
    const double scale = k * r[0] - r[2];
    for (std::size_t i = 0; i < 3; ++i) plane_[i] = static_cast<T>(r[i] / scale);
    edge(r, r_extension, {1, 1, k}, extension_);
    edge(r, r_compression, {1, k, k}, compression_);
  }

  T update(Sym3<T>& s, const Sym3<T>& e, const Vec3<T>& spin) const {
    elastic_step(s, e, spin, moduli);
    return return_to_yield(s);
  }

  /// Returns the volumetric strain that opened, -.
  T return_to_yield(Sym3<T>& s) const {
    using std::sqrt, std::acos, std::cos;
    const T p = (s[0] + s[1] + s[2]) / 3;
    const T a = s[0] - p, b = s[1] - p, c = s[2] - p;
    const T j2 = (a * a + b * b + c * c) / 2 + s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
    T l[3] = {p, p, p};
    if (j2 > 0) {
      const T j3 =
          a * (b * c - s[4] * s[4]) - s[3] * (s[3] * c - s[4] * s[5]) + s[5] * (s[3] * s[4] - b * s[5]);
      const T r = sqrt(j2 / 3);
      const T angle = acos(std::clamp(j3 / (2 * r * r * r), T(-1), T(1))) / 3;
      constexpr T third = static_cast<T>(2.0943951023931954923);  // 2 pi / 3
      l[0] = p + 2 * r * cos(angle);
      l[1] = p + 2 * r * cos(angle - third);
      l[2] = p + 2 * r * cos(angle + third);
    }
    const T f = slope_ * l[0] - l[2] - strength_;
    if (f <= 0) return 0;

    T y[3] = {l[0] - f * plane_[0], l[1] - f * plane_[1], l[2] - f * plane_[2]};
    T opened = 0;
    const bool extends = y[0] < y[1];
    if (extends || y[1] < y[2]) {
      const T* n = extends ? extension_ : compression_;
      const T t = n[0] * l[0] + n[1] * l[1] + n[2] * l[2] + n[3];
      if (t > apex_) {
        y[0] = y[1] = y[2] = apex_;
        opened = (3 * p - 3 * apex_) / (3 * moduli.bulk);
      } else {
        const T low = slope_ * t - strength_;
        y[0] = t;
        y[1] = extends ? t : low;
        y[2] = low;
      }
    }
    rebuild(s, l, y);
    return opened;
  }

 private:
  /// Where a trial point returns to the edge base + t l: t = n . s + n[3], with n normal to both flows.
  void edge(const std::array<double, 3>& r1, const std::array<double, 3>& r2, const std::array<double, 3>& l,
            T (&n)[4]) const {
    const std::array<double, 3> cross{r1[1] * r2[2] - r1[2] * r2[1], r1[2] * r2[0] - r1[0] * r2[2],
                                      r1[0] * r2[1] - r1[1] * r2[0]};
    const double along = cross[0] * l[0] + cross[1] * l[1] + cross[2] * l[2];
    const double sc = strength_;
    const bool two_low = l[1] > 1;
    const double base = (two_low ? -sc * cross[1] : 0) - sc * cross[2];
    for (std::size_t i = 0; i < 3; ++i) n[i] = static_cast<T>(cross[i] / along);
    n[3] = static_cast<T>(-base / along);
  }

  /// s = sum y_i E_i with the eigenprojections E_i of s; equal eigenvalues share one.
  static void rebuild(Sym3<T>& s, const T (&l)[3], const T (&y)[3]) {
    const T close = static_cast<T>(sizeof(T) == 8 ? 1e-7 : 1e-3) * (std::abs(l[0]) + std::abs(l[2]));
    const bool same12 = l[0] - l[1] <= close, same23 = l[1] - l[2] <= close;
    if (same12 && same23) {
      s = {y[1], y[1], y[1], 0, 0, 0};
      return;
    }
    if (same12 || same23) {
      const std::size_t lone = same12 ? 2 : 0;
      const T slope = (y[lone] - y[1]) / (l[lone] - l[1]);
      for (std::size_t i = 0; i < 6; ++i) s[i] = (s[i] - (i < 3 ? l[1] : 0)) * slope + (i < 3 ? y[1] : 0);
      return;
    }
    const Sym3<T> square{s[0] * s[0] + s[3] * s[3] + s[5] * s[5], s[3] * s[3] + s[1] * s[1] + s[4] * s[4],
                         s[5] * s[5] + s[4] * s[4] + s[2] * s[2], s[0] * s[3] + s[3] * s[1] + s[5] * s[4],
                         s[3] * s[5] + s[1] * s[4] + s[4] * s[2], s[0] * s[5] + s[3] * s[4] + s[5] * s[2]};
    Sym3<T> back{};
    for (std::size_t k = 0; k < 3; ++k) {
      const T m = l[(k + 1) % 3], n = l[(k + 2) % 3];
      const T weight = y[k] / ((l[k] - m) * (l[k] - n));
      for (std::size_t i = 0; i < 6; ++i)
        back[i] += weight * (square[i] - (m + n) * s[i] + (i < 3 ? m * n : 0));
    }
    s = back;
  }

  T slope_, strength_, apex_;
  T plane_[3], extension_[4], compression_[4];
};

/// Drucker-Prager, the cone at the compression edges, dilatancy 0.
template <class T>
struct DruckerPrager {
  Moduli<T> moduli;
  T density;

  DruckerPrager(double rho, double young, double poisson, double friction)
      : moduli(young, poisson),
        density(static_cast<T>(rho)),
        slope_(static_cast<T>(6 * std::sin(friction) / (std::sqrt(3.0) * (3 - std::sin(friction))))) {}

  T update(Sym3<T>& s, const Sym3<T>& e, const Vec3<T>& spin) const {
    elastic_step(s, e, spin, moduli);
    const T p = (s[0] + s[1] + s[2]) / 3;
    if (p >= 0) {
      s = {};
      return p / moduli.bulk;
    }
    const T a = s[0] - p, b = s[1] - p, c = s[2] - p;
    const T q = std::sqrt((a * a + b * b + c * c) / 2 + s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
    const T limit = -slope_ * p;
    if (q <= limit) return 0;
    const T scale = limit / q;
    s = {p + scale * a, p + scale * b, p + scale * c, scale * s[3], scale * s[4], scale * s[5]};
    return 0;
  }

 private:
  T slope_;
};

}  // namespace arenite::bench::rival
