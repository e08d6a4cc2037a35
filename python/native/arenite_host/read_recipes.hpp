// Recipes of a scene out of a host's values: those that are no plain aggregates.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/arenite.hpp>
#include <arenite/mesh/mesh_data.hpp>
#include <arenite_host/read_geometry.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// An angle, rad; infinity: no slip.
template <>
struct ValueReader<Friction> {
  static Friction read(const Value&, const ReadContext&);
};
template <>
struct ValueReader<BodyName> {
  static BodyName read(const Value&, const ReadContext&);
};
template <>
struct ValueReader<Inertia> {
  static Inertia read(const Value&, const ReadContext&);
};
template <>
struct ValueReader<SurfaceLoad> {
  static SurfaceLoad read(const Value&, const ReadContext&);
};
/// As many numbers as the scene has dimensions.
template <>
struct ValueReader<Gravity> {
  static Gravity read(const Value&, const ReadContext&);
};
template <>
struct ValueReader<Prescribed> {
  static Prescribed read(const Value&, const ReadContext&);
};
template <class N>
struct ValueReader<Coulomb<N>> {
  struct Given {
    Friction friction;
    N normals;
    double velocity_limit;
  };
  static Coulomb<N> read(const Value& value, const ReadContext&) {
    const ReadContext at{.name = "Coulomb"};
    const auto given = arenite::read<Given>(value, at);
    return Coulomb<N>(given.friction, given.normals, given.velocity_limit);
  }
};

// --- laws

template <>
struct ValueReader<LinearElastic> {
  static LinearElastic read(const Value&, const ReadContext&);
};

namespace detail {

/// A frictional law: its parameters, and its policies by their names.
template <class Law, class Parameters, class Memory, class Friction, class Stiffness>
Law read_frictional(const Value& value, const char* name) {
  const ReadContext at{.name = name};
  Value::Dict given = dict(value, at);
  Value::Dict policies;
  for (const char* key : {"memory", "friction_law", "stiffness_law"})
    if (auto node = given.extract(key)) policies.insert(std::move(node));
  const auto policy = [&](const char* key) { return policies.contains(key) ? policies.at(key) : Value(); };
  return Law(read<Parameters>(given, at), read<Memory>(policy("memory"), at / "memory"),
             read<Friction>(policy("friction_law"), at / "friction_law"),
             read<Stiffness>(policy("stiffness_law"), at / "stiffness_law"));
}

}  // namespace detail

template <class M, class F, class S>
struct ValueReader<MohrCoulomb<M, F, S>> {
  static MohrCoulomb<M, F, S> read(const Value& value, const ReadContext&) {
    return detail::read_frictional<MohrCoulomb<M, F, S>, MohrCoulombParameters, M, F, S>(value,
                                                                                         "MohrCoulomb");
  }
};
template <class M, class F, class S>
struct ValueReader<DruckerPrager<M, F, S>> {
  static DruckerPrager<M, F, S> read(const Value& value, const ReadContext&) {
    return detail::read_frictional<DruckerPrager<M, F, S>, DruckerPragerParameters, M, F, S>(value,
                                                                                             "DruckerPrager");
  }
};
template <class L>
struct ValueReader<ByPoint<L>> {
  static ByPoint<L> read(const Value& value, const ReadContext& at) {
    return ByPoint<L>(arenite::read<L>(value, at));
  }
};
template <class L, int D>
struct ValueReader<WithDeviatoricStrain<L, D>> {
  static WithDeviatoricStrain<L, D> read(const Value& value, const ReadContext& at) {
    return WithDeviatoricStrain<L, D>(arenite::read<L>(value, at));
  }
};

// --- meshes

