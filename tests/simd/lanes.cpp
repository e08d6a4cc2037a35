// Operations on packs besides arithmetic: parts of columns in and out, sums over the lanes, twin packs.
#include "catch.hpp"

#include <arenite/simd/lanes.hpp>
#include <random>

using namespace arenite;

namespace {

/// Two packs of W / 2.
template <class T, int W>
struct Twins {
  using scalar = T;
  static constexpr int width = W;
  using P = PackPair<Pack<T, W / 2>>;
};

template <class T, int W>
struct Width {
  using scalar = T;
  static constexpr int width = W;
  using P = lanes_of<T, W>;
};

template <class P>
auto lane(const P& p, int k) {
  if constexpr (is_pack<P>)
    return p[k];
  else
    return k == 0 ? p : P(0);
}

}  // namespace

TEMPLATE_TEST_CASE("part of a column: the lanes after it have the fill, and nothing after it is written", "",
                   (Width<double, 1>), (Width<double, 2>), (Width<double, 4>), (Width<double, 8>),
                   (Twins<double, 16>), (Width<float, 4>), (Width<float, 8>), (Width<float, 16>),
                   (Twins<float, 32>)) {
  using T = typename TestType::scalar;
  using P = typename TestType::P;
  constexpr int width = TestType::width;
  for (int count = 1; count <= width; ++count) {
    // Exactly as long as what may be read, so that a sanitizer sees more.
    std::vector<T> from(static_cast<std::size_t>(count)), to(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) from[static_cast<std::size_t>(k)] = static_cast<T>(k + 1);
    const P p = load_lanes<P>(from.data(), count, T(-7));
    for (int k = 0; k < width; ++k) REQUIRE(lane(p, k) == (k < count ? static_cast<T>(k + 1) : T(-7)));
    store_lanes(to.data(), count, p);
    REQUIRE(to == from);
    const auto behind = lanes_from<P>(count);
    if constexpr (is_pack<P>)
      for (int k = 0; k < width; ++k) REQUIRE(behind[k] == (k >= count));
    else
      REQUIRE(!behind);
  }
}

TEMPLATE_TEST_CASE("sums of the lanes of any number of packs", "", (Width<double, 1>), (Width<double, 2>),
                   (Width<double, 4>), (Width<double, 8>), (Twins<double, 16>), (Width<float, 8>),
                   (Width<float, 16>)) {
  using T = typename TestType::scalar;
  using P = typename TestType::P;
  const auto check = [](auto packs) {
    for (std::size_t n = 0; n < packs.size(); ++n) {
      packs[n] = P(T(0));
      if constexpr (is_pack<P>)
        for (int k = 0; k < TestType::width; ++k)
          packs[n].set(k, static_cast<T>(100 * n + static_cast<std::size_t>(k)));
      else
        packs[n] = static_cast<T>(100 * n);
    }
    const auto sums = lane_sums(packs);
    for (std::size_t n = 0; n < packs.size(); ++n) {
      T expected = 0;
      for (int k = 0; k < TestType::width; ++k)
        expected += static_cast<T>(100 * n + static_cast<std::size_t>(k));
      REQUIRE(sums[n] == expected);
    }
    for (std::size_t n = packs.size(); n < packs.size() + 3; ++n) REQUIRE(sums[n] == 0);
  };
  check(std::array<P, 1>{});
  check(std::array<P, 7>{});
  check(std::array<P, 8>{});
  check(std::array<P, 23>{});
}

TEMPLATE_TEST_CASE("reciprocals are right to a few units in the last place", "", (Width<double, 4>),
                   (Width<double, 8>), (Twins<double, 16>), (Width<float, 16>), (Twins<float, 32>)) {
  using T = typename TestType::scalar;
  using P = typename TestType::P;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-29, 29);
  double off = 0;
  for (int round = 0; round < 2000; ++round) {
    P x;
    for (int k = 0; k < TestType::width; ++k) x.set(k, static_cast<T>(std::pow(10.0, exponent(random))));
    const P inverse = reciprocal(x), root = reciprocal_root(x);
    for (int k = 0; k < TestType::width; ++k) {
      const auto v = static_cast<double>(x[k]);
      off = std::max({off, std::abs(static_cast<double>(inverse[k]) * v - 1),
                      std::abs(static_cast<double>(root[k]) * std::sqrt(v) - 1)});
    }
  }
  REQUIRE(off < 4 * static_cast<double>(std::numeric_limits<T>::epsilon()));
  REQUIRE(reciprocal(P(1))[0] == 1);
  REQUIRE(reciprocal_root(P(4))[0] == T(0.5));
}

TEST_CASE("a twin pack computes as its halves do") {
  PackPair<Pack<double, 8>> a, b;
  for (int k = 0; k < 16; ++k) {
    a.set(k, 0.5 + k);
    b.set(k, 7.25 - k);
  }
  const PackPair<Pack<double, 8>> r = select(a < b, a * b - a / b, max(sqrt(a), abs(b)) + min(-a, b));
  for (int k = 0; k < 16; ++k) {
    const double x = 0.5 + k, y = 7.25 - k;
    REQUIRE(r[k] == (x < y ? x * y - x / y : std::max(std::sqrt(x), std::abs(y)) + std::min(-x, y)));
  }
  REQUIRE((any_of(a < b) && !all_of(a < b) && all_of(a > 0 * a) && !any_of(a < 0 * a)));
  REQUIRE((all_of(!(a < 0 * a)) && all_of(a == a) && !any_of(a != a)));
}

TEMPLATE_TEST_CASE("the greatest lane, wherever it is", "", (Width<double, 1>), (Width<double, 2>),
                   (Width<double, 8>), (Width<float, 16>)) {
  using P = typename TestType::P;
  for (int at = 0; at < TestType::width; ++at) {
    P p(-3);
    if constexpr (is_pack<P>)
      p.set(at, 5);
    else
      p = 5;
    REQUIRE(greatest_lane(p) == 5);
    REQUIRE(in_lane(p > P(0), at));
  }
}

namespace {

/// Squares of `Size` rows by `Size` lanes: lane s Size + c of row r becomes lane s Size + r of row c.
template <class T, int W, std::size_t Size>
void check_transpose() {
  std::array<Pack<T, W>, Size> rows;
  for (std::size_t r = 0; r < Size; ++r)
    for (int k = 0; k < W; ++k) rows[r].set(k, static_cast<T>(100 * r + static_cast<std::size_t>(k)));
  transpose_lanes(rows);
  for (std::size_t r = 0; r < Size; ++r)
    for (std::size_t k = 0; k < W; ++k)
      REQUIRE(rows[r][static_cast<int>(k)] == static_cast<T>(100 * (k % Size) + k / Size * Size + r));
}

}  // namespace

TEST_CASE("squares of lanes are transposed, and packs joined") {
  check_transpose<double, 2, 2>();
  check_transpose<double, 4, 4>();
  check_transpose<double, 8, 8>();
  check_transpose<double, 8, 4>();
  check_transpose<float, 8, 4>();
  check_transpose<float, 16, 16>();
  Pack<double, 4> a(1), b(2);
  a.set(3, 7);
  const auto both = join_packs(a, b);
  REQUIRE((both[0] == 1 && both[3] == 7 && both[4] == 2 && both[7] == 2));
}
