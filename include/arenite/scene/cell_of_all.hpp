// The cell of a place that the scenes over all portions of a mesh mean.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <limits>

#include <arenite/core/scalar.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// `cell`: in which a scene has found the place, or `none`. It becomes that which all portions mean, on a cut of the
/// mesh one of several; `none` in portions that do not have it. Returns whether there is one; asked of all
/// portions.
template <class Scene>
bool find_owner_cell([[maybe_unused]] const Scene& scene, Index& cell) {
  if constexpr (Scene::is_portion) {
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    const auto& portion = scene.portion();
    const double least =
        scene.communicator().least(cell == none ? nowhere : static_cast<double>(portion.whole_cell[cell]));
    if (!(least < nowhere)) return false;
    cell = portion.find_cell(static_cast<std::uint64_t>(least));
    return true;
  } else {
    return cell != none;
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
