// Courant numbers of steps that are named by the cell.
#pragma once

#include <algorithm>

namespace arenite::test {

/// Courant number of a step of `share` cell sizes over the wave speed, or of the largest stable one.
template <class Scene>
double courant(const Scene&, double share) {
  return std::min(1.0, share / Scene::NumericsType::template courant_limit<Scene::D>());
}

}  // namespace arenite::test
