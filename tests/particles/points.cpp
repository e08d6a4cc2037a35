// Points as columns: what is stored, and that a change of order keeps each point together.
#include "catch.hpp"

#include <arenite/law/linear_elastic.hpp>
#include <arenite/particles/points.hpp>

using namespace arenite;

namespace {

/// A law with two scalars of history, which counts its updates.
struct Counting {
  template <class T>
  struct History {
    T updates = T(7), sum = T(0);
    auto members() { return std::tie(updates, sum); }
    auto members() const { return std::tie(updates, sum); }
  };
  double density() const { return 1; }
  double wave_modulus() const { return 1; }
  template <class T, int D>
  T update(Sym<T, D>&, const StrainStep<T, D>&, History<T>& h) const {
    h.updates += 1;
    return T(0);
  }
  template <class T, int D>
  T elastic_energy(const Sym<T, D>&) const {
    return T(0);
  }
};

/// Bytes that the columns of n points really take.
template <class P>
std::size_t bytes(const P& points) {
  std::size_t sum = 0;
  points.for_each_column([&](const auto& column) { sum += column.size() * sizeof(column[0]); });
  return sum;
}

}  // namespace

TEST_CASE("bytes a point: nothing that the composition does not need") {
  // Position and velocity 2 x 2, mass, volume, 4 of stress in double, and the cell: no history, no affine
  // part.
  using Plain = Points<double, 2, LinearElastic>;
  static_assert(Plain::bytes_per_point() == (4 + 2 + 4) * 8 + 4);
  // In three dimensions with APIC: 6 + 2 + 6 + 9.
  using Apic3 = Points<double, 3, LinearElastic, ExtraColumns{.affine = true}>;
  static_assert(Apic3::bytes_per_point() == (6 + 2 + 6 + 9) * 8 + 4);
  // In float with a history of two.
  using Single = Points<float, 2, Counting>;
  static_assert(Single::bytes_per_point() == (4 + 2 + 4 + 2) * 4 + 4);
  static_assert(Plain::history_size == 0 && Single::history_size == 2);

  Plain plain;
  Apic3 apic;
  Single single;
  for (int i = 0; i < 5; ++i) {
    plain.push_back({0, 0}, {0, 0}, 1, 1, {}, 0);
    apic.push_back({0, 0, 0}, {0, 0, 0}, 1, 1, {}, 0);
    single.push_back({0, 0}, {0, 0}, 1, 1, {}, 0);
  }
  REQUIRE(bytes(plain) == 5 * Plain::bytes_per_point());
  REQUIRE(bytes(apic) == 5 * Apic3::bytes_per_point());
  REQUIRE(bytes(single) == 5 * Single::bytes_per_point());
  REQUIRE(plain.velocity_gradient.column(0).capacity() == 0);
}

TEST_CASE("history starts as the law says, and is stored by column") {
  Points<double, 2, Counting> points;
  for (int i = 0; i < 3; ++i) points.push_back({0, 0}, {0, 0}, 1, 1, {}, 0);
  REQUIRE(points.history[0] == Column<double>{7, 7, 7});
  auto h = points.load_history(1);
  REQUIRE((h.updates == 7 && h.sum == 0));
  h.updates = 9;
  h.sum = -1;
  points.store_history(1, h);
  REQUIRE(points.history[0] == Column<double>{7, 9, 7});
  REQUIRE(points.history[1] == Column<double>{0, -1, 0});
  REQUIRE(points.load_history(1).sum == -1);
}

TEST_CASE("a new order keeps each point together and drops those not named") {
  Points<double, 3, Counting, ExtraColumns{.affine = true}> points;
  for (Index i = 0; i < 6; ++i) {
    const double v = i;
    points.push_back(Vec<double, 3>::Constant(v), Vec<double, 3>::Constant(10 + v), 20 + v, 30 + v,
                     {{40 + v, 0, 0, 0, 0, v}}, 50 + i);
    points.store_history(i, {60 + v, 70 + v});
    points.velocity_gradient.set(i, Mat<double, 3>::Constant(80 + v));
  }
  points.reorder({4, 0, 5});
  REQUIRE(points.size() == 3);
  const std::array<double, 3> was{4, 0, 5};
  for (std::size_t p = 0; p < 3; ++p) {
    const double v = was[p];
    REQUIRE(points.position[p] == Vec<double, 3>::Constant(v));
    REQUIRE(points.velocity[p] == Vec<double, 3>::Constant(10 + v));
    REQUIRE((points.mass[p] == 20 + v && points.volume[p] == 30 + v));
    REQUIRE((points.stress[p][0] == 40 + v && points.stress[p][5] == v));
    REQUIRE(points.cell[p] == 50 + static_cast<Index>(v));
    REQUIRE((points.history[0][p] == 60 + v && points.history[1][p] == 70 + v));
    REQUIRE(points.velocity_gradient[p] == Mat<double, 3>::Constant(80 + v));
  }
}
