// Trial states for the laws: random, and on purpose on edges, at the apex and with equal principal values.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <arenite/law/elasticity.hpp>
#include <arenite/simd/lanes.hpp>
#include <cmath>
#include <random>

namespace arenite::test {

/// Lane k of a pack, or a scalar.
template <class P>
auto lane(const P& value, int k) {
  if constexpr (is_pack<P>)
    return value[k];
  else
    return value;
}
template <class P>
void set(P& to, int k, double value) {
  if constexpr (is_pack<P>)
    to.set(k, static_cast<typename P::scalar>(value));
  else
    to = static_cast<P>(value);
}

template <int D>
Eigen::Matrix3d full(const Sym<double, D>& s) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = s(i, j);
  return m;
}

template <int D>
Sym<double, D> symmetric(const Eigen::Matrix3d& m) {
  if constexpr (D == 2)
    return {{m(0, 0), m(1, 1), m(2, 2), m(0, 1)}};
  else
    return {{m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)}};
}

/// Principal values, largest first, by Eigen's solver.
template <int D>
Eigen::Vector3d principal_values(const Sym<double, D>& s) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(full(s)).eigenvalues().reverse();
}

template <int D>
Eigen::Matrix3d rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  if constexpr (D == 2) {
    return Eigen::AngleAxisd(normal(random), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  } else {
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
        .normalized()
        .toRotationMatrix();
  }
}

/// A trial stress, Pa, of a size of 10 kPa: any; with two or three values equal or nearly so; in tension;
/// near the apex.
template <int D>
Sym<double, D> trial_state(std::mt19937& random, double apex) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double size = 1e4 * std::pow(10, uniform(random));
  Eigen::Vector3d v(uniform(random), uniform(random), uniform(random));
  switch (random() % 6) {
    case 0:
      v(1) = v(0);
      break;
    case 1:
      v(1) = v(0) * (1 + std::pow(10, -8 + 7 * uniform(random)));
      break;
    case 2:
      v.setConstant(v(0));
      break;
    case 3:
      v.array() += std::abs(uniform(random)) * 2;
      break;
    default:
      v.array() -= 1 + uniform(random);
      break;
  }
  v *= size;
  if (random() % 8 == 0 && std::isfinite(apex))
    v = v * std::pow(10, 3 * uniform(random) - 3) + Eigen::Vector3d::Constant(apex);
  std::shuffle(v.data(), v.data() + 3, random);
  const Eigen::Matrix3d r = rotation<D>(random);
  return symmetric<D>(r * v.asDiagonal() * r.transpose());
}

/// Strain of a stress by Hooke's law.
inline Eigen::Matrix3d strain_of(const Elasticity& e, const Eigen::Matrix3d& stress) {
  const double p = stress.trace() / 3;
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  return (stress - p * identity) / (2 * e.shear()) + p / (3 * e.bulk()) * identity;
}

/// The x in [low, high] at which the rising function f changes sign.
template <class F>
double bisect(double low, double high, F&& f) {
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2;
    (f(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Triaxial compression under constant lateral stress from an isotropic state: axis y is shortened.
struct Triaxial {
  double axial_stress, lateral_stress;            // Pa, at the end
  double axial_strain_rate, lateral_strain_rate;  // strains of the last step
};
template <class Law>
Triaxial triaxial_compression(const Law& law, double lateral, double step, int steps) {
  Sym<double, 3> stress{{lateral, lateral, lateral, 0, 0, 0}};
  typename Law::template History<double> history{};
  Triaxial end{};
  const auto after = [&](double side, auto& s, auto& h) {
    StrainStep<double, 3> strain_step;
    strain_step.strain = {{side, -step, side, 0, 0, 0}};
    law.update(s, strain_step, h);
  };
  for (int i = 0; i < steps; ++i) {
    const double side = bisect(-3 * step, 6 * step, [&](double x) {
      auto s = stress;
      auto h = history;
      after(x, s, h);
      return s[0] - lateral;
    });
    after(side, stress, history);
    end = {stress[1], stress[0], -step, side};
  }
  return end;
}

/// Simple shear in plane strain under constant vertical stress, without spin, until it flows.
struct SimpleShear {
  double shear_stress, vertical_stress;  // Pa
  double dilation_rate;                  // vertical strain per shear strain gamma, in the last step
};
template <class Law>
SimpleShear simple_shear(const Law& law, double vertical, double step, int steps) {
  Sym<double, 2> stress{{vertical / 2, vertical, vertical / 2, 0}};
  typename Law::template History<double> history{};
  SimpleShear end{};
  const auto after = [&](double up, auto& s, auto& h) {
    StrainStep<double, 2> strain_step;
    strain_step.strain = {{0, up, 0, step / 2}};
    law.update(s, strain_step, h);
  };
  for (int i = 0; i < steps; ++i) {
    const double up = bisect(-4 * step, 4 * step, [&](double x) {
      auto s = stress;
      auto h = history;
      after(x, s, h);
      return s[1] - vertical;
    });
    after(up, stress, history);
    end = {stress[3], stress[1], up / step};
  }
  return end;
}

}  // namespace arenite::test
