// Contact of node fields: impulses that cancel, the velocity limit, normals from mass gradients.
#include "catch.hpp"

#include <arenite/contact/contact.hpp>

#include "../mesh/sample_meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

using Field = NodeField<double, 2, true, true>;
using Pairs = std::vector<ContactPair<double, 2>>;

/// Fields of N bodies at some nodes, with random masses, velocities and mass gradients.
template <std::size_t N>
std::array<Field, N> random_fields(Index nodes) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::array<Field, N> fields = []<std::size_t... I>(Index n, std::index_sequence<I...>) {
    return std::array<Field, N>{((void)I, Field(n))...};
  }
  (nodes, std::make_index_sequence<N>{});
  for (auto& f : fields)
    for (Index i = 0; i < nodes; ++i) {
      f.mass[i] = random() % 4 == 0 ? 0 : std::pow(10, 3 * uniform(random));
      f.velocity[i] = f.mass[i] > 0 ? Vec<double, 2>(uniform(random), uniform(random)) : Vec<double, 2>(0, 0);
      f.start[i] = f.velocity[i];
      f.mass_gradient[i] = {uniform(random), uniform(random)};
    }
  return fields;
}

template <std::size_t N, class C, class Map>
std::pair<ContactTally, std::array<Vec<double, 2>, N>> meet(const C& contact, std::array<Field, N>& fields,
                                                            const Map& map, double dt = 1e-3) {
  std::array<Vec<double, 2>, N> impulses;
  Pairs pairs;
  const auto tally = apply_contact(contact, map, fields, impulses, pairs, dt, [](Index) { return 0.1; });
  REQUIRE(pairs.size() == tally.nodes);
  return {tally, impulses};
}

template <std::size_t N>
double kinetic(const std::array<Field, N>& fields) {
  double sum = 0;
  for (const auto& f : fields)
    for (std::size_t i = 0; i < f.size(); ++i) sum += f.mass[i] * f.velocity[i].squaredNorm() / 2;
  return sum;
}

template <std::size_t N>
void check_balance(const Coulomb<>& contact) {
  auto fields = random_fields<N>(200);
  const auto before = fields;
  const auto [tally, impulses] = meet(contact, fields, MassGradient{});
  REQUIRE(tally.nodes > 50);
  double off = 0, changed_alone = 0;
  std::array<Vec<double, 2>, N> given;
  given.fill(Vec<double, 2>::Zero());
  for (std::size_t i = 0; i < 200; ++i) {
    Vec<double, 2> momentum(0, 0);
    std::size_t present = 0;
    double size = 0;
    for (std::size_t b = 0; b < N; ++b) {
      const Vec<double, 2> gain = fields[b].mass[i] * (fields[b].velocity[i] - before[b].velocity[i]);
      momentum += gain;
      given[b] += gain;
      present += before[b].mass[i] > 0;
      size += fields[b].mass[i];
    }
    off = std::max(off, momentum.norm() / std::max(size, 1e-3));
    if (present < 2)
      for (std::size_t b = 0; b < N; ++b)
        changed_alone += (fields[b].velocity[i] - before[b].velocity[i]).norm();
  }
  REQUIRE(off < 1e-15);
  REQUIRE(changed_alone == 0);
  Vec<double, 2> sum(0, 0);
  double largest = 0;
  for (std::size_t b = 0; b < N; ++b) {
    sum += impulses[b];
    largest += impulses[b].norm();
    REQUIRE((given[b] - impulses[b]).norm() < 1e-11);
  }
  REQUIRE(sum.norm() <= 1e-14 * largest);
  REQUIRE(tally.limited == 0);
  REQUIRE(tally.dissipation >= 0);
}

}  // namespace

TEST_CASE("the impulses of two and of three bodies cancel, node by node") {
  for (const Friction& f : {Friction(0.3), Friction::frictionless(), Friction::no_slip()}) {
    check_balance<2>(Coulomb<>(f));
    check_balance<3>(Coulomb<>(f));
  }
}

