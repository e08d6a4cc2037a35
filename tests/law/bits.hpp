// The bits that a law makes of random states, to compare laws that must be the same.
#pragma once

#include <arenite/arenite.hpp>
#include <bit>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "catch.hpp"
#include "states.hpp"

namespace arenite::test {

/// Packs of random states, taken through `steps` steps; the bits of each number after each step, those of the
/// history by name.
template <class P, int D, class Law>
std::map<std::string, std::vector<std::uint64_t>> bits_of(const Law& law, double apex) {
  using History = typename Law::template History<P>;
  std::map<std::string, std::vector<std::uint64_t>> bits;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int pack = 0; pack < 512; ++pack) {
    Sym<P, D> stress;
    History history{};
    for (int k = 0; k < lane_count<P>; ++k) {
      const auto state = trial_state<D>(random, apex);
      for (std::size_t i = 0; i < stress.size; ++i) set(stress[i], k, state[i]);
    }
    for (int n = 0; n < 3; ++n) {
      StrainStep<P, D> step;
      step.dt = 1e-4;
      for (int k = 0; k < lane_count<P>; ++k) {
        const double size = std::pow(10, -4 + uniform(random));
        for (std::size_t i = 0; i < stress.size; ++i) set(step.strain[i], k, size * uniform(random));
        for (P& w : step.spin) set(w, k, 0.01 * uniform(random));
      }
      const auto parts = inelastic(law.update(stress, step, history));
      const auto add = [&](const std::string& name, const P& value) {
        for (int k = 0; k < lane_count<P>; ++k)
          bits[name].push_back(std::bit_cast<std::uint64_t>(lane(value, k)));
      };
      for (const P& component : stress.c) add("stress", component);
      add("opened", parts.opening);
      add("dilated", parts.dilation);
      add("yield", yield_of(law, stress, history));
      add("energy", elastic_energy_of(law, stress, history));
      std::apply(
          [&](const auto&... member) {
            std::size_t m = 0;
            (add(std::string(history_names<History>[m++]), member), ...);
          },
          history.members());
    }
  }
  return bits;
}

/// Checks that two laws give the same bits, of the second what the first has.
template <class P, int D, class Exact, class Any>
void compare_bits(const Exact& exact, const Any& any, double apex) {
  const auto wanted = bits_of<P, D>(exact, apex), found = bits_of<P, D>(any, apex);
  for (const auto& [name, bits] : wanted) {
    CAPTURE(name, lane_count<P>, D);
    CHECK((found.at(name) == bits));
  }
}
template <class Exact, class Any>
void compare_bits(const Exact& exact, const Any& any, double apex) {
  compare_bits<double, 3>(exact, any, apex);
  compare_bits<double, 2>(exact, any, apex);
  compare_bits<Pack<double, 4>, 3>(exact, any, apex);
}

}  // namespace arenite::test
