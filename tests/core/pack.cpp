// A pack must do in each lane what a scalar does, and a mask must choose lane by lane, whatever the compiler.
#include <arenite/core/pack.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "catch.hpp"

using namespace arenite;

namespace {

template <class T, int W>
void check_pack() {
  using P = Pack<T, W>;
  static_assert(sizeof(P) == sizeof(T) * W);
  std::mt19937 random(7);
  std::uniform_real_distribution<T> number(T(-3), T(3));
  for (int trial = 0; trial < 200; ++trial) {
    P a(T(0)), b(T(0));
    for (int i = 0; i < W; ++i) {
      a.set(i, number(random));
      b.set(i, trial % 3 == 0 && i % 2 == 0 ? a[i] : number(random));
    }
    const P sum = a + b, difference = a - b, product = 2.0 * a * b, quotient = a / (b + T(7)), negative = -a;
    const P root = sqrt(abs(a)), low = min(a, b), high = max(a, b);
    const P choice = select(a < b, a, P(b * T(2)));
    const auto both = a < b && a > T(0);
    const auto either = a == b || !(a >= b);
    const auto order = a <= b, differ = a != b;
    bool any = false, all = true;
    for (int i = 0; i < W; ++i) {
      REQUIRE(sum[i] == a[i] + b[i]);
      REQUIRE(difference[i] == a[i] - b[i]);
      REQUIRE(product[i] == 2 * a[i] * b[i]);
      REQUIRE(quotient[i] == a[i] / (b[i] + 7));
      REQUIRE(negative[i] == -a[i]);
      REQUIRE(root[i] == std::sqrt(std::abs(a[i])));
      REQUIRE(low[i] == std::min(a[i], b[i]));
      REQUIRE(high[i] == std::max(a[i], b[i]));
      REQUIRE(choice[i] == (a[i] < b[i] ? a[i] : b[i] * 2));
      REQUIRE(both[i] == (a[i] < b[i] && a[i] > 0));
      REQUIRE(either[i] == (a[i] <= b[i]));
      REQUIRE(order[i] == (a[i] <= b[i]));
      REQUIRE(differ[i] == (a[i] != b[i]));
      any = any || both[i];
      all = all && order[i];
    }
    REQUIRE(any_of(both) == any);
    REQUIRE(all_of(order) == all);
  }
}

template <class T, int W>
void check_single_lanes() {
  using P = Pack<T, W>;
  for (int lane = 0; lane < W; ++lane) {
    P a(T(0));
    a.set(lane, T(1));
    REQUIRE(any_of(a > T(0)));
    REQUIRE(all_of(a > T(0)) == (W == 1));
    REQUIRE(!any_of(a > T(1)));
    REQUIRE(all_of(a >= T(0)));
    P hidden(std::numeric_limits<T>::quiet_NaN());
    const P chosen = select(a > T(0), a, select(a > T(0), hidden, P(T(5))));
    for (int i = 0; i < W; ++i) REQUIRE(chosen[i] == (i == lane ? T(1) : T(5)));
  }
  REQUIRE(all_of(Mask<T, W>(true)));
  REQUIRE(!any_of(Mask<T, W>(false)));
}

template <class T, int W>
void check_memory() {
  using P = Pack<T, W>;
  std::vector<T> from(2 * W + 1), to(2 * W + 1);
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = T(i) + T(1);
  P::load(from.data() + 1).store(to.data() + 1);  // not aligned
  for (std::size_t i = 1; i <= W; ++i) REQUIRE(to[i] == from[i]);
  REQUIRE(to[0] == T(0));
  REQUIRE(to[W + 1] == T(0));
  for (int count = 0; count <= W; ++count) {
    const std::vector<T> exact(from.begin(), from.begin() + count);  // a read behind its end is seen by ASan
    const P a = P::load(exact.data(), count, T(-4));
    for (int i = 0; i < W; ++i) REQUIRE(a[i] == (i < count ? T(i + 1) : T(-4)));
    std::vector<T> part(W, T(9));
    P(T(3)).store(part.data(), count);
    for (int i = 0; i < W; ++i) REQUIRE(part[static_cast<std::size_t>(i)] == (i < count ? T(3) : T(9)));
  }
}

template <class T, int... W>
void check_widths() {
  (check_pack<T, W>(), ...);
  (check_single_lanes<T, W>(), ...);
  (check_memory<T, W>(), ...);
}

}  // namespace

TEST_CASE("a pack of doubles is W doubles") { check_widths<double, 1, 2, 4, 8>(); }
TEST_CASE("a pack of floats is W floats") { check_widths<float, 1, 2, 4, 8, 16>(); }
