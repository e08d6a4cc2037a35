// The state of a scene in an HDF5 file: as in run/saved_state.hpp, for other programs to read too.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>
#include <filesystem>
#include <string>
#include <utility>

#include <arenite/io/state_hdf5.hpp>
#include <arenite/run/saved_state.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Where a state is saved as HDF5, and what made the scene: `SavedState` in the other container.
struct Hdf5State {
  std::filesystem::path path;
  std::string recipe{};

  explicit Hdf5State(std::filesystem::path file, std::string made_by = {})
      : path(std::move(file)), recipe(std::move(made_by)) {}
};

/// Saves the state of a scene and of observers: `save_state(scene, Hdf5State{"column.h5"}, watch)`. As safe,
/// and with the same errors, as the other one.
template <class Scene, std::same_as<Hdf5State> To, class... Observers>
void save_state(const Scene& scene, const To& to, const Observers&... observers) {
  write_state_hdf5(to.path, detail::state_terms(scene, to.recipe),
                   state_slots(state_owner(scene), state_owner(observers)...));
}

/// Puts a state that was saved as HDF5 into a scene of the same recipe: the same bits, and the same refusals,
/// as from the other one.
template <class Scene, std::same_as<Hdf5State> From, class... Observers>
void restore_state(Scene& scene, const From& from, Observers&... observers) {
  detail::restore_from(StateHdf5(from.path), scene, detail::state_terms(scene, from.recipe), observers...);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
