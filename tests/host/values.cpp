// Values of a host become recipes: by the names of members, with the sentences of the library where they do
// not fit.
#include <arenite_host/members.hpp>
#include <arenite_host/scene_host.hpp>

#include "catch.hpp"
#include "message.hpp"

using namespace arenite;
using arenite::test::message;

namespace {

using List = Value::List;
using Dict = Value::Dict;

Value numbers(std::initializer_list<double> x) {
  List list;
  for (const double v : x) list.emplace_back(v);
  return list;
}

Dict sand() { return {{"density", 1540.0}, {"young", 1e6}, {"poisson", 0.3}, {"friction", 0.6}}; }

template <class T>
T given(const Value& value) {
  return read<T>(value, ReadContext{.name = "given", .dimension = 2});
}

}  // namespace

TEST_CASE("members of an aggregate by name", "[host]") {
  const auto& names = member_names<MohrCoulombParameters>;
  REQUIRE(names.size() == 8);
  CHECK(names[0] == "density");
  CHECK(names[7] == "tension");
  CHECK(member_names<Free>[7] == "moment");
  CHECK(member_count<Apic> == 0);
}

TEST_CASE("an aggregate takes what is given, and its own for the rest", "[host]") {
  const auto p = given<MohrCoulombParameters>(sand());
  CHECK(p.friction == 0.6);
  CHECK(p.greatest_volume_ratio == 1.5);
  CHECK(given<Flip>(Dict{{"fraction", 0.9}}).fraction == 0.9);
  CHECK(given<Guided>(Dict{{"mass", 2.0}, {"axis", numbers({0, -1})}}).axis ==
        std::array<double, 3>{0, -1, 0});
}

TEST_CASE("what does not fit is reported by place, value and rule", "[host]") {
  CHECK(message([] { given<Flip>(Dict{{"fraction", 2.0}}); }) == "Flip.fraction = 2: must lie in [0, 1]");
  CHECK(message([] {
          given<Flip>(Dict{{"share", 1.0}});
        }) == "given.share = 1: is unknown; there are: fraction, time");
  CHECK(message([] {
          given<Flip>(Dict{{"fraction", std::string("all")}});
        }) == "given.fraction = all: must be a number");
  CHECK(message([] {
          given<Guided>(Dict{{"axis", numbers({1, 2, 3, 4})}});
        }) == "given.axis = a list of 4: must be up to 3 numbers");
  CHECK(message([] { given<bool>(1.0); }) == "given = 1: must be true or false");
  CHECK(message([] { given<int>(1.5); }) == "given = 1.5: must be a whole number that fits");
  CHECK(message([] {
          given<AnyDistance>(Dict{{"shape", std::string("Cylinder")}});
        }) ==
        "given = Cylinder: must be a shape in 2 dimensions: Box, Ball, RoundedBox, Capsule, ConeCylinder, "
        "Polygon");
}

TEST_CASE("a function of place is asked once for all places", "[host]") {
  int calls = 0;
  BatchedFunction<1> f(
      [&](const HostArray& x) {
        ++calls;
        HostArray out{{}, {x.rows()}};
        for (std::size_t p = 0; p < x.rows(); ++p)
          out.numbers.push_back(x.numbers[2 * p] + x.numbers[2 * p + 1]);
        return out;
      },
      2, "f");
  CHECK(f({1, 2, 0})[0] == 0);  // noted
  CHECK(f({3, 4, 0})[0] == 0);
  f.compute();
  CHECK(f({1, 2, 0})[0] == 3);
  CHECK(f({3, 4, 0})[0] == 7);
  f.rewind();
  CHECK(f({3, 4, 0})[0] == 7);
  CHECK(calls == 1);
  CHECK(f({5, 5, 0})[0] == 10);  // out of turn
  CHECK(calls == 2);
}

TEST_CASE("a tile gets what a function of place returned for the whole", "[host]") {
  int calls = 0;
  const Value value(std::make_shared<
                    const HostFunction>([&](const HostArray&
                                                x) {  // its number among all, and the least place
    ++calls;
    HostArray out{{}, {x.rows(), 2}};
    for (std::size_t p = 0; p < x.rows(); ++p)
      out.numbers.insert(out.numbers.end(), {static_cast<double>(p), *std::ranges::min_element(x.numbers)});
    return out;
  }));
  const HostFunction& f = *value.function();
  PlaceMemory memory;
  const HostArray whole{{4, 2, 9, 2, 7}, {5, 1}};
  CHECK(memory.ask(f, "f")(whole).numbers == std::vector<double>{0, 2, 1, 2, 2, 2, 3, 2, 4, 2});
  memory.close();
  const HostFunction of_tile = memory.ask(f, "f");
  CHECK(of_tile({{7, 2, 2, 4}, {4, 1}}).numbers == std::vector<double>{4, 2, 1, 2, 3, 2, 0, 2});
  CHECK(of_tile({{2}, {1, 1}}).numbers == std::vector<double>{1, 2});
  CHECK(calls == 1);
  CHECK(of_tile({{5}, {1, 1}}).numbers == std::vector<double>{0, 5});  // a place out of turn
  CHECK(calls == 2);
  CHECK(message([&] {
          of_tile({{7, 5}, {2, 1}});
        }).starts_with("f = a function of positions: is asked once"));
}

