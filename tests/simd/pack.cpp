// A pack must do in each lane what a scalar does, and a mask must choose lane by lane, whatever the compiler.
#include <arenite/simd/pack.hpp>
#include <arenite/simd/pack_functions.hpp>
#include <cmath>
#include <random>
#include <type_traits>
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
    const std::vector<T> exact(from.begin(), from.begin() + count);  // a read past its end is seen by ASan
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

namespace {

/// `f(x)` of each lane must have the bits of `f` of the scalar, be it a number or not.
template <class P, class F>
void check_function(const P& x, const F& f) {
  const P y = f(x);
  for (int k = 0; k < P::width; ++k) {
    const auto exact = f(x[k]);
    STATIC_REQUIRE(std::is_same_v<decltype(exact), const typename P::scalar>);
    const bool same = y[k] == exact || (std::isnan(y[k]) && std::isnan(exact));
    CAPTURE(x[k], y[k], exact);
    REQUIRE(same);
  }
}

template <class P>
void check_functions() {
  using T = typename P::scalar;
  using std::exp, std::exp2, std::expm1, std::log, std::log2, std::log10, std::log1p, std::cbrt, std::sin,
      std::cos, std::tan, std::asin, std::acos, std::atan, std::sinh, std::cosh, std::tanh, std::asinh,
      std::acosh, std::atanh, std::erf, std::floor, std::ceil, std::pow, std::atan2, std::hypot, std::sqrt,
      std::abs;
  for (const T scale : {T(0.3), T(2), T(1000)}) {
    P x(0);
    for (int k = 0; k < P::width; ++k) x.set(k, scale * (T(k) - T(P::width) / 3));
    const auto all = [&](const auto&... f) { (check_function(x, f), ...); };
    all([](const auto& a) { return exp(a); }, [](const auto& a) { return exp2(a); },
        [](const auto& a) { return expm1(a); }, [](const auto& a) { return log(a); },
        [](const auto& a) { return log2(a); }, [](const auto& a) { return log10(a); },
        [](const auto& a) { return log1p(a); }, [](const auto& a) { return cbrt(a); },
        [](const auto& a) { return sin(a); }, [](const auto& a) { return cos(a); },
        [](const auto& a) { return tan(a); }, [](const auto& a) { return asin(a); },
        [](const auto& a) { return acos(a); }, [](const auto& a) { return atan(a); },
        [](const auto& a) { return sinh(a); }, [](const auto& a) { return cosh(a); },
        [](const auto& a) { return tanh(a); }, [](const auto& a) { return asinh(a); },
        [](const auto& a) { return acosh(a); }, [](const auto& a) { return atanh(a); },
        [](const auto& a) { return erf(a); }, [](const auto& a) { return floor(a); },
        [](const auto& a) { return ceil(a); }, [](const auto& a) { return sqrt(abs(a)); });
    all([](const auto& a) { return pow(a, T(1.7)); }, [](const auto& a) { return pow(T(1.7), a); },
        [](const auto& a) { return pow(abs(a), a); }, [](const auto& a) { return atan2(a, T(2)); },
        [](const auto& a) { return hypot(a, T(3)); });
  }
}

}  // namespace

TEST_CASE("functions of <cmath>: each lane has the bits of the scalar's") {
  check_functions<Pack<double, 2>>();
  check_functions<Pack<float, 8>>();
  check_functions<PackPair<Pack<double, 4>>>();
}

TEST_CASE("a pack of doubles is W doubles") { check_widths<double, 1, 2, 4, 8>(); }
TEST_CASE("a pack of floats is W floats") { check_widths<float, 1, 2, 4, 8, 16>(); }