TEST_CASE("without forces, what two bodies lose is what contact dissipates") {
  auto fields = random_fields<2>(200);
  const double before = kinetic(fields);
  const auto [tally, impulses] = meet(Coulomb<>(Friction(0.3)), fields, MassGradient{});
  REQUIRE(std::abs(before - kinetic(fields) - tally.dissipation) < 1e-12 * before);
  REQUIRE(tally.dissipation > 0);
}

TEST_CASE("a head-on impact of two masses ends in their common velocity") {
  auto fields = random_fields<2>(1);
  fields[0].mass[0] = 1;
  fields[1].mass[0] = 3;
  fields[0].velocity[0] = {2, -4};
  fields[1].velocity[0] = {0, 0};
  fields[0].mass_gradient[0] = {0, -7};  // out of the upper body: down
  fields[1].mass_gradient[0] = {0, 9};
  meet(Coulomb<>(Friction::frictionless()), fields, MassGradient{});
  REQUIRE((fields[0].velocity[0] - Vec<double, 2>(2, -1)).norm() < 1e-15);
  REQUIRE((fields[1].velocity[0] - Vec<double, 2>(0, -1)).norm() < 1e-15);
  // They part freely.
  fields[0].velocity[0] = {2, 1};
  const auto [tally, impulses] = meet(Coulomb<>(Friction::no_slip()), fields, MassGradient{});
  REQUIRE(tally.nodes == 0);
  REQUIRE(impulses[0].norm() == 0);
  REQUIRE(fields[0].velocity[0] == Vec<double, 2>(2, 1));
}

TEST_CASE("without a normal they stick") {
  auto fields = random_fields<2>(1);
  for (auto& f : fields) {
    f.mass[0] = 2;
    f.mass_gradient[0] = {0.5, 0.5};  // both the same: no way out
  }
  fields[0].velocity[0] = {1, 0};
  fields[1].velocity[0] = {-3, 4};
  meet(Coulomb<>(Friction(0.1)), fields, MassGradient{});
  REQUIRE((fields[0].velocity[0] - Vec<double, 2>(-1, 2)).norm() < 1e-15);
  REQUIRE((fields[1].velocity[0] - Vec<double, 2>(-1, 2)).norm() < 1e-15);
}

TEST_CASE("normals of a surface belong to the body that fills it, whichever number it has") {
  for (const std::size_t device : {0u, 1u}) {
    auto fields = random_fields<2>(1);
    for (auto& f : fields) f.mass[0] = 1;
    NormalMap<double, 2> map{{{0, -1}}, device};  // out of the device: down
    fields[device].velocity[0] = {0, -2};
    fields[1 - device].velocity[0] = {0, 0};
    meet(Coulomb<SurfaceOf>(Friction(0.0), {"device", device}), fields, map);
    REQUIRE((fields[device].velocity[0] - Vec<double, 2>(0, -1)).norm() < 1e-15);
    fields[device].velocity[0] = {0, 2};  // away
    const auto [tally, impulses] = meet(Coulomb<SurfaceOf>(Friction(0.0), {"device", device}), fields, map);
    REQUIRE(tally.nodes == 0);
  }
}

TEST_CASE("the velocity limit scales down what would turn a cell inside out, and counts it") {
  const double dt = 0.01, most = 0.5 * 0.1 / dt;  // half of the smallest cell a step
  auto fields = random_fields<2>(2);
  for (auto& f : fields)
    for (Index i = 0; i < 2; ++i) {
      f.mass[i] = 1;
      f.mass_gradient[i] = {0, &f == &fields[0] ? -1.0 : 1.0};
    }
  fields[0].velocity = {{30, -4}, {1, -1}};
  fields[1].velocity = {{0, 0}, {0, 0}};
  auto free = fields;
  const auto [tally, impulses] =
      meet(Coulomb<>(Friction::frictionless(), {}, 0.5), fields, MassGradient{}, dt);
  REQUIRE(tally.limited == 1);
  const Vec<double, 2> unlimited(30, -2);
  REQUIRE((fields[0].velocity[0] - most * unlimited.normalized()).norm() < 1e-14);
  REQUIRE(std::abs(tally.limited_momentum - (unlimited.norm() - most)) < 1e-13);
  REQUIRE((fields[1].velocity[0] - Vec<double, 2>(0, -2)).norm() < 1e-15);
  REQUIRE((fields[0].velocity[1] - Vec<double, 2>(1, -0.5)).norm() < 1e-15);
  const auto [off, same] = meet(Coulomb<>(Friction::frictionless(), {}, 0), free, MassGradient{}, dt);
  REQUIRE(off.limited == 0);
  REQUIRE((free[0].velocity[0] - unlimited).norm() < 1e-14);
  REQUIRE(throws([] { Coulomb<> c(Friction(0.1), {}, -1); },
                 "Coulomb.velocity_limit = -1: must not be negative"));
}

