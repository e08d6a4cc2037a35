// Regions: where to put points. A box, a signed distance, the cells of a mesh region, or any test of a
// position.
#pragma once

#include <array>
#include <concepts>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>
#include <arenite/core/vector_argument.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Axis-aligned box: lower <= x < upper, m.
template <std::size_t D>
struct Box {
  std::array<double, D> lower;
  std::array<double, D> upper;
  bool contains(const Vec<double, static_cast<int>(D)>& x) const {
    for (std::size_t k = 0; k < D; ++k)
      if (!(x[static_cast<int>(k)] >= lower[k] && x[static_cast<int>(k)] < upper[k])) return false;
    return true;
  }
  template <int Other>
  bool contains(const Vec<double, Other>& x) const = delete;  // a box of another dimension
};
template <std::size_t D>
Box(const double (&)[D], const double (&)[D]) -> Box<D>;

/// Where a signed distance (negative inside) is negative. `Distance`: callable with a position, m.
template <class Distance>
struct Inside {
  Distance distance;
  template <int D>
  bool contains(const Vec<double, D>& x) const {
    return distance(x) < 0;
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

/// `Cells`, or any class with `bool contains(const Vec<double, D>& x) const`, x in m. Members `lower` and
/// `upper` [D], m, are its bounds, of which a new scene warns if they reach beyond the mesh.
template <class R, int D>
concept region_type = std::same_as<R, Cells> || requires(const R r, const Vec<double, D> x) {
  { r.contains(x) } -> std::convertible_to<bool>;
};

/// A region with its type erased, made by `AnyRegion::of<D>`; scenes are filled from it. Positions are
/// (x, y, z), z = 0 in two dimensions.
struct AnyRegion {
  using Position = std::array<double, 3>;
  std::function<bool(const Position&)> test{};  ///< none: the region is `cells`
  std::vector<std::string> cells{};             ///< regions of the mesh
  bool has_bounds = false;                      ///< whether the region told `lower` and `upper`, m
  Position lower{}, upper{};

  template <int D, class R>
  static AnyRegion of(R region) {
    AnyRegion any;
    if constexpr (std::same_as<R, Cells>) {
      any.cells = std::move(region.regions);
    } else {
      if constexpr (requires { region.lower[0] < region.upper[0]; }) {
        any.has_bounds = true;
        for (std::size_t k = 0; k < D; ++k) {
          any.lower[k] = region.lower[k];
          any.upper[k] = region.upper[k];
        }
      }
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
