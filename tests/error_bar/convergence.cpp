// Grid convergence of results with a known law: power laws, and the published sample of the procedure.
#include <arenite/error_bar/convergence.hpp>

#include <cmath>
#include <limits>
#include <vector>

#include "catch.hpp"
#include "message.hpp"

using namespace arenite;

namespace {

/// phi = limit + factor h^p at these sizes.
std::vector<SizedResult> power_law(double limit, double factor, double p, const std::vector<double>& sizes) {
  std::vector<SizedResult> results;
  for (const double h : sizes) results.push_back({h, limit + factor * std::pow(h, p)});
  return results;
}

/// The first three columns of a row of Table 1 of Celik et al. 2008: sizes from cells on an area, finest
/// first.
Convergence published(const std::vector<double>& cells, const std::vector<double>& values) {
  std::vector<SizedResult> results;
  for (std::size_t i = 0; i < cells.size(); ++i) results.push_back({1 / std::sqrt(cells[i]), values[i]});
  return convergence(results);
}

}  // namespace

TEST_CASE("Convergence: order and limit of power laws, whatever the ratios of the sizes") {
  for (const std::vector<double>& sizes :
       {std::vector<double>{1, std::sqrt(2), 2}, {2, 1, 1.41}, {0.3, 0.9, 0.5}, {1e-6, 1.1e-6, 1.7e-6}})
    for (const double p : {0.5, 0.7, 1.0, 1.5, 2.0}) {
      // Some hundredths of the limit, as far as a result may be away, and in both directions.
      const double reach = *std::max_element(sizes.begin(), sizes.end());
      for (const double share : {0.5, -2.0}) {
        const double factor = share / std::pow(reach, p);
        const Convergence c = convergence(power_law(0.2, factor, p, sizes), {.largest_order = 2 + 1e-9});
        CAPTURE(sizes, p, share);
        CHECK(c.trend == Trend::monotone);
        CHECK(c.order.has_value());
        CHECK(std::abs(*c.order - p) < 1e-10);
        CHECK(std::abs(*c.extrapolated - 0.2) < 1e-10);
        CHECK(c.results[0].size < c.results[1].size);
        const double error = std::abs(c.value() - 0.2);
        if (p > 0.5) CHECK(c.converged);
        if (c.converged) CHECK(std::abs(c.uncertainty - 1.25 * error) < 1e-9);
      }
    }
}

TEST_CASE("Convergence: an order outside the limits is no convergence") {
  const std::vector<double> sizes{1, 1.5, 2};
  for (const double p : {0.3, 2.5, 6.0}) {
    const Convergence c = convergence(power_law(1, 0.1, p, sizes));
    CAPTURE(p);
    CHECK(std::abs(*c.order - p) < 1e-10);
    CHECK(std::abs(*c.extrapolated - 1) < 1e-10);
    CHECK(!c.converged);
    CHECK(std::abs(c.uncertainty - 0.3 * (std::pow(2, p) - 1)) < 1e-12);
  }
  // The limit may be relaxed for a second-order method.
  CHECK(convergence(power_law(1, 0.1, 2.05, sizes), {.largest_order = 2.1}).converged);
}

TEST_CASE("Convergence: results that diverge have a negative order and no limit") {
  for (const double p : {-0.5, -1.0, -3.0}) {
    const Convergence c = convergence(power_law(1, 0.1, p, {1, 1.4, 2}));
    CHECK(std::abs(*c.order - p) < 1e-10);
    CHECK(c.monotone());
    CHECK(!c.converged);
    CHECK(!c.extrapolated.has_value());
  }
  // Equal steps in ln h: p = 0.
  CHECK(std::abs(*convergence({{1, 1}, {2, 2}, {4, 3}}).order) < 1e-12);
}

TEST_CASE("Convergence: the numbers by which examples/ffp/scripts/resolution.py is tested") {
  const Convergence c = convergence({{2, 0.173}, {1, 0.184}, {0.5, 0.191}});
  CHECK(c.converged);
  CHECK(std::abs(*c.order - std::log2(11.0 / 7)) < 1e-9);
  CHECK(std::abs(*c.extrapolated - 0.20325) < 1e-9);
  CHECK(std::abs(c.uncertainty - 0.0153125) < 1e-9);
  const Convergence fast = convergence({{2, 0.173}, {1, 0.181}, {0.5, 0.182}});
  CHECK(!fast.converged);
  CHECK(std::abs(*fast.order - 3) < 1e-9);
  CHECK(std::abs(fast.uncertainty - 0.027) < 1e-9);
  const Convergence slow = convergence({{2, 1}, {1, 2}, {0.5, 3}});
  CHECK(!slow.converged);
  CHECK(std::abs(*slow.order) < 1e-9);
  CHECK(std::abs(slow.uncertainty - 6) < 1e-9);
  for (const double last : {22.3, 21.9}) {
    const Convergence both_ways = convergence({{2, 23.5}, {1, 21.9}, {0.5, last}});
    CHECK(!both_ways.converged);
    CHECK(!both_ways.order);
    CHECK(std::abs(both_ways.uncertainty - 4.8) < 1e-9);
  }
}

