// Grid convergence: from results at three or more cell sizes, the result extrapolated to size zero, and how
// far from it the finest one may be. Of any scalar of any scene.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A result at a size of the cells.
struct SizedResult {
  double size = 0;   ///< h, of any unit
  double value = 0;  ///< phi(h), of any unit
};

/// When results count as converging, and how wide the uncertainty is.
struct ConvergenceRule {
  double least_order = 0.5;  ///< p below is no convergence that one could extrapolate
  double largest_order = 2;  ///< p above is a chance: the differences vanish faster than the method's error
  double safety = 1.25;      ///< over the extrapolated error, with three sizes (Celik et al. 2008)
  double spread_factor = 3;  ///< over max - min where the results do not converge
  double round_off = 1e-12;  ///< differences up to this share of the largest |value| are none
};

/// How results go with the size of the cells.
enum class Trend {
  constant,    ///< all the same but for round-off
  monotone,    ///< each refinement moves them the same way
  oscillating  ///< refinements move them both ways, or one does not move them
};

/// Result of `convergence`. `uncertainty` is that of the value at the finest size.
struct Convergence {
  std::vector<SizedResult> results;  ///< finest first
  Trend trend = Trend::constant;
  std::optional<double> order;  ///< p, of the three finest; nothing unless monotone; negative: diverging
  std::optional<double> extrapolated;  ///< phi at h -> 0; nothing unless constant, or monotone with p > 0
  bool converged = false;              ///< constant, or monotone with the order within the rule's limits
  double uncertainty = 0;              ///< half width of the error bar, in the value's unit

  /// At the finest size.
  double value() const { return results.front().value; }
  bool monotone() const { return trend == Trend::monotone; }
};

namespace detail {

/// log((exp(x) - 1) / x), without loss near 0 and without overflow.
inline double log_growth(double x) {
  const double a = std::abs(x);
  return std::max(x, 0.0) + (a > 0 ? std::log(-std::expm1(-a) / a) : 0.0);
}

/// The p with (h_3^p - h_2^p) / (h_2^p - h_1^p) = `ratio`, where `r21` = h_2 / h_1 and `r32` = h_3 / h_2. The
/// left side grows with p from 0 to infinity: there is one for each positive ratio.
inline double order_of_ratio(double ratio, double r21, double r32) {
  const double a = std::log(r21), b = std::log(r32);
  const auto excess = [&](double p) {
    return p * a + log_growth(p * b) - log_growth(p * a) + std::log(b / a) - std::log(ratio);
  };
  double low = -1, high = 1;
  while (excess(low) > 0) low *= 2;
  while (excess(high) < 0) high *= 2;
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return middle;
    (excess(middle) < 0 ? low : high) = middle;
  }
}

}  // namespace detail

/// Order, limit and uncertainty of results at three or more different sizes, in any order and with any
/// ratios.
///
/// With h_1 < h_2 < h_3 the three finest, phi = phi_0 + C h^p through them gives
///
///   (phi_3 - phi_2) / (phi_2 - phi_1) = (h_3^p - h_2^p) / (h_2^p - h_1^p)        solved for p
///   phi_0 = phi_1 - (phi_2 - phi_1) / (r^p - 1),   r = h_2 / h_1                  (Richardson)
///   U     = 1.25 |phi_2 - phi_1| / (r^p - 1)                                      0.5 <= p <= 2
///   U     = 3 (max - min) of all results, not converged                           otherwise
///
/// With equal ratios p = ln((phi_3 - phi_2) / (phi_2 - phi_1)) / ln r. U / |phi_1| is the grid convergence
/// index of the finest size. Results at more sizes than three show whether all is monotone, and widen the
/// spread. Differences within round-off count as none; the limit of constant results is their value, U = max
/// - min.
///
/// Procedure: Celik, Ghia, Roache, Freitas, Coleman and Raad, J. Fluids Eng. 130 (2008) 078001, that of ASME
/// V&V 20. Unlike there a p of results that diverge is negative here, and none is given of results that
/// oscillate. The limits of p and the factor on the spread are those of Eca and Hoekstra, J. Comput. Phys.
/// 262 (2014) 104, in a simpler form.
///
/// Throws `error` with fewer than three results, sizes that are not positive, finite and distinct, or values
/// that are not finite.
inline Convergence convergence(std::vector<SizedResult> results, const ConvergenceRule& rule = {}) {
  require(rule.least_order > 0 && rule.largest_order >= rule.least_order, "ConvergenceRule.least_order",
          rule.least_order, "must be positive and no more than the largest order");
  require(rule.safety >= 1, "ConvergenceRule.safety", rule.safety, "must be at least 1");
  require(rule.spread_factor >= 1, "ConvergenceRule.spread_factor", rule.spread_factor, "must be at least 1");
  require(rule.round_off >= 0 && rule.round_off < 1, "ConvergenceRule.round_off", rule.round_off,
          "must lie in [0, 1)");
  require(results.size() >= 3, "convergence.results", results.size(), "needs three sizes at least");
  for (const SizedResult& r : results) {
    require(r.size > 0 && std::isfinite(r.size), "convergence.size", r.size, "must be positive and finite");
    require(std::abs(r.value) < 1e300, "convergence.value", r.value, "must be finite");
  }
  std::sort(results.begin(), results.end(),
            [](const SizedResult& a, const SizedResult& b) { return a.size < b.size; });
  double low = results[0].value, high = low, largest = std::abs(low);
  for (std::size_t i = 1; i < results.size(); ++i) {
    require(results[i].size > results[i - 1].size, "convergence.size", results[i].size,
            "must not be given twice");
    low = std::min(low, results[i].value);
    high = std::max(high, results[i].value);
    largest = std::max(largest, std::abs(results[i].value));
  }

  Convergence found;
  found.results = std::move(results);
  const auto& r = found.results;
  const double noise = rule.round_off * largest;
  if (high - low <= noise) {
    found.extrapolated = found.value();
    found.converged = true;
    found.uncertainty = high - low;
    return found;
  }

  bool up = true, down = true;
  for (std::size_t i = 1; i < r.size(); ++i) {
    up = up && r[i].value - r[i - 1].value > noise;
    down = down && r[i - 1].value - r[i].value > noise;
  }
  found.trend = up || down ? Trend::monotone : Trend::oscillating;
  found.uncertainty = rule.spread_factor * (high - low);
  if (!found.monotone()) return found;

  const double d21 = r[1].value - r[0].value, d32 = r[2].value - r[1].value, ratio = r[1].size / r[0].size;
  const double p = detail::order_of_ratio(d32 / d21, ratio, r[2].size / r[1].size);
  found.order = p;
  if (p > 0) found.extrapolated = r[0].value - d21 / std::expm1(p * std::log(ratio));
  found.converged = p >= rule.least_order && p <= rule.largest_order;
  if (found.converged) found.uncertainty = rule.safety * std::abs(*found.extrapolated - r[0].value);
  return found;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
