// Scene points: points of a body of a scene, by its number, that a host adds, removes and probes between
// two steps.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/observe/probe.hpp>
#include <arenite/observe/section.hpp>
#include <arenite/scene/insert_remove.hpp>
#include <arenite_host/hosted_scene.hpp>
#include <arenite_host/read_fill.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::detail {

/// Calls `f(body)` for a body of a scene.
template <class Scene, class F>
void with_body(Scene& scene, std::size_t number, F&& f) {
  require(number < scene.number_of_bodies(), "body", number, {"must be below ", scene.number_of_bodies()});
  std::size_t next = 0;
  scene.for_each_body([&](auto& body, const auto&) {
    if (next++ == number) f(body);
  });
}

/// Rows of numbers that a host gives under a name, one a point; empty if it gives none.
class PointTable {
 public:
  PointTable(const Value& values, const std::string& name, std::size_t rows, std::size_t columns)
      : columns_{columns} {
    const Value* given = values.find(name);
    if (given == nullptr || given->is_none()) return;
    const HostArray* array = given->array();
    if (array == nullptr || array->rows() != rows || array->numbers.size() != rows * columns)
      throw error(joined_text({name, " = ", given->text(), ": must be ", rows, " rows of ", columns}));
    array_ = array;
  }
  explicit operator bool() const { return array_ != nullptr; }
  double operator()(std::size_t row, std::size_t column = 0) const {
    return array_->numbers[row * columns_ + column];
  }

 private:
  const HostArray* array_ = nullptr;
  std::size_t columns_;
};

/// Gives points the rows of "history": arrays [n] by the names of the law's.
template <class Point>
void read_history(const Value& values, std::vector<Point>& points) {
  const Value* given = values.find("history");
  if (given == nullptr || given->is_none()) return;
  constexpr auto& names = history_names<decltype(Point{}.history)>;
  const auto* rows = given->get<Value::Dict>();
  require(rows != nullptr, "history", given->text(), "must be arrays by name");
  for (const auto& [name, row] : *rows) {
    const auto k = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    require(!name.empty() && k < names.size(), "history", name, "is no number of the law's history");
    const PointTable row_of(*given, name, points.size(), 1);
    for (std::size_t p = 0; p < points.size(); ++p)
      std::apply(
          [&](auto&... member) {
            std::size_t at = 0;
            ((at++ == k ? void(member = static_cast<std::remove_cvref_t<decltype(member)>>(row_of(p)))
                        : void()),
             ...);
          },
          points[p].history.members());
  }
}

/// Points of a body out of rows: "position" [n, D] and "volume" [n], and of "velocity" [n, D], "mass" [n],
/// "stress" [n, 4 or 6] and "history", arrays [n] by name, those that are given.
template <class B>
std::vector<typename B::Point> read_points(const Value& values) {
  using Point = typename B::Point;
  using T = std::remove_cvref_t<decltype(Point{}.volume)>;
  constexpr auto D = static_cast<std::size_t>(decltype(Point{}.position)::RowsAtCompileTime);
  const Value* place = values.find("position");
  require(place != nullptr && place->array() != nullptr, "position", place ? place->text() : "nothing",
          "must be an array");
  std::vector<Point> points(place->array()->rows());
  const auto rows = [&](const char* name, std::size_t columns) {
    return PointTable(values, name, points.size(), columns);
  };
  const auto position = rows("position", D), velocity = rows("velocity", D), volume = rows("volume", 1),
             mass = rows("mass", 1), stress = rows("stress", Point{}.stress.c.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    Point& point = points[p];
    for (std::size_t k = 0; k < D; ++k) {
      const auto i = static_cast<int>(k);
      point.position[i] = static_cast<T>(position(p, k));
      if (velocity) point.velocity[i] = static_cast<T>(velocity(p, k));
    }
    if (volume) point.volume = static_cast<T>(volume(p));
    if (mass) point.mass = static_cast<T>(mass(p));
    for (std::size_t k = 0; stress && k < point.stress.c.size(); ++k)
      point.stress.c[k] = static_cast<T>(stress(p, k));
  }
  read_history(values, points);
  return points;
}