TEST_CASE("Convergence: results that go both ways, or stay once, have no order") {
  for (const double middle : {0.9, 1.3, 1.0, 1.2}) {
    const Convergence c = convergence({{4, 1.2}, {2, middle}, {1, 1.0}});
    CAPTURE(middle);
    CHECK(c.trend == Trend::oscillating);
    CHECK(!c.order.has_value());
    CHECK(!c.extrapolated.has_value());
    CHECK(!c.converged);
    CHECK(std::abs(c.uncertainty - 3 * (std::max(1.2, middle) - std::min(1.0, middle))) < 1e-12);
  }
}

TEST_CASE("Convergence: equal results are their own limit") {
  const Convergence c = convergence({{1, 0.2}, {2, 0.2}, {4, 0.2}});
  CHECK(c.trend == Trend::constant);
  CHECK(c.converged);
  CHECK(!c.order.has_value());
  CHECK(c.extrapolated == 0.2);
  CHECK(c.uncertainty == 0);
  const Convergence rounded = convergence({{1, 0.2}, {2, 0.2 * (1 + 1e-15)}, {4, 0.2 * (1 - 1e-15)}});
  CHECK(rounded.trend == Trend::constant);
  CHECK(rounded.uncertainty < 1e-15);
  CHECK(convergence({{1, 0}, {2, 0}, {4, 0}}).converged);
}

TEST_CASE("Convergence: more than three sizes must all go one way") {
  auto results = power_law(1, 0.1, 1, {1, 2, 4, 8});
  CHECK(std::abs(*convergence(results).order - 1) < 1e-10);
  CHECK(convergence(results).converged);
  results.push_back({16, 0.5});
  const Convergence c = convergence(results);
  CHECK(c.trend == Trend::oscillating);
  CHECK(std::abs(c.uncertainty - 3 * (1.8 - 0.5)) < 1e-12);
}

// Celik et al. 2008, Table 1: cells of a two-dimensional domain and a result; p, extrapolated result and grid
// convergence index of the finest as printed there.
TEST_CASE("Convergence: the published sample") {
  const Convergence length = published({18000, 8000, 4500}, {6.063, 5.972, 5.863});
  CHECK(std::abs(*length.order - 1.53) < 0.005);
  CHECK(std::abs(*length.extrapolated - 6.1685) < 5e-4);
  CHECK(length.converged);
  CHECK(std::abs(length.uncertainty / length.value() - 0.022) < 5e-4);

  const Convergence speed = published({18000, 4500, 980}, {10.7880, 10.7250, 10.6050});
  CHECK(std::abs(*speed.order - 0.75) < 0.005);
  CHECK(speed.converged);

  // There 1.51, by a formula for results that oscillate; here no order.
  const Convergence other = published({18000, 4500, 980}, {6.0042, 5.9624, 6.0909});
  CHECK(other.trend == Trend::oscillating);
  CHECK(std::abs(other.uncertainty - 3 * (6.0909 - 5.9624)) < 1e-12);
}

TEST_CASE("Convergence: input that cannot be used") {
  const auto said = [](const std::vector<SizedResult>& results, const ConvergenceRule& rule = {}) {
    return test::message([&] { convergence(results, rule); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK(said({{1, 1}, {2, 1}}) == "convergence.results = 2: needs three sizes at least");
  CHECK(said({{1, 1}, {2, 1}, {2, 1}}) == "convergence.size = 2: must not be given twice");
  CHECK(said({{1, 1}, {0, 1}, {2, 1}}) == "convergence.size = 0: must be positive and finite");
  CHECK(said({{1, 1}, {inf, 1}, {2, 1}}) == "convergence.size = inf: must be positive and finite");
  CHECK(said({{1, 1}, {nan, 1}, {2, 1}}) == "convergence.size = nan: must be positive and finite");
  CHECK(said({{1, nan}, {3, 1}, {2, 1}}) == "convergence.value = nan: must be finite");
  CHECK(said({{1, 1}, {3, -inf}, {2, 1}}) == "convergence.value = -inf: must be finite");
  const std::vector<SizedResult> good{{1, 1}, {2, 2}, {4, 4}};
  CHECK(said(good) == "nothing thrown");
  CHECK(said(good, {.least_order = 0}).find("ConvergenceRule.least_order = 0: must be positive") == 0);
  CHECK(said(good, {.safety = 0.5}) == "ConvergenceRule.safety = 0.5: must be at least 1");
  CHECK(said(good, {.spread_factor = nan}) == "ConvergenceRule.spread_factor = nan: must be at least 1");
  CHECK(said(good, {.round_off = 1}) == "ConvergenceRule.round_off = 1: must lie in [0, 1)");
}
