// Sums without rounding: the same in any order, rounded once at the end.
#include <arenite/tiles.hpp>

#include <algorithm>
#include <bit>
#include <random>

#include "catch.hpp"

using namespace arenite;

namespace {
double exact(const std::vector<double>& numbers) {
  ExactSum sum;
  for (const double x : numbers) sum.add(x);
  return sum.value();
}
}  // namespace

TEST_CASE("An exact sum of one double is that double, whatever its bits") {
  std::mt19937_64 random(1);
  for (int k = 0; k < 200000; ++k) {
    const auto x = std::bit_cast<double>(random());
    if (!std::isnan(x) && exact({x}) != x) FAIL(x);
  }
  for (const double x : {0.0, 5e-324, -5e-324, 2.2250738585072014e-308, 1.7976931348623157e308})
    CHECK(exact({x}) == x);
}

TEST_CASE("An exact sum of two doubles is what IEEE 754 rounds it to") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto any = [&] { return std::ldexp(uniform(random), static_cast<int>(random() % 120) - 60); };
  for (int k = 0; k < 200000; ++k) {
    const double a = any(), b = any();
    if (exact({a, b}) != a + b) FAIL(a << " + " << b);
  }
}

TEST_CASE(
    "An exact sum does not depend on the order, nor on how its words are added; what cancels leaves "
    "nothing") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> numbers;
  for (int k = 0; k < 1000; ++k)
    numbers.push_back(std::ldexp(uniform(random), static_cast<int>(random() % 600) - 300));
  const double sum = exact(numbers);
  for (int k = 0; k < 20; ++k) {
    std::shuffle(numbers.begin(), numbers.end(), random);
    CHECK(exact(numbers) == sum);
    ExactSum first, rest;
    for (std::size_t i = 0; i < numbers.size(); ++i) (i < 300 ? first : rest).add(numbers[i]);
    for (std::size_t w = 0; w < ExactSum::words; ++w) first.all()[w] += rest.all()[w];
    CHECK(first.value() == sum);
  }
  for (const double x : std::vector(numbers)) numbers.push_back(-x);
  std::shuffle(numbers.begin(), numbers.end(), random);
  CHECK(exact(numbers) == 0);
  CHECK(exact({1e308, 1e308, -1e308}) == 1e308);
  CHECK(exact({1, 1e-30, -1}) == 1e-30);
}

TEST_CASE("An exact sum with an infinite number, or none, is that") {
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(exact({1, infinite}) == infinite);
  CHECK(exact({-infinite, 1e308}) == -infinite);
  CHECK(std::isnan(exact({infinite, -infinite})));
  CHECK(std::isnan(exact({1, std::nan("")})));
  CHECK(exact({1e308, 1e308}) == infinite);
}
