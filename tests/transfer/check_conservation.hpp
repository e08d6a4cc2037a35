// Mass and momentum through a whole cycle of scatter, advance and gather.
#pragma once

#include "catch.hpp"
#include "setup.hpp"

namespace arenite::test {

template <class S>
void check_conservation(S s) {
  using T = typename S::T;
  const T tolerance = 1000 * std::numeric_limits<T>::epsilon();
  T mass = 0;
  for (const T m : s.body.points.mass) mass += m;
  const auto momentum = s.point_momentum();

  s.p2g();
  T node_mass = 0;
  auto sum = momentum;
  sum.setZero();
  for (const auto& sums : s.nodes.sums) {
    node_mass += sums.mass();
    sum += sums.momentum();
  }
  REQUIRE(std::abs(node_mass - mass) <= tolerance * mass);
  REQUIRE((sum - momentum).norm() <= tolerance * mass);

  // Internal forces sum to zero but for the hoop's radial part; gravity adds its impulse.
  T force = 0;
  auto total = momentum;
  total.setZero();
  for (const auto& sums : s.nodes.sums) {
    force += sums.force().norm();
    total += sums.force();
  }
  if constexpr (S::K::hoop) total[0] = 0;
  REQUIRE(force > 1);
  REQUIRE(total.norm() <= tolerance * force);

  auto gravity = momentum;
  gravity.setZero();
  gravity[1] = T(-9.81);
  if constexpr (S::K::hoop)
    for (auto& sums : s.nodes.sums) sums.lane[sums.force_lane] = 0;
  s.update_grid(T(0.01), gravity);
  REQUIRE((s.node_momentum() - momentum - T(0.01) * mass * gravity).norm() <= tolerance * (mass + force));
  const auto before = s.body.points.position;
  s.gather();
  REQUIRE((s.point_momentum() - momentum - T(0.01) * mass * gravity).norm() <= tolerance * (mass + force));
  REQUIRE(s.body.points.position == before);

  if constexpr (S::N::StressUpdate::maps_back) {
    // The mapped velocities are those that a second scatter of the new points gives.
    const auto mapped = s.nodes.strain_velocity();
    S again = s;
    again.p2g();
    again.update_grid();
    T off = 0;
    for (std::size_t i = 0; i < mapped.size(); ++i)
      off = std::max(off, s.nodes.mass[i] * (mapped[i] - again.nodes.velocity[i]).norm());
    REQUIRE(off <= tolerance);
  }
}

}  // namespace arenite::test