TEST_CASE("the velocity limit applies at each node that contact touches, the last one too") {
  const double dt = 0.01, most = 0.5 * 0.1 / dt;
  auto fields = random_fields<2>(3);
  for (auto& f : fields)
    for (Index i = 0; i < 3; ++i) {
      f.mass[i] = 1;
      f.mass_gradient[i] = {0, &f == &fields[0] ? -1.0 : 1.0};
      f.velocity[i] = &f == &fields[0] ? Vec<double, 2>(30, -4) : Vec<double, 2>(0, 0);
    }
  const auto [tally, impulses] =
      meet(Coulomb<>(Friction::frictionless(), {}, 0.5), fields, MassGradient{}, dt);
  REQUIRE(tally.nodes == 3);
  REQUIRE(tally.limited == 3);
  for (Index i = 0; i < 3; ++i) REQUIRE(std::abs(fields[0].velocity[i].norm() - most) < 1e-14);
}

TEST_CASE(
    "mapped velocities keep what contact stopped: the normal part where bodies slide, all where they stick") {
  for (const Friction& friction : {Friction::frictionless(), Friction(0.3), Friction::no_slip()}) {
    auto fields = random_fields<2>(200);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (auto& f : fields)
      for (Index i = 0; i < 200; ++i) f.mapped[i] = {uniform(random), uniform(random)};
    std::array<Vec<double, 2>, 2> impulses;
    Pairs pairs;
    apply_contact(Coulomb<>(friction), MassGradient{}, fields, impulses, pairs, 1e-3,
                  [](Index) { return 0.1; });
    REQUIRE(pairs.size() > 20);
    const auto before = fields;
    const double dissipation = rest_between(pairs, fields);  // what is mapped is of the points yet
    CHECK(hold_together(pairs, fields, 1e-3) == 0);          // without forces
    std::vector<bool> met(200, false);
    double closed = 0, opened = 0, booked = 0;
    for (const auto& pair : pairs) {
      const Index i = pair.node;
      met[i] = true;
      const Vec<double, 2> relative = fields[0].mapped[i] - fields[1].mapped[i],
                           was = before[0].mapped[i] - before[1].mapped[i];
      (was.dot(pair.normal) < 0 ? closed : opened) += 1;
      REQUIRE(std::abs(relative.dot(pair.normal)) < 1e-15);
      const Vec<double, 2> slip = was - was.dot(pair.normal) * pair.normal;
      const Vec<double, 2> end = before[0].velocity[i] - before[1].velocity[i];
      REQUIRE(pair.sticks == (friction.coefficient() > 0 && end.norm() < 1e-12));
      REQUIRE((relative - (pair.sticks ? Vec<double, 2>(0, 0) : slip)).norm() < 1e-14);
      const auto momentum = [&](const auto& f) {
        return Vec<double, 2>(f[0].mass[i] * f[0].mapped[i] + f[1].mass[i] * f[1].mapped[i]);
      };
      REQUIRE((momentum(fields) - momentum(before)).norm() < 1e-14 * (fields[0].mass[i] + fields[1].mass[i]));
      booked -= pair.impulse.dot(was - end) / 2;
    }
    REQUIRE((closed > 5 && opened > 5));
    REQUIRE(std::abs(dissipation - booked) < 1e-12 * (1 + std::abs(booked)));
    for (Index i = 0; i < 200; ++i)
      for (std::size_t b = 0; b < 2; ++b)
        if (!met[i]) REQUIRE(fields[b].mapped[i] == before[b].mapped[i]);
  }
}