template <int D>
HostedTotals hosted(const PointTotals<D>& totals) {
  return {totals.count,
          totals.mass,
          {totals.momentum.begin(), totals.momentum.end()},
          totals.kinetic_energy,
          totals.strain_energy};
}

/// Calls `f(body)`, which changes the points of a body and returns their totals.
template <class Scene, class F>
HostedTotals change_points(Scene& scene, std::size_t body, F&& f) {
  HostedTotals totals;
  with_body(scene, body, [&](auto& of) { totals = hosted(f(of)); });
  return totals;
}

/// Fills a region of a running scene with points of a body: see `insert_points`. `value`: as that of a fill; `memory`: of a tile.
template <class Scene>
HostedTotals fill_more(Scene& scene, std::size_t body, const Value& value, PlaceMemory* memory = nullptr) {
  return change_points(scene, body, [&](auto& of) {
    using Recipe = Fill<std::remove_cvref_t<decltype(of.law)>>;
    const ReadContext at{.name = "fill", .dimension = Scene::D, .memory = memory};
    return insert_fill(scene, of, read_fill<Scene, Recipe>(scene.mesh, value, at, scene.cell_owner()),
                       Scene::body_name(body));
  });
}

/// Adds points to a body: see `read_points`.
template <class Scene>
HostedTotals insert_rows(Scene& scene, std::size_t body, const Value& values) {
  return change_points(scene, body, [&](auto& of) {
    return insert_given(scene, of, read_points<std::remove_cvref_t<decltype(of)>>(values));
  });
}

/// Removes points of a body. `where`: a region, or numbers [n], one a point, that are not 0 for those to go.
template <class Scene>
HostedTotals remove_where(Scene& scene, std::size_t body, const Value& where) {
  return change_points(scene, body, [&](auto& of) {
    const auto& points = of.points;
    if (const HostArray* flags = where.array()) {
      require(flags->numbers.size() == points.size(), "where", where.text(),
              {"must have one for each of ", points.size(), " points"});
      return remove_from(scene, of, [&](Index p) { return flags->numbers[p] != 0; });
    }
    const auto region = read<AnyRegion>(where, ReadContext{.name = "where", .dimension = Scene::D});
    const auto numbers = region_numbers(scene.mesh, region);
    return remove_from(scene, of, [&](Index p) {
      if (region.test) return region.contains(points.position[p]);
      if constexpr (is_simplex_mesh<typename Scene::Mesh>)
        return scene.mesh.is_in(points.cell[p], numbers);
      else
        return false;
    });
  });
}

/// Velocity [n x D] and stress [n x 4 or 6] of a body at places [n x D]; NaN where there is no matter.
template <class Scene>
HostedProbes probe_places(const Scene& scene, std::size_t body, const std::vector<double>& places) {
  HostedProbes found;
  with_body(scene, body, [&](const auto& of) {
    for (std::size_t k = 0; k + Scene::D <= places.size(); k += Scene::D) {
      std::array<double, 3> place{};
      std::copy_n(places.begin() + static_cast<std::ptrdiff_t>(k), Scene::D, place.begin());
      const auto here = probe(scene, of, place);
      const auto add = [&](std::vector<double>& to, const auto& numbers) {
        for (const double x : numbers) to.push_back(here ? x : std::numeric_limits<double>::quiet_NaN());
      };
      const Probed<Scene::D> nothing{};
      add(found.velocity, here ? here->velocity : nothing.velocity);
      add(found.stress, here ? here->stress.c : nothing.stress.c);
    }
  });
  return found;
}

/// Force [D] across a section of a body, N: of the stresses of its points, or of its nodes' internal forces.
template <class Scene>
std::vector<double> force_across(const Scene& scene, std::size_t body, const Value& section, bool of_nodes) {
  std::vector<double> force;
  with_body(scene, body, [&](const auto& of) {
    const auto cut = read<Section>(section, ReadContext{.name = "Section", .dimension = Scene::D});
    const auto f = of_nodes ? nodal_section_force(scene, of, cut) : section_force(scene, of, cut);
    force.assign(f.begin(), f.end());
  });
  return force;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::detail
