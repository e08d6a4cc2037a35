#include "correlations.hpp"

#include <cmath>

#include <arenite/core/error.hpp>

#include "../text/words.hpp"

namespace arenite::ffp {

Estimate firmness_factor(double peak, std::optional<double> time, double velocity) {
  Estimate e{"firmness factor", {}, "1/m", "Mulukutla 2011: a_max / (g t_p v_i)", "records that reach rest"};
  if (time && *time > 0)
    e.value = peak / (*time * velocity);
  else
    e.outside = "the record ends before rest";
  return e;
}

Estimate density_of_peak(double peak) {
  Estimate e{"relative density of the peak",
             {},
             "1",
             "Albatal 2020: (-2.18e-4 a^3 + 1.29e-2 a^2 + 1.61 a - 13.09) %",
             "fitted at one site, by drops through water; 0 to 100 %"};
  const double a = peak, percent = ((-2.18e-4 * a + 1.29e-2) * a + 1.61) * a - 13.09;
  constexpr double turns = 73;  // g: beyond it the cubic falls again
  if (a > turns || percent < 0 || percent > 100)
    e.outside = joined_text({"a peak of ", rounded(a), " g gives ", rounded(percent), " %"});
  else
    e.value = percent / 100;
  return e;
}

Estimate density_of_resistance(double q, double vertical_stress, double k0, const std::string& of) {
  Estimate e{
      "relative density of " + of,
      {},
      "1",
      "Jamiolkowski 2003: ln(q / (300 p'^0.46)) / 2.96, kPa",
      "calibration chambers: vertical effective stress of 50 to 400 kPa, K0 of 0.4 to 1.5; 0 to 100 %"};
  const double p = vertical_stress * (1 + 2 * k0) / 3;
  if (!(q > 0) || !(p > 0)) {
    e.outside = "no resistance or no stress";
    return e;
  }
  const double density = std::log(q / (300 * std::pow(p, 0.46))) / 2.96;
  if (density < 0 || density > 1) {
    e.outside = joined_text({"gives ", rounded(density * 100), " %"});
    return e;
  }
  e.value = density;
  if (vertical_stress < 50 || vertical_stress > 400)
    e.outside = joined_text({"a vertical effective stress of ", rounded(vertical_stress), " kPa"});
  else if (k0 < 0.4 || k0 > 1.5)
    e.outside = joined_text({"K0 = ", rounded(k0)});
  return e;
}

Estimate friction_angle(const Estimate& density, double vertical_stress, double c, double d) {
  Estimate e{joined_text({"friction angle (", c, " + ", d, " D), ", density.quantity}),
             {},
             "deg",
             joined_text({"Duncan, after Albatal 2020: 34 + 10 D - (", c, " + ", d,
                          " D) log10(stress / p_atm), by grading"}),
             "triaxial tests; less than 10 kPa is extrapolated (our limit)"};
  constexpr double atmosphere = 101.325;  // kPa
  if (!density.value || !(vertical_stress > 0)) {
    e.outside = "there is no relative density";
    return e;
  }
  e.value = 34 + 10 * *density.value - (c + d * *density.value) * std::log10(vertical_stress / atmosphere);
  if (vertical_stress < 10) e.outside = joined_text({"a stress of ", rounded(vertical_stress), " kPa"});
  if (!density.outside.empty())
    e.outside += (e.outside.empty() ? "" : "; ") + ("the density is outside its own: " + density.outside);
  return e;
}

}  // namespace arenite::ffp
