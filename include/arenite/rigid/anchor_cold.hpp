// Cold functions of anchor.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <arenite/core/error.hpp>
#include <arenite/rigid/anchor.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

template <int D>
ARENITE_COLD BoundAnchor<D>::BoundAnchor(const Anchor& a) {
  const auto checked = [](const char* name, double value) {
    require(value >= 0 && std::isfinite(value), name, value, "must not be negative");
    return value;
  };
  for (std::size_t k = 0; k < D; ++k) {
    stiffness[static_cast<int>(k)] = checked("Free.anchor.stiffness", a.stiffness[k]);
    damping[static_cast<int>(k)] = checked("Free.anchor.damping", a.damping[k]);
  }
  for (std::size_t k = D == 2 ? 2 : 0; k < 3; ++k) {
    const int at = D == 2 ? 0 : static_cast<int>(k);
    rotational_stiffness[at] = checked("Free.anchor.rotational_stiffness", a.rotational_stiffness[k]);
    rotational_damping[at] = checked("Free.anchor.rotational_damping", a.rotational_damping[k]);
  }
}

template <int D>
ARENITE_COLD auto BoundAnchor<D>::force(const V& displacement) const -> V {
  return -stiffness.cwiseProduct(displacement);
}

template <int D>
ARENITE_COLD auto BoundAnchor<D>::moment_of_springs(const Orientation<D>& orientation) const -> S {
  const S r = orientation.rotation_vector(), pull = rotational_stiffness.cwiseProduct(r);
  if constexpr (D == 2) {
    return -pull;
  } else {
    const double angle = r.norm();
    const double c = angle < 1e-3
                         ? 1.0 / 12
                         : (1 - angle / 2 * std::cos(angle / 2) / std::sin(angle / 2)) / (angle * angle);
    return -(pull + r.cross(pull) / 2 + c * r.cross(r.cross(pull)));
  }
}

template <int D>
ARENITE_COLD double BoundAnchor<D>::stored_energy(const V& displacement,
                                                  const Orientation<D>& orientation) const {
  const S r = orientation.rotation_vector();
  return (displacement.dot(stiffness.cwiseProduct(displacement)) +
          r.dot(rotational_stiffness.cwiseProduct(r))) /
         2;
}

#define ARENITE_INSTANCES(D) template struct BoundAnchor<D>;
ARENITE_FOR_DIMENSIONS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