/// A box with as many components as the mesh has dimensions.
template <int D, class T>
struct ValueReader<CartesianGrid<D, T>> {
  static CartesianGrid<D, T> read(const Value& value, const ReadContext&) {
    const ReadContext at{.name = "CartesianGrid", .dimension = D};
    for (const char* corner : {"lower", "upper"})
      if (const Value* x = value.find(corner))
        if (detail::numbers(*x, at / corner).size() != D)
          (at / corner).refuse(*x, joined_text({"must be ", D, " numbers in this scene"}));
    return CartesianGrid<D, T>(arenite::read<typename CartesianGrid<D, T>::Parameters>(value, at));
  }
};
template <class Grid, int Axes>
struct ValueReader<PeriodicGrid<Grid, Axes>> {
  static PeriodicGrid<Grid, Axes> read(const Value& value, const ReadContext& at) {
    return PeriodicGrid<Grid, Axes>(arenite::read<Grid>(value, at));
  }
};
/// `{"nodes": [n, D], "cells": [m, D + 1], "region": [m], "region_names": {..}, "shared_regions": {..},
/// "node_sets": {..}}`
template <int D>
struct ValueReader<MeshData<D>> {
  static MeshData<D> read(const Value& value, const ReadContext& at) {
    MeshData<D> data;
    const HostArray nodes = table(value, "nodes", D, at), cells = table(value, "cells", D + 1, at);
    for (std::size_t i = 0; i < nodes.rows(); ++i) {
      Vec<double, D> x;
      for (int k = 0; k < D; ++k) x[k] = nodes.numbers[i * D + static_cast<std::size_t>(k)];
      data.nodes.push_back(x);
    }
    for (std::size_t c = 0; c < cells.rows(); ++c) {
      std::array<Index, D + 1> cell;
      for (std::size_t k = 0; k < D + 1; ++k) cell[k] = index(cells.numbers[c * (D + 1) + k], at / "cells");
      data.cells.push_back(cell);
    }
    if (const Value* region = value.find("region"); region && !region->is_none())
      for (const double r : detail::numbers(*region, at / "region"))
        data.region.push_back(static_cast<int>(r));
    if (const Value* names = value.find("region_names"))
      data.region_names = arenite::read<Map<std::string, int>>(*names, at / "region_names");
    if (const Value* shared = value.find("shared_regions"))
      for (const auto& [name, regions] : detail::dict(*shared, at / "shared_regions"))
        for (const double r : detail::numbers(regions, at / "shared_regions" / name))
          data.shared_regions[name].push_back(static_cast<int>(r));
    if (const Value* sets = value.find("node_sets"))
      for (const auto& [name, nodes_of] : detail::dict(*sets, at / "node_sets")) {
        auto& set = data.node_sets[name];
        for (const double i : detail::numbers(nodes_of, at / "node_sets" / name))
          set.push_back(index(i, at / "node_sets" / name));
        std::ranges::sort(set);
        set.erase(std::unique(set.begin(), set.end()), set.end());
      }
    return data;
  }

 private:
  static HostArray table(const Value& value, const char* key, std::size_t columns, const ReadContext& at) {
    const Value* found = value.find(key);
    const HostArray* a = found ? found->array() : nullptr;
    if (a == nullptr || a->shape.size() != 2 || a->columns() != columns)
      (at / key).refuse(found ? *found : Value(), joined_text({"must be an array of ", columns, " columns"}));
    return *a;
  }
  static Index index(double number, const ReadContext& at) {
    require(number >= 0 && number < static_cast<double>(none) && number == std::floor(number), at.name,
            number, "must be the number of a node");
    return static_cast<Index>(number);
  }
};
/// The arrays of a `MeshData`.
template <int D, class T>
struct ValueReader<SimplexMesh<D, T>> {
  static SimplexMesh<D, T> read(const Value& value, const ReadContext&) {
    const ReadContext at{.name = "SimplexMesh", .dimension = D};
    return SimplexMesh<D, T>(arenite::read<MeshData<D>>(value, at));
  }
};

// --- bodies and parts

