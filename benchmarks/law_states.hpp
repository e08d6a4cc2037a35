// States that laws are timed on: points with a stress and a strain, of which a given share yields.
#pragma once

#include <algorithm>
#include <arenite/arenite.hpp>
#include <cmath>
#include <random>
#include <vector>

namespace arenite::bench {

inline constexpr double density = 1540, young = 5e6, poisson = 0.33, friction = 40 * pi / 180;
inline constexpr double time_step = 1e-5;  // s

/// Columns of points: stress and strain before a step, and room for what the step makes of them, so that
/// each pass starts from the same states. 4160 points: too many for a branch predictor to learn, few enough
/// for the second-level cache, and no power of two, which would put all columns into the same lines of the
/// first.
template <class T, int D>
struct LawStates {
  static constexpr std::size_t n = 4160;
  static constexpr std::size_t stresses = Sym<T, D>::size, spins = D == 2 ? 1 : 3;
  std::array<std::vector<T>, stresses> stress, strain, result;
  std::array<std::vector<T>, spins> spin;
  std::vector<T> opened = std::vector<T>(n), memory = std::vector<T>(n);

  LawStates() {
    for (auto* columns : {&stress, &strain, &result})
      for (auto& column : *columns) column.assign(n, T(0));
    for (auto& column : spin) column.assign(n, T(0));
  }

  Sym<T, D> stress_of(std::size_t p) const {
    return Sym<T, D>::each([&](std::size_t i) { return stress[i][p]; });
  }
  StrainStep<T, D> step_of(std::size_t p) const {
    StrainStep<T, D> inc;
    inc.strain = Sym<T, D>::each([&](std::size_t i) { return strain[i][p]; });
    for (std::size_t i = 0; i < spins; ++i) inc.spin[i] = spin[i][p];
    return inc;
  }
};

/// Stresses around 100 kPa of pressure in random directions; the size of their deviators is such that
/// `yielding` of the points yield by `law` in the step, at random places, and among them a few open (mean
/// stress above the apex). With `yielding` 0 all stay within the cone inscribed in the yield surface.
template <class T, int D, class Law>
LawStates<T, D> law_states(const Law& law, double yielding) {
  LawStates<T, D> states;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> pressure(states.n), size(states.n);
  for (std::size_t p = 0; p < states.n; ++p) {
    pressure[p] = 1e5 + 5e4 * uniform(random);
    if (yielding > 0 && p % 32 == 5) pressure[p] = -1e3;
    double norm = 0, trace = 0;
    for (std::size_t i = 0; i < states.stresses; ++i) {
      states.stress[i][p] = static_cast<T>(uniform(random));
      states.strain[i][p] = static_cast<T>(1e-5 * uniform(random));
      if (i < 3) trace += static_cast<double>(states.stress[i][p]);
    }
    for (std::size_t i = 0; i < 3; ++i) states.stress[i][p] -= static_cast<T>(trace / 3);
    for (std::size_t i = 0; i < states.stresses; ++i)
      norm += (i < 3 ? 1 : 2) * square(static_cast<double>(states.stress[i][p]));
    for (std::size_t i = 0; i < states.spins; ++i) states.spin[i][p] = static_cast<T>(1e-5 * uniform(random));
    size[p] = (yielding > 0 ? 0.6 + 0.4 * uniform(random) : 1.0) / std::sqrt(norm);
  }
  const auto scaled = [&](std::size_t p, double ratio) {
    const double factor = ratio * std::abs(pressure[p]) * size[p];
    return Sym<T, D>::each([&](std::size_t i) {
      return static_cast<T>(factor * static_cast<double>(states.stress[i][p]) - (i < 3 ? pressure[p] : 0));
    });
  };
  double low = 0.2, high = 4;
  if constexpr (knows_yield<Law, T, D>) {
    const auto elastic = law.elasticity();
    for (int k = 0; k < 30 && yielding > 0; ++k) {
      const double ratio = (low + high) / 2;
      std::size_t count = 0;
      for (std::size_t p = 0; p < states.n; ++p) {
        const auto inc = states.step_of(p);
        const Sym<T, D> trial = turned(scaled(p, ratio), inc.spin) + elastic.stress(inc.strain);
        count += yield_of(law, trial, typename Law::template History<T>{}) > T(0);
      }
      (static_cast<double>(count) < yielding * static_cast<double>(states.n) ? low : high) = ratio;
    }
  }
  for (std::size_t p = 0; p < states.n; ++p) {
    const auto s = scaled(p, low);
    for (std::size_t i = 0; i < states.stresses; ++i) states.stress[i][p] = s[i];
  }
  return states;
}

/// Takes all points through one step as a scene with packs of W does: one by one if W is 1, two packs side
/// by side if the law asks for it.
template <int W, class T, int D, class Law>
[[gnu::flatten]] void update_all(const Law& law, LawStates<T, D>& states) {
  using Value = typename LawLanes<Law, T, W>::type;
  constexpr int count = lane_count<Value>;
  static_assert(LawStates<T, D>::n % count == 0);
  const auto gather = [](const std::vector<T>& column, std::size_t p) {
    return load_lanes<Value>(&column[p], count);
  };
  const auto give = [](std::vector<T>& column, std::size_t p, const Value& value) {
    store_lanes(&column[p], count, value);
  };
  const Law own = law;  // a copy: its constants stay in registers
  for (std::size_t p = 0; p < states.n; p += count) {
    const auto all = [&](const auto& columns) {
      return Sym<Value, D>::each([&](std::size_t i) { return gather(columns[i], p); });
    };
    Sym<Value, D> stress = all(states.stress);
    StrainStep<Value, D> inc;
    inc.strain = all(states.strain);
    inc.dt = time_step;
    for (std::size_t i = 0; i < states.spins; ++i) inc.spin[i] = gather(states.spin[i], p);
    typename Law::template History<Value> history{};
    const auto each_memory = [&](auto&& f) {
      std::apply([&](auto&... m) { (f(m), ...); }, history.members());
    };
    each_memory([&](Value& m) { m = gather(states.memory, p); });
    const Value opened = inelastic(own.update(stress, inc, history)).opening;
    for (std::size_t i = 0; i < states.stresses; ++i) give(states.result[i], p, stress[i]);
    give(states.opened, p, opened);
    each_memory([&](const Value& m) { give(states.result[0], p, m + stress[0]); });  // stored, but not kept
  }
}

}  // namespace arenite::bench
