// Kernels against the same formulas point by point in scalars.
#pragma once

#include <arenite/transfer/reference.hpp>

#include "compare.hpp"

namespace arenite::test {

/// Greatest difference between two lists of vectors, over the greatest vector of the second.
template <class A, class B>
double off(const A& a, const B& b) {
  double worst = 0, size = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    worst = std::max(worst, static_cast<double>((a[i] - b[i]).norm()));
    size = std::max(size, static_cast<double>(b[i].norm()));
  }
  return worst / size;
}

/// P2G, MUSL mapping and G2P of random points, under gravity. `bound`: some hundred units of round-off.
template <class S>
void check_reference(S s, double bound = 1e-13) {
  using V = Vec<typename S::T, S::D>;
  using K = typename S::K;
  const auto sums = reference::p2g<K>(s.numerics, s.mesh, s.body);
  s = advanced(std::move(s));
  std::vector<V> kernel, expected;
  const auto add = [&](const auto& a, const auto& b) {
    kernel.push_back(a);
    expected.push_back(b);
  };
  const auto check = [&] {
    CHECK(off(kernel, expected) < bound);
    kernel.clear();
    expected.clear();
  };
  const std::size_t n = sums.size();
  for (std::size_t i = 0; i < n; ++i) add(s.nodes.sums[i].mass() * V::Ones(), sums[i].mass * V::Ones());
  check();
  for (std::size_t i = 0; i < n; ++i) add(s.nodes.sums[i].momentum(), sums[i].momentum);
  check();
  for (std::size_t i = 0; i < n; ++i) add(s.nodes.sums[i].force(), sums[i].force);
  check();
  for (std::size_t i = 0; i < n; ++i) add(s.nodes.mass_gradient[i], sums[i].mass_gradient);
  check();

  if constexpr (S::N::corrects_nodes) {
    const auto correction = reference::correction(s.numerics, s.mesh, s.body, s.nodes);
    s.correct_nodes();
    for (std::size_t i = 0; i < n; ++i) add(s.nodes.correction[i], correction[i]);
    check();
  }
  auto body = s.body;
  if constexpr (S::N::maps_back) {
    const auto mapped = reference::map_back(s.numerics, s.mesh, s.body, s.nodes);
    s.map_back();
    for (std::size_t i = 0; i < n; ++i) add(s.nodes.mapped[i], mapped[i]);
    check();
  }
  const typename S::T dt = typename S::T(0.01);
  const auto strains = reference::g2p<K>(s.numerics, s.mesh, body, s.nodes, dt);
  for (std::size_t p = 0; p < strains.size(); ++p) {
    auto stress = body.points.stress[p];
    NoHistory<typename S::T> none;
    body.law.update(stress, strains[p], none);
    body.points.stress.set(p, stress);
    body.points.volume[p] *= small_exp(trace(strains[p].strain));
  }
  s.g2p(dt);
  CHECK(difference(s.body.points, body.points) < bound);
}

}  // namespace arenite::test
