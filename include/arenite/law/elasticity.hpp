// Isotropic linear elasticity, the part that the laws share: checked constants, moduli, Hooke's law and its
// energy.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <string_view>

#include <arenite/core/cold.hpp>
#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// A constant that the user must give: NaN until given.
inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// Throws `error("Law.name = value: rule")` if the rule is violated, or says that the constant was forgotten.
[[noreturn]] void refuse_constant(std::string_view law, std::string_view name, double value,
                                  std::string_view rule);
inline void check(bool holds, std::string_view law, std::string_view name, double value,
                  std::string_view rule) {
  if (!holds) [[unlikely]]
    refuse_constant(law, name, value, rule);
}

}  // namespace detail

/// Density and elastic moduli of an isotropic solid.
class Elasticity {
 public:
  /// density [kg/m3], young [Pa], poisson [-]; `law` is the name that an error message shows. Throws `error`.
  Elasticity(std::string_view law, double density, double young, double poisson);

  double density() const { return density_; }
  double poisson() const { return poisson_; }
  double shear() const { return shear_; }  ///< G, Pa
  double bulk() const { return bulk_; }    ///< K, Pa
  double lame() const { return lame_; }    ///< lambda = K - 2 G / 3, Pa
  /// K + 4 G / 3, Pa: density times the square of the speed of pressure waves.
  double wave_modulus() const { return bulk_ + shear_ * 4 / 3; }

  /// Stress of a strain by Hooke's law, Pa.
  template <class T, int D>
  Sym<T, D> stress(const Sym<T, D>& strain) const {
    return add_isotropic(strain * T(2 * shear_), T(T(lame_) * trace(strain)));
  }

  /// J2 / (2 G) + p^2 / (2 K), J/m3.
  template <class T, int D>
  T energy(const Sym<T, D>& stress) const {
    const Sym<T, D> dev = deviator(stress);
    const T p = trace(stress) * T(1.0 / 3);
    return contract(dev, dev) * T(0.25 / shear_) + p * p * T(0.5 / bulk_);
  }

 private:
  double density_, poisson_, shear_, bulk_, lame_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void detail::refuse_constant(std::string_view law, std::string_view name, double value,
                                          std::string_view rule) {
  refuse({law, ".", name}, value, {std::isnan(value) ? std::string_view("must be given") : rule});
}

ARENITE_COLD Elasticity::Elasticity(std::string_view law, double density, double young, double poisson)
    : density_(density) {
  detail::check(density > 0 && std::isfinite(density), law, "density", density, "must be positive (kg/m3)");
  detail::check(young > 0 && std::isfinite(young), law, "young", young, "must be positive (Pa)");
  detail::check(poisson > -1 && poisson < 0.5, law, "poisson", poisson, "must lie in (-1, 0.5)");
  poisson_ = poisson;
  shear_ = young / (2 * (1 + poisson));
  bulk_ = young / (3 * (1 - 2 * poisson));
  lame_ = bulk_ - shear_ * 2 / 3;
  detail::check(std::isfinite(wave_modulus()), law, "young", young, "must give finite moduli (Pa)");
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
