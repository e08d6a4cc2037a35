// Units at the call site arrive as SI, at compile time.
#include <arenite/core/units.hpp>

#include "catch.hpp"

using namespace arenite;

namespace {
bool near(double a, double b) { return std::abs(a - b) <= 1e-15 * std::abs(b); }
}  // namespace

TEST_CASE("angles become radians") {
  static_assert(0_deg == 0);
  REQUIRE(near(180_deg, 3.14159265358979323846));
  REQUIRE(near(30_deg, std::asin(0.5)));
  REQUIRE(near(22.5_deg, std::atan(std::sqrt(2.0) - 1)));
}

TEST_CASE("stresses become pascals") {
  static_assert(1_kPa == 1000_Pa && 1_MPa == 1000_kPa && 1_GPa == 1000_MPa);
  REQUIRE(near(2.5_Pa, 2.5));
  REQUIRE(near(2.5_kPa, 2500));
  REQUIRE(near(2.5_MPa, 2.5e6));
  REQUIRE(near(2.5_GPa, 2.5e9));
}

TEST_CASE("lengths become metres") {
  static_assert(3_m == 3);
  REQUIRE(near(1_cm, 0.01));
  REQUIRE(near(10_mm, 0.01));
  REQUIRE(near(0.5_m, 50_cm));
  REQUIRE(near(2.5_cm, 25.0_mm));
}
