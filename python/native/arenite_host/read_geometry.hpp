// Shapes by name: a host's word for a shape becomes a signed distance and a region.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <arenite/fill/region.hpp>
#include <arenite/fill/regions.hpp>
#include <arenite/geometry/cone_cylinder.hpp>
#include <arenite/geometry/signed_distance.hpp>
#include <arenite_host/read_functions.hpp>

#ifndef ARENITE_HOST_ELSEWHERE
#include <arenite/geometry/box.hpp>
#include <arenite/geometry/contact_segment.hpp>
#include <arenite/geometry/placed.hpp>
#include <arenite/geometry/polygon.hpp>
#include <arenite/geometry/shape.hpp>
#include <arenite/geometry/solids.hpp>
#include <arenite/geometry/triangle_surface.hpp>
#endif

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <>
struct ValueReader<AnyDistance> {
  static AnyDistance read(const Value&, const ReadContext&);
};
/// A shape; `{"cells": [names]}`, regions of a simplex mesh; `{"where": f}`, a test of positions.
template <>
struct ValueReader<AnyRegion> {
  static AnyRegion read(const Value&, const ReadContext&);
};

#ifndef ARENITE_HOST_ELSEWHERE

/// A shape in D dimensions whose type only its maker knows: signed distance, region, bounds, corners.
template <int D>
class HostShape {
 public:
  using Place = Vec<double, D>;

  template <class S>
  requires(!std::same_as<S, HostShape>) explicit HostShape(S shape) : box_{bounds_of<D>(shape)} {
    if constexpr (has_contact_segments<S, D>) segments_ = [shape] { return contact_segments_of<D>(shape); };
    if constexpr (requires { shape.contains(Place()); })
      contains_ = [shape](const Place& x) -> bool { return shape.contains(x); };
    else
      contains_ = [shape](const Place& x) { return shape(x) < 0; };
    distance_ = [s = std::move(shape)](const Place& x) -> double { return s(x); };
  }

  double operator()(const Place& x) const { return distance_(x); }
  bool contains(const Place& x) const { return contains_(x); }
  Box<std::size_t{D}> bounds() const { return box_; }
  std::vector<ContactSegment> contact_segments() const {
    return segments_ ? segments_() : std::vector<ContactSegment>{};
  }

 private:
  std::function<double(const Place&)> distance_;
  std::function<bool(const Place&)> contains_;
  std::function<std::vector<ContactSegment>()> segments_;
  Box<std::size_t{D}> box_;
};

namespace detail {

/// A function of the host as a signed distance: called for one position at a time.
template <int D>
struct HostDistance {
  HostFunction f;
  double operator()(const Vec<double, D>& x) const {
    return call_row<1>(f, {x.data(), x.data() + D}, "distance")[0];
  }
};

template <int D>
HostShape<D> read_shape(const Value& value, const ReadContext& at);

/// The two shapes that `{"a": .., "b": ..}` joins.
template <int D, class Rule>
HostShape<D> read_combined(const Value& value, const ReadContext& at) {
  return HostShape<D>(Combined<HostShape<D>, HostShape<D>, Rule>{read_shape<D>(*value.find("a"), at),
                                                                 read_shape<D>(*value.find("b"), at)});
}

inline TriangleData read_triangles(const Value& value) {
  const Value *vertices = value.find("vertices"), *triangles = value.find("triangles");
  if (!vertices || !vertices->array() || vertices->array()->columns() != 3)
    throw error("TriangleSurface.vertices: must be an array of three columns");
  if (!triangles || !triangles->array() || triangles->array()->columns() != 3)
    throw error("TriangleSurface.triangles: must be an array of three columns");
  TriangleData data;
  const auto &x = vertices->array()->numbers, &t = triangles->array()->numbers;
  for (std::size_t k = 0; k + 2 < x.size(); k += 3) data.vertices.push_back({x[k], x[k + 1], x[k + 2]});
  for (std::size_t k = 0; k + 2 < t.size(); k += 3) {
    auto& corners = data.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      require(t[k + i] >= 0 && t[k + i] < static_cast<double>(data.vertices.size()),
              "TriangleSurface.triangles", t[k + i], "must be the number of a vertex");
      corners[i] = static_cast<Index>(t[k + i]);
    }
  }
  return data;
}

