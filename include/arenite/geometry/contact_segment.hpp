// Contact segments: where a shape can touch another first, corners and edges, rounded by a radius.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <concepts>
#include <cstddef>
#include <vector>

#include <arenite/geometry/box.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// All positions within `radius`, m, of the line from `a` to `b`, m, (x, y, z), z = 0 in the plane. A corner
/// has a = b; a sharp one has no radius. A ball is one corner with its radius. The ends of
/// an edge are listed as corners, too.
///
/// A shape offers `contact_segments()` (`contact_segments<D>()` where it serves both dimensions): all of its
/// convex corners, in space also its convex edges. Another shape touches it at one of these, or with one of
/// its own. A shape with none, like a user's signed distance, is touched only by the segments of other shapes.
struct ContactSegment {
  std::array<double, 3> a, b;
  double radius = 0;
};

/// Corners of a box, and in space its edges, rounded by a radius.
template <std::size_t D>
std::vector<ContactSegment> contact_segments_of_box(const Box<D>& box, double radius) {
  std::vector<ContactSegment> all;
  const auto corner = [&](std::size_t number) {
    std::array<double, 3> x{};
    for (std::size_t k = 0; k < D; ++k) x[k] = (number >> k & 1) != 0 ? box.upper[k] : box.lower[k];
    return x;
  };
  for (std::size_t c = 0; c < std::size_t{1} << D; ++c) {
    all.push_back({corner(c), corner(c), radius});
    if constexpr (D == 3)
      for (std::size_t k = 0; k < D; ++k)
        if ((c >> k & 1) == 0) all.push_back({corner(c), corner(c | std::size_t{1} << k), radius});
  }
  return all;
}

template <class S, int D>
concept has_contact_segments = std::same_as<S, Box<std::size_t{D}>> || requires(const S shape) {
  shape.template contact_segments<D>();
} || requires(const S shape) {
  shape.contact_segments();
};

template <int D, class S>
std::vector<ContactSegment> contact_segments_of(const S& shape) {
  if constexpr (std::same_as<S, Box<std::size_t{D}>>)
    return contact_segments_of_box(shape, 0);
  else if constexpr (requires { shape.template contact_segments<D>(); })
    return shape.template contact_segments<D>();
  else
    return shape.contact_segments();
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