template <class L, Name name>
struct ValueReader<Fill<L, name>> {
  static Fill<L, name> read(const Value& value, const ReadContext& at) {
    const auto given = [&](const char* key) { return value.find(key) ? *value.find(key) : Value(); };
    return {arenite::read<AnyRegion>(given("region"), at / "region"),
            arenite::read<L>(given("law"), at / "law"),
            arenite::read<FillOptions>(given("options"), at.renamed("FillOptions"))};
  }
};
/// It has nothing to give: what it sums begins at 0.
template <>
struct ValueReader<TrackEnergy> {
  static TrackEnergy read(const Value&, const ReadContext&);
};
/// Of lists: a value each.
template <class... P>
struct ValueReader<PartGroup<P...>> {
  static PartGroup<P...> read(const Value& value, const ReadContext& at) {
    return of(value, at, std::index_sequence_for<P...>{});
  }

 private:
  template <std::size_t... At>
  static PartGroup<P...> of(const Value& value, const ReadContext& at, std::index_sequence<At...>) {
    const auto* list = value.get<Value::List>();
    if (list == nullptr || list->size() != sizeof...(P))
      at.refuse(value, joined_text({"must be a list of ", sizeof...(P)}));
    return {{arenite::read<P>((*list)[At], at[At])...}};
  }
};

#ifndef ARENITE_HOST_ELSEWHERE

ARENITE_READER Friction ValueReader<Friction>::read(const Value& value, const ReadContext& at) {
  const double angle = arenite::read<double>(value, at);
  return std::isinf(angle) && angle > 0 ? Friction::no_slip() : Friction(angle);
}
ARENITE_READER BodyName ValueReader<BodyName>::read(const Value& value, const ReadContext& at) {
  if (const auto* word = value.get<std::string>()) return word->c_str();
  return arenite::read<std::size_t>(value, at);
}
ARENITE_READER Inertia ValueReader<Inertia>::read(const Value& value, const ReadContext& at) {
  if (const double* x = value.get<double>()) return *x;
  const auto n = detail::numbers(value, at);
  if (n.size() == 3) return {n[0], n[1], n[2]};
  if (n.size() == 6) return {n[0], n[1], n[2], n[3], n[4], n[5]};
  at.refuse(value, "must be 1, 3 or 6 numbers");
}
ARENITE_READER SurfaceLoad ValueReader<SurfaceLoad>::read(const Value& value, const ReadContext& at) {
  if (const Value* p = value.find("pressure"))
    return SurfaceLoad(arenite::read<ScalarFunction>(*p, at / "pressure"));
  if (const Value* t = value.find("traction"))
    return SurfaceLoad(arenite::read<VectorFunction>(*t, at / "traction"));
  at.refuse(value, "must be a pressure or a traction");
}
ARENITE_READER Gravity ValueReader<Gravity>::read(const Value& value, const ReadContext& at) {
  detail::refuse_unknown(detail::dict(value, at), std::array<std::string_view, 1>{"g"}, at);
  const Value* g = value.find("g");
  if (g == nullptr) return {};
  return {.g = arenite::read<Triple>(*g, at / "g"),
          .components = static_cast<int>(detail::numbers(*g, at / "g").size())};
}
ARENITE_READER Prescribed ValueReader<Prescribed>::read(const Value& value, const ReadContext& at) {
  const auto f = arenite::read<VectorFunction>(value, at.renamed("Prescribed.velocity"));
  return Prescribed([f](double time) { return f({}, time); });
}
ARENITE_READER LinearElastic ValueReader<LinearElastic>::read(const Value& value, const ReadContext& at) {
  return LinearElastic(arenite::read<LinearElasticParameters>(value, at.renamed("LinearElastic")));
}
ARENITE_READER TrackEnergy ValueReader<TrackEnergy>::read(const Value& value, const ReadContext& at) {
  detail::refuse_unknown(detail::dict(value, at), std::array<std::string_view, 0>{}, at);
  return {};
}

#endif

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
