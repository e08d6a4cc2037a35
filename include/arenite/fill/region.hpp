// Regions: where to put points. A shape, a signed distance, the cells of a mesh region, or any test of a
// position.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/geometry/shape.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Where a signed distance (negative inside) is negative. `Distance`: callable with a position, m. Throws
/// `error` where it is NaN.
template <class Distance>
struct Inside {
  Distance distance;
  template <int D>
  bool contains(const Vec<double, D>& x) const {
    const double d = distance(x);
    if (std::isnan(d))
      throw error(joined_text({"Inside.distance at ", vector_text(x), " m = nan: must be a number"}));
    return d < 0;
  }
  template <int D>
  requires(signed_distance<Distance, D>) double operator()(const Vec<double, D>& x) const {
    return distance(x);
  }
  template <int D>
  auto bounds() const {
    return bounds_of<D>(distance);
  }
};
template <class Distance>
Inside(Distance) -> Inside<Distance>;

/// All cells of the named regions of a simplex mesh.
struct Cells {
  std::vector<std::string> regions;
  explicit Cells(std::string region) : regions{std::move(region)} {}
  explicit Cells(std::vector<std::string> names) : regions{std::move(names)} {}
};

/// `Cells`, or any class with `bool contains(const Vec<double, D>& x) const`, x in m: the shapes of
/// `geometry/`, what is made of several (`fill/regions.hpp`), one of your own. Members `lower` and
/// `upper` [D], m, or `bounds()` are its bounds, of which a new scene warns if they reach beyond the mesh.
template <class R, int D>
concept region_type = std::same_as<R, Cells> || requires(const R r, const Vec<double, D> x) {
  { r.contains(x) } -> std::convertible_to<bool>;
};

/// A region with its type erased, made by `AnyRegion::of<D>`; scenes are filled from it. Positions are
/// (x, y, z), z = 0 in two dimensions.
struct AnyRegion {
  using Position = std::array<double, 3>;
  std::function<bool(const Position&)> test{};        ///< none: the region is `cells`
  std::function<double(const Position&)> distance{};  ///< signed, m; none: unknown
  bool by_centres = false;                            ///< whether `test` is only for the middles of sub-cells
  std::vector<std::string> cells{};                   ///< regions of the mesh
  bool has_bounds = false;                            ///< whether the region has finite bounds
  Position lower{}, upper{};                          ///< m

  template <int D, class R>
  static AnyRegion of(R region) {
    AnyRegion any;
    if constexpr (std::same_as<R, Cells>) {
      any.cells = std::move(region.regions);
    } else {
      const auto box = bounds_of<D>(region);
      any.has_bounds = true;
      for (std::size_t k = 0; k < D; ++k) {
        any.has_bounds = any.has_bounds && std::isfinite(box.lower[k]) && std::isfinite(box.upper[k]);
        any.lower[k] = box.lower[k];
        any.upper[k] = box.upper[k];
      }
      if constexpr (signed_distance<R, D>)
        any.distance = [region](const Position& at) -> double { return region(in_scene<D>(at)); };
      any.test = [r = std::move(region)](const Position& at) -> bool { return r.contains(in_scene<D>(at)); };
    }
    return any;
  }

  template <class T, int D>
  bool contains(const Vec<T, D>& x) const {
    return test(in_space(x));
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
