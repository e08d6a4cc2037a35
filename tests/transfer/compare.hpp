// Bodies compared after a cycle of scatter, advance and what follows.
#pragma once

#include "catch.hpp"
#include "setup.hpp"

namespace arenite::test {

/// Greatest difference between two bodies' points, over the greatest number in each column.
template <class Points>
double difference(const Points& a, const Points& b) {
  std::vector<std::vector<double>> columns;
  a.for_each_column([&](const auto& column) { columns.emplace_back(column.begin(), column.end()); });
  double off = 0;
  std::size_t k = 0;
  b.for_each_column([&](const auto& column) {
    double size = 0, worst = 0;
    for (std::size_t p = 0; p < column.size(); ++p) {
      size = std::max(size, std::abs(columns[k][p]));
      worst = std::max(worst, std::abs(columns[k][p] - static_cast<double>(column[p])));
    }
    if (worst > 0) off = std::max(off, worst / size);
    ++k;
  });
  return off;
}

/// A setup after scatter and advance under gravity.
template <class S>
S advanced(S s) {
  s.p2g();
  auto gravity = s.node(0);
  gravity.setZero();
  gravity[1] = -10;
  s.update_grid(0.01, gravity);
  return s;
}

/// Points computed one by one against two, four and eight at once.
template <template <std::size_t> class N, class K, class M>
void check_widths(const M& mesh, int per_cell) {
  const auto cycle = [&]<std::size_t Bytes>(std::integral_constant<std::size_t, Bytes>) {
    auto s = advanced(Setup<K, N<Bytes>, M>(mesh, per_cell));
    s.map_back();
    s.g2p(0.01);
    return s.body.points;
  };
  const auto scalar = cycle(std::integral_constant<std::size_t, 8>{});
  REQUIRE(difference(scalar, cycle(std::integral_constant<std::size_t, 16>{})) <= 1e-12);
  REQUIRE(difference(scalar, cycle(std::integral_constant<std::size_t, 32>{})) <= 1e-12);
  REQUIRE(difference(scalar, cycle(std::integral_constant<std::size_t, 64>{})) <= 1e-12);
}

}  // namespace arenite::test