/// `{"shape": "Box", "lower": .., "upper": ..}` and the like; a function is a signed distance.
template <int D>
HostShape<D> read_shape(const Value& value, const ReadContext& at) {
  constexpr auto dim = static_cast<std::size_t>(D);
  using Place = std::array<double, dim>;
  if (value.function()) return HostShape<D>(HostDistance<D>{*value.function()});
  const Value* kind = value.find("shape");
  const std::string shape = kind ? read<std::string>(*kind, at) : "";
  const auto given = [&](const char* key) -> const Value& {
    const Value* v = value.find(key);
    if (v == nullptr) throw error(joined_text({shape, ".", key, " = nothing: must be given"}));
    return *v;
  };
  const auto place = [&](const char* key) {
    const auto x = numbers(given(key), at.renamed(shape + "." + key));
    if (x.size() != dim)
      at.renamed(shape + "." + key)
          .refuse(given(key), joined_text({"must be ", D, " numbers in this scene"}));
    Place here;
    std::ranges::copy(x, here.begin());
    return here;
  };
  const auto number = [&](const char* key) {
    return read<double>(given(key), at.renamed(shape + "." + key));
  };
  if (shape == "Box") return HostShape<D>(Box<dim>{place("lower"), place("upper")});
  if (shape == "Ball") return HostShape<D>(Ball<dim>(place("centre"), number("radius")));
  if (shape == "RoundedBox")
    return HostShape<D>(RoundedBox<dim>(Box<dim>{place("lower"), place("upper")}, number("radius")));
  if (shape == "Capsule") return HostShape<D>(Capsule<dim>(place("a"), place("b"), number("radius")));
  if (shape == "ConeCylinder") return HostShape<D>(read<ConeCylinder>(given("parameters"), at));
  if (shape == "Placed")
    return HostShape<D>(Placed<HostShape<D>>(read_shape<D>(given("of"), at),
                                             read<Placement>(given("placement"), at.renamed("Placement"))));
  if (shape == "Union") return read_combined<D, InEither>(value, at);
  if (shape == "Intersection") return read_combined<D, InBoth>(value, at);
  if (shape == "Difference") return read_combined<D, InFirst>(value, at);
  if constexpr (D == 2) {
    if (shape == "Polygon")
      return HostShape<D>(
          Polygon(read<std::vector<std::array<double, 2>>>(given("corners"), at.renamed("Polygon.corners"))));
  } else {
    if (shape == "Cylinder") return HostShape<D>(Cylinder<dim>(place("a"), place("b"), number("radius")));
    if (shape == "TriangleSurface") return HostShape<D>(TriangleSurface(read_triangles(value)));
  }
  at.refuse(
      shape.empty() ? value : Value(shape),
      joined_text({"must be a shape in ", D, " dimensions: Box, Ball, RoundedBox, Capsule, ConeCylinder, ",
                   D == 2 ? "Polygon" : "Cylinder, TriangleSurface"}));
}

}  // namespace detail

ARENITE_READER AnyDistance ValueReader<AnyDistance>::read(const Value& value, const ReadContext& at) {
  if (at.dimension == 2) return AnyDistance::of<2>(detail::read_shape<2>(value, at));
  return AnyDistance::of<3>(detail::read_shape<3>(value, at));
}
ARENITE_READER AnyRegion ValueReader<AnyRegion>::read(const Value& value, const ReadContext& at) {
  AnyRegion region;
  if (const Value* cells = value.find("cells")) {
    region.cells = arenite::read<std::vector<std::string>>(*cells, at);
    return region;
  }
  if (const Value* where = value.find("where"); where && where->function()) {
    auto test = std::make_shared<BatchedFunction<1>>(at.of_places(*where->function()), at.dimension, at.name);
    if (at.places)
      at.places->where.push_back(test);
    else
      test->compute();
    region.test = [test](const AnyRegion::Position& x) { return (*test)(x)[0] != 0; };
    region.by_centres = true;
    return region;
  }
  if (at.dimension == 2) return AnyRegion::of<2>(detail::read_shape<2>(value, at));
  return AnyRegion::of<3>(detail::read_shape<3>(value, at));
}

#endif

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