TEST_CASE("a hosted scene has the bits of the scene itself", "[host]") {
  using Column = Scene<PlaneStrain, CartesianGrid<2>, Numerics<QuadraticBSpline, Apic>,
                       Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity>;
  const Value box(
      Dict{{"shape", std::string("Box")}, {"lower", numbers({0, 0})}, {"upper", numbers({0.1, 0.1})}});
  const Value wall(Dict{{"axis", 1.0}, {"condition", Dict{{"kind", 0.0}}}});
  const auto values_with = [&](const Value& g) {
    return Value(
        Dict{{"mesh", Dict{{"lower", numbers({0, 0})}, {"upper", numbers({0.2, 0.2})}, {"cell", 0.02}}},
             {"parts", List{Value(List{Value(Dict{{"region", box}, {"law", sand()}})}),
                            Value(Dict{{"list", List{wall}}}), Value(Dict{{"g", g}})}}});
  };
  const Value values = values_with(numbers({0, -9.81}));
  CHECK(message([&] {
          make_hosted<Column>(values_with(numbers({0, -9.81, 0})));
        }) == "gravity: components = 3: must be 2, as many as the scene has dimensions");
  const auto hosted = make_hosted<Column>(values);
  Column itself(PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.2, 0.2}, .cell = 0.02}},
                Numerics<QuadraticBSpline, Apic>{},
                bodies(fill(Box{{0, 0}, {0.1, 0.1}},
                            MohrCoulomb{{.density = 1540, .young = 1e6, .poisson = 0.3, .friction = 0.6}})),
                walls(bottom(fixed)), gravity({0, -9.81}));
  const auto before = hosted->generation();
  hosted->run({.end = 0.01});
  run(itself, {.end = 0.01});
  CHECK(hosted->generation() != before);
  CHECK(hosted->steps() == itself.steps);
  std::size_t compared = 0;
  for (const auto& entry : hosted->state())
    if (entry.name == "bodies/0/points/velocity/y") {
      const auto& column = itself.body().points.velocity.column(1);
      CHECK(std::equal(column.begin(), column.end(), static_cast<const double*>(entry.data)));
      compared = entry.count;
    }
  CHECK(compared == itself.point_count());
  CHECK(message([&] { hosted->step(-1); }) == "step: dt = -1: must be positive and finite (s)");
  CHECK(message([&] { hosted->energies(); }) == "energies: name TrackEnergy{} among the scene's parts");

  // Points of both, added, removed and read in the same way.
  const Box gone{{0.05, 0.05}, {0.1, 0.2}}, more{{0.12, 0}, {0.16, 0.04}};
  const auto region = [](const Box<2>& b) {
    return Value(Dict{{"shape", std::string("Box")},
                      {"lower", numbers({b.lower[0], b.lower[1]})},
                      {"upper", numbers({b.upper[0], b.upper[1]})}});
  };
  const auto taken = remove_points<"">(itself, gone);
  CHECK(hosted->remove(0, region(gone)).mass == taken.mass);
  const auto brought = insert_points<"">(itself, more, {.per_cell = 4});
  const HostedTotals filled = hosted->fill(0, Dict{{"region", region(more)}, {"law", sand()}});
  CHECK(filled.count == brought.count);
  CHECK(filled.mass == brought.mass);
  const auto rows = [](std::vector<double> numbers, std::vector<std::size_t> shape) {
    return Value(std::make_shared<const HostArray>(HostArray{std::move(numbers), std::move(shape)}));
  };
  const Dict point{{"position", rows({0.15, 0.1}, {1, 2})},
                   {"volume", rows({1e-5}, {1})},
                   {"velocity", rows({1, 0}, {1, 2})}};
  CHECK(hosted->insert(0, point).momentum == std::vector<double>{1540 * 1e-5, 0});
  CHECK(message([&] {
          hosted->insert(0, Dict{{"position", rows({0.15, 0.1}, {1, 2})}, {"mass", rows({1, 2}, {2})}});
        }) == "mass = an array of 2 numbers: must be 1 rows of 1");
  const Dict soil{{"cells", List{Value(std::string("soil"))}}};
  for (const auto& call : {+[](HostedScene&h, const Dict&c) { h.remove(0, c); },
                           +[](HostedScene&h, const Dict&c) {
                             h.fill(0, Dict{{"region", c}, {"law", sand()}});
                           }})
    CHECK(message([&] { call(*hosted, soil); }) ==
          "Cells = soil: a grid has no regions; they go with simplices");
  CHECK(message([&] { hosted->remove(1, region(gone)); }) == "body = 1: must be below 1");
  std::remove_cvref_t<decltype(itself.body())>::Point joins{};
  joins.position = {0.15, 0.1};
  joins.velocity = {1, 0};
  joins.volume = 1e-5;
  insert_points<"">(itself, {joins});
  const auto there = probe(itself, {0.03, 0.03, 0});
  const HostedProbes found = hosted->probe(0, {0.03, 0.03, 0.19, 0.19});
  REQUIRE(there);
  CHECK(found.stress[1] == there->stress[1]);
  CHECK(std::isnan(found.velocity[2]));
  const Section cut{.through = {0, 0.03, 0}, .normal = {0, 1, 0}, .thickness = 0.04};
  const Dict same_cut{{"through", numbers({0, 0.03})}, {"normal", numbers({0, 1})}, {"thickness", 0.04}};
  CHECK(hosted->section_force(0, same_cut, false)[1] == section_force(itself, cut)[1]);
  CHECK(hosted->section_force(0, same_cut, true)[1] == nodal_section_force(itself, cut)[1]);
  CHECK(message([&] { hosted->run({.end = 1, .settle = 1e-3}); }) ==
        "settle: name a part that damps: LocalDamping or ViscousDamping");
}
