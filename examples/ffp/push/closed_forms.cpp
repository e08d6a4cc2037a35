#include "closed_forms.hpp"

#include <cmath>

#include <arenite/core/error.hpp>
#include <arenite/core/units.hpp>

namespace arenite::ffp {

double teh_houlsby(double rigidity_index, double face, double shaft, double anisotropy) {
  return 4. / 3 * (1 + std::log(rigidity_index)) * (1.25 + rigidity_index / 2000) + 2.4 * face - 0.2 * shaft -
         1.8 * anisotropy;
}

namespace {

/// Sum over n of the power series of Yu and Houlsby, which gives the radius of the plastic zone. It ends where terms no longer count.
double series(double ratio, double xi, double gamma) {
  double sum = 0, power = 1;  // xi^n / n!
  for (int n = 0; n < 1000; ++n) {
    const double e = n - gamma;
    const double term = power * (std::abs(e) < 1e-9 ? std::log(ratio) : (std::pow(ratio, e) - 1) / e);
    sum += term;
    if (n > std::abs(xi) * ratio && std::abs(term) <= 1e-14 * std::abs(sum)) break;
    power *= xi / (n + 1);
  }
  return sum;
}

}  // namespace

double cavity_limit(const CavitySoil& s, double p0) {
  require(s.friction > 0, "cavity_limit: friction", s.friction, "must be positive");
  const double k = 2;  // sphere
  const double alpha = (1 + std::sin(s.friction)) / (1 - std::sin(s.friction));
  const double beta = (1 + std::sin(s.dilatancy)) / (1 - std::sin(s.dilatancy));
  const double y = 2 * s.cohesion * std::cos(s.friction) / (1 - std::sin(s.friction));
  const double g = s.young / (2 * (1 + s.poisson)), nu = s.poisson;
  const double load = y + (alpha - 1) * p0;
  require(load > 0, "cavity_limit: cohesion and initial pressure", load, "must give the soil strength");
  const double gamma = alpha * (beta + k) / (k * (alpha - 1) * beta);
  const double delta = load / (2 * (k + alpha) * g);
  const double eta = std::exp((beta + k) * (1 - 2 * nu) * load / (s.young * (alpha - 1) * beta));
  const double xi = (1 + k) * delta / ((1 + nu) * (alpha - 1) * beta) *
                    (alpha * beta + k * (1 - 2 * nu) + 2 * nu - k * nu * (alpha + beta));
  const double wanted = eta / gamma * std::pow(1 - delta, (beta + k) / beta);
  double low = 1, high = 2;  // ratio of pressures
  while (series(high, xi, gamma) < wanted && high < 1e9) high *= 2;
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (series(middle, xi, gamma) < wanted ? low : high) = middle;
  }
  return (low * alpha * (1 + k) * load / (k + alpha) - y) / (alpha - 1);
}

std::vector<ClosedForm> closed_forms(const PushOptions& o, double depth) {
  std::vector<ClosedForm> all;
  const bool is_cone = !o.outline() && o.tip == Tip::cone && o.cone_angle.value_or(60) == 60;
  const double vertical = o.vertical_stress(depth);
  if (o.in_clay() && is_cone && o.rigidity_index >= 50 && o.rigidity_index <= 500) {
    const double n = teh_houlsby(o.rigidity_index, o.roughness, o.roughness,
                                 vertical * (1 - o.earth_pressure()) / (2 * o.strength));
    all.push_back({"cone factor", "Teh and Houlsby 1991", n * o.strength, false});
  }
  if (!o.in_clay()) {
    const double mean = vertical * (1 + 2 * o.earth_pressure()) / 3, degree = pi / 180;
    all.push_back(
        {"limit of a spherical cavity, a lower guide", "Yu and Houlsby 1991",
         cavity_limit({o.young, o.poisson_ratio(), o.friction * degree, o.dilatancy * degree, o.cohesion},
                      mean),
         true});
  }
  return all;
}

}  // namespace arenite::ffp
