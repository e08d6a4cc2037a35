// The error bar of a drop in numbers: which drops it takes, and what their results make of it.
#include "../../examples/ffp/drop/companions.hpp"

#include <map>
#include <set>

#include "catch.hpp"

using namespace arenite;
using namespace arenite::ffp;

namespace {

const DropOptions& named(const std::vector<Companion>& all, const std::string& name) {
  for (const Companion& c : all)
    if (c.name == name) return c.options;
  throw error("no companion " + name);
}

/// Results of all companions of the default drop, for a value of 1 of the drop itself.
std::map<std::string, double> results() {
  return {{"cells-2", 1.2},    {"cells-1.41", 1.0875}, {"points-16", 1.22},
          {"points-49", 1.19}, {"jitter-1", 1.25},     {"jitter-2", 1.21},
          {"offset-in", 1.10}, {"offset-out", 1.04},   {"flip-time", 1.0675}};
}

BarredResult bar_of(const std::map<std::string, double>& found) {
  return barred_result({}, 1.0, [&](const std::string& name) {
    return found.count(name) ? std::optional{found.at(name)} : std::nullopt;
  });
}

}  // namespace

TEST_CASE("companions: coarser cells, other points, jitters, offsets, a time of FLIP") {
  DropOptions drop;
  drop.cell_at_cone = 0.004;
  drop.out = "here";
  drop.resume = drop.error_bar = true;
  drop.delta = 33;
  const auto all = companions_of(drop);
  REQUIRE(all.size() == 9);
  std::set<std::string> folders;
  for (const auto& [name, o] : all) {
    INFO(name);
    CHECK(o.out == "here/error-bar/" + name);
    CHECK(folders.insert(o.out).second);
    CHECK(o.delta == 33);
    CHECK((o.quiet && o.fields_every == 0 && !o.error_bar && !o.resume));
    CHECK_NOTHROW(check(o));
    const double ratio = o.cell_size() / drop.cell_size();
    CHECK(std::abs(*o.cell_at_cone / 0.004 - ratio) < 1e-12);
    CHECK((ratio == 2 || std::abs(ratio - 1.41) < 1e-12));
    CHECK((ratio == 2 || (o.jitter == 0 && o.points_in_element() == 28)));
  }
  CHECK(named(all, "points-16").points_per_element == 16);
  CHECK(named(all, "points-49").points_per_element == 49);
  CHECK(named(all, "jitter-1").jitter == 1);
  CHECK(named(all, "jitter-1").jitter_seed != named(all, "jitter-2").jitter_seed);
  // Half a cell at the cone from one surface to the other.
  CHECK(std::abs(named(all, "offset-out").contact_offset - named(all, "offset-in").contact_offset - 0.002) <
        1e-15);
  CHECK(named(all, "flip-time").flip_time == 0.1);
  drop.flip_time = 0.02;
  CHECK(named(companions_of(drop), "flip-time").flip_time == 0.04);
}

TEST_CASE("companions: two other numbers of points, wherever the table ends") {
  const auto triangle = [](int n) { return other_counts(triangle_points, n); };
  CHECK(triangle(28) == std::vector{16, 49});
  CHECK(triangle(10) == std::vector{6, 15});
  CHECK(triangle(49) == std::vector{28, 16});
  CHECK(triangle(1) == std::vector{3, 6});
  CHECK(other_counts(tetrahedron_points, 10) == std::vector{4, 20});
  for (const int n : triangle_points) CHECK(triangle(n).size() == 2);
  for (const int n : tetrahedron_points) CHECK(other_counts(tetrahedron_points, n).size() == 2);
}

TEST_CASE("companions: parts of the error bar") {
  const BarredResult r = bar_of(results());
  const auto u = [&](const char* part) { return *r.uncertainty.part(part).value; };
  CHECK(r.value == 1);
  REQUIRE(r.cells.has_value());
  CHECK(r.converged());
  CHECK(std::abs(*r.cells->order - 0.75) < 0.1);
  CHECK(std::abs(u("cells") - 1.25 * std::abs(*r.cells->extrapolated - 1)) < 1e-12);
  CHECK(std::abs(u("contact_offset") - 0.03) < 1e-12);  // (1.10 - 1.04) / 2
  CHECK(std::abs(u("points") - 0.03) < 1e-12);          // (1.25 - 1.19) / 2
  CHECK(std::abs(u("flip_time") - 0.02) < 1e-12);       // 1.0875 - 1.0675
  CHECK(std::abs(square(*r.uncertainty.total()) - square(u("cells")) - 2 * square(0.03) - square(0.02)) <
        1e-12);
}

TEST_CASE("companions: what is not converged has three times the spread") {
  auto found = results();
  found["cells-1.41"] = 0.9;
  const BarredResult r = bar_of(found);
  CHECK(!r.converged());
  CHECK(std::abs(*r.uncertainty.part("cells").value - 0.9) < 1e-12);  // 3 (1.2 - 0.9)
}

TEST_CASE("companions: sizes that lie nearer each other than drops of one size are no convergence") {
  auto found = results();
  for (const auto& [coarse, coarsest] : {std::pair{1.01, 1.02}, {0.99, 1.005}}) {
    found["cells-1.41"] = coarse;
    found["cells-2"] = coarsest;
    for (const auto& [name, value] :
         {std::pair{"points-16", 1.0}, {"points-49", 1.05}, {"jitter-1", 1.03}, {"jitter-2", 0.98}})
      found[name] = value;
    const BarredResult r = bar_of(found);
    CHECK(!r.converged());
    CHECK(std::abs(*r.uncertainty.part("cells").value - 3 * 0.07) < 1e-12);  // 1.05 - 0.98
    CHECK(std::abs(*r.uncertainty.part("points").value - 0.035) < 1e-12);
  }
}

TEST_CASE("companions: a drop without result makes its part unknown, and the whole") {
  const std::map<std::string, std::set<std::string>> needs{
      {"cells-2", {"cells", "points"}},  {"cells-1.41", {"cells", "flip_time"}},
      {"points-16", {"points"}},         {"points-49", {"points"}},
      {"jitter-1", {"points"}},          {"jitter-2", {"points"}},
      {"offset-in", {"contact_offset"}}, {"offset-out", {"contact_offset"}},
      {"flip-time", {"flip_time"}}};
  REQUIRE(needs.size() == companions_of({}).size());
  for (const auto& [missing, parts] : needs) {
    INFO(missing);
    auto found = results();
    REQUIRE(found.erase(missing) == 1);
    const BarredResult r = bar_of(found);
    for (const auto& part : r.uncertainty.parts()) CHECK(part.value.has_value() == !parts.count(part.name));
    CHECK(!r.uncertainty.total().has_value());
    CHECK(r.uncertainty.known() > 0);
    CHECK(r.cells.has_value() == !parts.count("cells"));
  }
}
