// Regions: where to put points. A box, a signed distance, the cells of a mesh region, or any test of a
// position.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/tensor.hpp>

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
  bool contains(const Vec<double, Other>& x) const = delete;  // of another dimension
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

template <class R, int D>
concept region_type = std::same_as<R, Cells> || requires(const R r, const Vec<double, D> x) {
  { r.contains(x) } -> std::convertible_to<bool>;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
