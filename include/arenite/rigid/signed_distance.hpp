// Signed distance of any type, as one value: what a scene keeps of a `DistanceSurface`, so that its own type
// does not depend on the body's shape.
#pragma once

#include <array>
#include <concepts>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include <arenite/core/tensor.hpp>
#include <arenite/core/vector_argument.hpp>
#include <arenite/particles/region.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Callable with a position [D], m: the distance to the body, m, negative inside. It is called from several
/// threads at once. Optional `bounds()`, or `bounds<D>()` where it serves both dimensions: a `Box<D>` around
/// the body; outside of it the distance must not be smaller than that to the box.
template <class F, int D>
concept signed_distance = requires(const F f, const Vec<double, D> x) {
  { f(x) } -> std::convertible_to<double>;
};

/// A signed distance whose type is not known; made by `AnyDistance::of<D>`. Positions are (x, y, z), z = 0 in
/// two dimensions.
class AnyDistance {
 public:
  using Position = std::array<double, 3>;

  template <int D, class F>
  static AnyDistance of(F distance) {
    AnyDistance any;
    if constexpr (requires { distance.template bounds<D>(); })
      any.set_bounds(distance.template bounds<D>());
    else if constexpr (requires { distance.bounds(); })
      any.set_bounds(distance.bounds());
    any.at_ = [f = std::move(distance)](std::span<const Position> x, double* out) {
      for (const Position& p : x) *out++ = f(in_scene<D>(p));
    };
    return any;
  }

  /// Distances at some positions: one call for a block of them.
  void at(std::span<const Position> x, double* out) const { at_(x, out); }
  /// Corners of a box around the body, m; infinite where nothing is known.
  const Position& lower() const { return lower_; }
  const Position& upper() const { return upper_; }

 private:
  template <std::size_t D>
  void set_bounds(const Box<D>& box) {
    for (std::size_t k = 0; k < D; ++k) {
      lower_[k] = box.lower[k];
      upper_[k] = box.upper[k];
    }
  }

  static constexpr double far = std::numeric_limits<double>::infinity();
  std::function<void(std::span<const Position>, double*)> at_{};
  Position lower_{-far, -far, -far}, upper_{far, far, far};
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
