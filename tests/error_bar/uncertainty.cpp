// Uncertainty in parts.
#include <arenite/error_bar/uncertainty.hpp>

#include <limits>

#include "catch.hpp"
#include "message.hpp"

using namespace arenite;

TEST_CASE("Uncertainty: squares of the parts add") {
  Uncertainty u;
  CHECK(u.total() == 0.0);
  u.add("cells", 3);
  u.add("points", 4);
  u.add("contact", 12);
  CHECK(std::abs(*u.total() - 13) < 1e-14);
  CHECK(u.known() == *u.total());
  CHECK(u.parts().size() == 3);
  CHECK(u.part("points").value == 4.0);
}

TEST_CASE("Uncertainty: an unknown part makes the whole unknown") {
  Uncertainty u;
  u.add("cells", 3);
  u.add_unknown("contact");
  u.add("points", 4);
  CHECK(!u.total().has_value());
  CHECK(std::abs(u.known() - 5) < 1e-14);
  CHECK(!u.part("contact").value.has_value());
}

TEST_CASE("Uncertainty: half spread") {
  CHECK(half_spread({1, 4, 2}) == 1.5);
  CHECK(half_spread({-1, -1}) == 0);
}

TEST_CASE("Uncertainty: input that cannot be used") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Uncertainty u;
  u.add("cells", 0);
  CHECK(test::message([&] { u.add("cells", 1); }) == "Uncertainty.name = cells: must be given, and once");
  CHECK(test::message([&] { u.add("", 1); }) == "Uncertainty.name = : must be given, and once");
  CHECK(test::message([&] { u.add("a", -1); }) == "Uncertainty.a = -1: must be finite and at least 0");
  CHECK(test::message([&] { u.add("a", nan); }) == "Uncertainty.a = nan: must be finite and at least 0");
  CHECK(test::message([&] { u.part("b"); }) == "Uncertainty.part = b: there is no such part");
  CHECK(u.parts().size() == 1);
  CHECK(test::message([] { half_spread({1}); }) == "half_spread.values = 1: needs two values at least");
  CHECK(test::message([&] { half_spread({1, nan}); }) == "half_spread.values = nan: must be finite");
}
