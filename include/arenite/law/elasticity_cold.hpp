// Cold functions of elasticity.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <arenite/law/elasticity.hpp>

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
