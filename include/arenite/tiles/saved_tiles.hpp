// Saved tiles: the state of a scene cut into tiles, a file each, from which a run resumes with the same bits on any number of ranks.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>

#include <arenite/io/output_file.hpp>
#include <arenite/run/saved_state.hpp>
#include <arenite/tiles/tiled.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The contents of FOLDER/tiles.txt: the last complete save.
struct TileList {
  int tiles = 0;         ///< of the whole, -
  std::size_t step = 0;  ///< of the scene when it was saved, -

  /// Throws `error` if it is not there, or none.
  static TileList read(const std::filesystem::path& folder) {
    const auto path = folder / "tiles.txt";
    std::error_code status;
    require(std::filesystem::exists(path, status), "saved tiles", folder.string(),
            std::filesystem::is_regular_file(folder, status)
                ? "is a file: a scene that is cut into tiles is saved to a folder"
                : "must be a folder with a file tiles.txt, and there is none");
    std::ifstream text(path);
    std::string format, word;
    TileList list;
    text >> format >> word >> list.tiles >> word >> list.step;
    require(text && format == "arenite-tiles-1" && list.tiles > 0, "saved tiles", path.string(),
            "must be a list of saved tiles");
    return list;
  }
  void write(const std::filesystem::path& folder) const {
    replace_file(folder / "tiles.txt", [&](std::ostream& out) {
      out << "arenite-tiles-1\ntiles " << tiles << "\nstep " << step << '\n';
    });
  }
  /// The file of a tile.
  std::filesystem::path file(const std::filesystem::path& folder, int tile) const {
    return folder / joined_text({"tile", tile, "_", step, ".state"});
  }
};

/// Observer that saves the tile of each scene that shows itself, FOLDER/tile3_1200.state with the number of the step, and, once all are on
/// the disk, the list of them, FOLDER/tiles.txt. A run that is killed while it saves leaves the save before. Use with `every(period,
/// save_tiles(folder))`. All ranks must see the folder.
class SavedTiles {
 public:
  /// `folder.recipe`: a line on what made the scene, as in `SavedState`.
  explicit SavedTiles(SavedState folder) : folder_{std::move(folder)} {
    make_folder_of(folder_.path / "tiles.txt", "saved tiles");
  }

  template <class Scene>
  void operator()(const Scene& scene) const {
    save(scene);
  }
  /// With what observers of the tile carry.
  template <class Scene, class... Observers>
  void save(const Scene& scene, const Observers&... observers) const {
    static_assert(Scene::is_portion, "save_tiles: the scene is whole: save_state");
    const int tile = scene.portion().number;
    const auto steps = static_cast<double>(scene.steps);
    const double least = scene.communicator().least(steps), most = -scene.communicator().least(-steps);
    require(least == most, "saved tiles: steps", least,
            {"must be those of all tiles, and some have made ", most,
             ": a step has failed in the middle; restore an earlier state"});
    const TileList list{scene.communicator().size(), scene.steps};
    save_state(scene, {list.file(folder_.path, tile), folder_.recipe}, observers...);
    scene.communicator().least(0);  // all are written
    if (scene.communicator().first()) list.write(folder_.path);
    scene.communicator().least(0);  // the list names the new ones: the old ones may go
    const std::string own = joined_text({"tile", tile, "_"}), kept = list.file("", tile).string();
    std::error_code status;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path, status)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(own) && name.ends_with(".state") && name != kept)
        std::filesystem::remove(entry.path(), status);
    }
  }

 private:
  SavedState folder_;
};
inline SavedTiles save_tiles(SavedState folder) { return SavedTiles(std::move(folder)); }

namespace detail {
inline void agree_on_folder(Ranks& ranks, const char* asks, const SavedState& folder) {
  ranks.agree(Question{asks}.with("folder", folder.path.string()).with("recipe", folder.recipe));
}
}  // namespace detail

/// Saves all tiles to a folder now.
template <class S>
void save_state(Tiled<S>& tiled, const SavedState& folder) {
  detail::agree_on_folder(tiled.ranks(), "saving its tiles", folder);
  const SavedTiles saver(folder);
  tiled.together([&](S& scene) { saver(std::as_const(scene)); });
}

namespace detail {
/// Waits, among observers that are restored, until all tiles are; if one is refused, all get back what they had.
struct AllRestored {
  template <class F>
  void visit_state(F&&) {}
  template <class S>
  void follow_state(const S& scene) {
    scene.communicator().least(0);
  }
};

/// `carried(scene)`: what was saved with each tile beside its state.
template <class S, class... Carried>
void restore_tiles(Tiled<S>& tiled, const SavedState& folder, Carried&&... carried) {
  agree_on_folder(tiled.ranks(), "restoring its tiles", folder);
  TileList list;
  std::string refused;
  try {
    list = TileList::read(folder.path);
    require(list.tiles == tiled.tiles(), "saved tiles", list.tiles,
            {"must be as many as those of the scene, ", tiled.tiles()});
  } catch (const error& e) {
    refused = e.what();
  }
  if (tiled.ranks().least(refused.empty() ? 1 : 0) == 0)  // all refuse, and remain as they were
    throw error(refused.empty() ? "saved tiles: another rank cannot read the list of them" : refused);
  tiled.together([&](S& scene) {
    AllRestored all;
    restore_state(scene, SavedState(list.file(folder.path, scene.portion().number), folder.recipe),
                  carried(scene)..., all);
  });
}
}  // namespace detail

/// Puts the state of a folder into the tiles of the same mesh, cut alike, on any number of ranks. Throws `error` on all ranks for a folder of
/// other tiles, and what `restore_state` throws, with all tiles as they were.
template <class S>
void restore_state(Tiled<S>& tiled, const SavedState& folder) {
  detail::restore_tiles(tiled, folder);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
