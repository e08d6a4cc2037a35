// Tiled: a scene cut into tiles, each an ordinary scene over its portion of the mesh, on one rank or dealt out to many.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/core/once.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/mesh/portion.hpp>
#include <arenite/mesh/rectilinear_grid.hpp>
#include <arenite/particles/point_ids.hpp>
#include <arenite/run/run.hpp>
#include <arenite/tiles/assign_tiles.hpp>
#include <arenite/tiles/communicator.hpp>
#include <arenite/tiles/options.hpp>
#include <arenite/tiles/split_cells.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {
/// Whether copies of an observer call the same one.
template <class Observer>
inline constexpr bool shares_observer = [] {
  if constexpr (requires { Observer::refers; }) return Observer::refers;
  return false;
}();
/// Refused by the compiler: tiles that would call one observer at once.
template <class... Observers>
constexpr void check_observers() {
  constexpr bool apart = (!shares_observer<std::remove_cvref_t<Observers>> && ...);
  static_assert(apart,
                "run: each tile needs an observer of its own: give `every` one that is no variable, "
                "every(0.1, vtu(..))");
}
template <class S>
class TileMaker;

inline Question question_of(const RunOptions& options) {
  return Question{"a run"}
      .with("end", options.end)
      .with("courant", options.courant)
      .with("max_step", options.max_step)
      .with("watch", options.watch);
}
}  // namespace detail

/// The tiles of a scene that this rank has (`distribute` makes them). They are stepped at once, each by its own thread.
template <class S>
class Tiled {
 public:
  using Scene = S;
  static constexpr int D = S::D;

  Tiled(Tiled&&) = default;
  Tiled& operator=(Tiled&&) = default;

  /// Tiles of the whole; of this rank.
  int tiles() const { return all_->size(); }
  std::size_t tiles_here() const { return here_.size(); }
  Ranks& ranks() const { return all_->ranks(); }
  const LocalTiles& shared() const { return *all_; }
  /// s, and number of steps; the same of all tiles.
  double time() const { return first().time; }
  std::size_t steps() const { return first().steps; }
  /// The first tile here.
  const S& first() const { return *here_.front().scene; }

  /// Calls `f(scene)` for each tile here, one after another: it must not use the communicator.
  template <class F>
  void for_each_tile(F&& f) {
    for (const auto& tile : here_) f(*tile.scene);
  }
  template <class F>
  void for_each_tile(F&& f) const {
    for (const auto& tile : here_) f(std::as_const(*tile.scene));
  }

  /// Calls `f(scene)` for all tiles at once, for the first one on the caller's thread; what it asks of the communicator all tiles of all ranks must ask. If one throws, all
  /// do, on all ranks; the first one here is rethrown. Then a single rank can be used again, several cannot.
  template <class F>
  void together(F&& f) {
    std::exception_ptr first;
    std::mutex mutex;
    const auto call = [&](S& scene) {
      try {
        f(scene);
      } catch (...) {
        {
          const std::lock_guard lock(mutex);
          if (!first) first = std::current_exception();
        }
        try {
          throw;
        } catch (const std::exception& e) {
          scene.communicator().fail(e.what());
        } catch (...) {
          scene.communicator().fail("an exception that is none of the standard library's");
        }
      }
    };
    if (here_.size() == 1) {
      call(*here_.front().scene);  // its loops have all threads
    } else {
      std::vector<std::thread> threads;
      const auto call_here =
          [&](const Tile& tile) {  // the tiles share the processors: loops stay on their thread
            const bool outer = std::exchange(program::in_loop, true);
            call(*tile.scene);
            program::in_loop = outer;
          };
      for (std::size_t t = 1; t < here_.size(); ++t) threads.emplace_back([&, t] { call_here(here_[t]); });
      call_here(here_.front());
      for (auto& thread : threads) thread.join();
    }
    if (!first) return;
    all_->begin_again();
    std::rethrow_exception(first);
  }

  /// The sum of a number `of(scene)` over all tiles, or the least of them: asked on all ranks, which get the same.
  template <class Of>
  double sum(Of&& of) const {
    ranks().agree({"a sum over all tiles"});
    return of_all([&](const S& scene) {
      auto number = static_cast<double>(of(scene));
      sum_over(scene.communicator(), number);
      return number;
    });
  }
  template <class Of>
  double least(Of&& of) const {
    ranks().agree({"the least number of all tiles"});
    return of_all([&](const S& scene) { return scene.communicator().least(static_cast<double>(of(scene))); });
  }

  /// The result of `f(scene)` for the first tile here; all tiles of all ranks call it.
  template <class F>
  auto of_all(F&& f) {
    std::optional<std::invoke_result_t<F&, S&>> found;
    together([&](S& scene) {
      auto of_tile = f(scene);
      if (&scene == &first()) found = std::move(of_tile);
    });
    return *std::move(found);
  }
  template <class F>
  auto of_all(F&& f) const {
    return const_cast<Tiled&>(*this).of_all([&](S& scene) { return f(std::as_const(scene)); });
  }

 private:
  friend class detail::TileMaker<S>;
  Tiled() = default;

  /// [tiles of the whole] how many points each has; asked on all ranks.
  std::vector<std::int64_t> count_points() const {
    std::vector<std::int64_t> counts(all_->rank_of().size());
    for_each_tile([&](const S& scene) {
      counts[static_cast<std::size_t>(scene.portion().number)] =
          static_cast<std::int64_t>(scene.point_count());
    });
    ranks().sum(counts);
    return counts;
  }

  /// Gives the points of all tiles unique ids, tile by tile; those that are inserted later get others.
  void number_points() {
    const auto counts = count_points();
    const S& any = first();
    const std::uint64_t given = any.template part<PointIds>().first - any.point_count();
    std::uint64_t all = given;
    for (const auto n : counts) all += static_cast<std::uint64_t>(n);
    for_each_tile([&](S& scene) {
      const auto number = static_cast<std::size_t>(scene.portion().number);
      std::uint64_t id = given;
      for (std::size_t t = 0; t < number; ++t) id += static_cast<std::uint64_t>(counts[t]);
      scene.for_each_body([&](auto& body, const auto&) {
        for (auto& of_point : body.points.id) of_point = id++;
      });
      scene.template part<PointIds>().first = all + (static_cast<std::uint64_t>(number) << 40);
    });
  }

  struct Tile {
    std::unique_ptr<TileSlot> slot = std::make_unique<TileSlot>();
    std::unique_ptr<S> scene{};
  };
  using Part = std::pair<typename S::Mesh, MeshPortion<D>>;

  std::function<Part(int)> part_{};  // mesh and portion of a tile of the whole
  std::function<const std::vector<int>&(int, std::uint64_t)> copies_{};  // see `make_halo`
  std::unique_ptr<LocalTiles> all_{};
  std::vector<Tile> here_{};  // by their numbers
};

namespace detail {

/// Keeps the warnings of tiles while they are made, and says each once: most are of the whole.
class WarningsOfTiles {
 public:
  WarningsOfTiles() : before_{on_warning([this](const std::string& text) { told_.insert(text); })} {}
  WarningsOfTiles(const WarningsOfTiles&) = delete;
  WarningsOfTiles& operator=(const WarningsOfTiles&) = delete;
  ~WarningsOfTiles() {
    if (!said_) on_warning(std::move(before_));
  }
  void say(Ranks& ranks) {
    said_ = true;
    on_warning(std::move(before_));
    std::string lines;
    for (const auto& text : told_) lines += text + '\n';
    lines = ranks.gather(lines);
    if (ranks.rank() != 0) return;
    told_.clear();
    for (std::size_t at = 0, end = 0; at < lines.size(); at = end + 1) {
      end = lines.find('\n', at);
      if (const auto text = lines.substr(at, end - at); told_.insert(text).second) warn(text);
    }
  }

 private:
  std::set<std::string> told_{};
  bool said_ = false;
  WarningHook before_;  // last: its hook uses the others
};

/// Makes the tiles of a rank.
template <class S>
class TileMaker {
  using All = Tiled<S>;

 public:
  /// `part(t)`: mesh and portion of a tile; `copies`: see `make_halo`. Both are kept, with their data.
  template <class Part, class Copies, class Make>
  static All make_all(Ranks& ranks, int tiles, Part&& part, Copies&& copies, Make& make) {
    static_assert(S::is_portion,
                  "distribute: make(mesh, portion) must put `portion` among the parts of its scene");
    All all;
    all.part_ = std::forward<Part>(part);
    all.copies_ = std::forward<Copies>(copies);
    WarningsOfTiles warnings;
    take(all, ranks, assign_tiles(tiles, ranks.size()), make);
    warnings.say(ranks);
    all.together([](S& scene) { scene.warn_when_new(); });
    if constexpr (S::template has_part<PointIds>) all.number_points();
    return all;
  }

  /// Lets a rank have its tiles of `rank_of`: those that it has stay, others are made, the rest goes.
  template <class Make>
  static void take(All& all, Ranks& ranks, std::vector<int> rank_of, Make& make) {
    std::vector<typename All::Tile> tiles;
    std::map<std::size_t, typename All::Part> parts;
    // Checks that all tiles have made together, and those still to be made: the same in all tiles.
    std::optional<std::pair<StepCheck, std::vector<GroundAtRest>>> known;
    if (all.all_) known.emplace(all.first().step_check, all.first().at_rest);
    for (int t = 0; t < static_cast<int>(rank_of.size()); ++t) {
      if (rank_of[static_cast<std::size_t>(t)] != ranks.rank()) continue;
      const auto there = std::ranges::find(
          all.here_, t, [](const auto& tile) { return tile.scene ? tile.scene->portion().number : -1; });
      auto& tile = tiles.emplace_back();
      if (there == all.here_.end())
        parts.emplace(tiles.size() - 1, all.part_(t));
      else
        std::swap(tile, *there);
      tile.slot->tile = tiles.size() - 1;
    }
    std::vector<const MeshPortion<S::D>*> portions;
    for (std::size_t t = 0; t < tiles.size(); ++t)
      portions.push_back(tiles[t].scene ? &tiles[t].scene->portion() : &parts.at(t).second);
    auto halo = make_halo(all.copies_, rank_of, ranks.rank(), portions);
    auto of_rank = std::make_unique<LocalTiles>(ranks, std::move(halo), std::move(rank_of),
                                                all.all_ ? all.all_->migrated_bytes() : 0);
    for (auto& tile : tiles) tile.slot->all = of_rank.get();
    std::optional<WithoutWarnings> silent;  // a tile that comes from another rank has given its own
    if (all.all_) silent.emplace();
    for (auto& [t, part] : parts) {
      tiles[t].scene = std::make_unique<S>(
          make(std::move(part.first), on_portion(std::move(part.second), TileCommunicator(*tiles[t].slot))));
      if (known) std::tie(tiles[t].scene->step_check, tiles[t].scene->at_rest) = *known;
    }
    all.here_ = std::move(tiles);
    all.all_ = std::move(of_rank);
  }

  static std::vector<std::int64_t> count_points(const All& all) { return all.count_points(); }
};

template <int D>
using TilePortion = OnPortion<MeshPortion<D>, TileCommunicator>;

}  // namespace detail

/// Cuts a scene over a simplex mesh into tiles and makes those of this rank, by `make(mesh, portion)`: a scene
/// over `mesh`, with `portion` among its parts. Throws `error` for tiles that cannot be, and where ranks give other meshes or options.
template <int D, class Make>
auto distribute(Ranks& ranks, const MeshData<D>& whole, const TileOptions& options, Make&& make) {
  using S = std::remove_cvref_t<decltype(make(std::declval<SimplexMesh<D>>(),
                                              std::declval<detail::TilePortion<D>>()))>;
  const auto tile =
      options.tile.empty()
          ? split_cells(whole, options.tiles > 0 ? options.tiles : ranks.size(), options.weights)
          : options.tile;
  require(tile.size() == whole.cells.size(), "TileOptions.tile", tile.size(), "must have one entry a cell");
  const auto [least, most] = std::ranges::minmax(tile);
  require(least >= 0, "TileOptions.tile", least, "must not be negative");
  ranks.agree(Question{"the tiles of a mesh"}
                  .with("mesh: nodes", whole.nodes)
                  .with("mesh: cells", whole.cells)
                  .with("mesh: regions", whole.region)
                  .with("TileOptions.tiles", options.tiles)
                  .with("TileOptions: tile of each cell", tile));
  return detail::TileMaker<S>::make_all(
      ranks, std::max(options.tiles, most + 1),
      [kept = std::make_shared<const MeshData<D>>(whole), tile](int t) {
        auto [mesh, portion] = split_mesh(*kept, tile, t);
        return std::pair{SimplexMesh<D>(mesh), std::move(portion)};
      },
      [copies = std::make_shared<const std::vector<std::vector<int>>>(copies_of_nodes(whole, tile))](
          int, std::uint64_t node) -> const std::vector<int>& { return (*copies)[node]; },
      make);
}

namespace detail {
template <class Grid, class Make>
auto distribute_grid(Ranks& ranks, const Grid& whole, const TileOptions& options, Make& make) {
  constexpr int D = Grid::dimension;
  using S =
      std::remove_cvref_t<decltype(make(std::declval<WindowGrid<Grid>>(), std::declval<TilePortion<D>>()))>;
  using Shape = typename S::Shape;
  require(options.tile.empty(), "TileOptions.tile", options.tile.size(),
          "goes with simplices: tiles of a grid are boxes");
  const int tiles = options.tiles > 0 ? options.tiles : ranks.size();
  std::vector<std::array<double, static_cast<std::size_t>(D)>> corners;
  for (Index c = 0; c < whole.cell_count(); ++c) {
    auto& corner = corners.emplace_back();
    for (int k = 0; k < D; ++k) corner[static_cast<std::size_t>(k)] = static_cast<double>(whole.corner(c)[k]);
  }
  ranks.agree(Question{"the tiles of a grid"}
                  .with("grid: corners of cells", corners)
                  .with("TileOptions.tiles", tiles)
                  .with("TileOptions.weights", options.weights));
  const auto boxes = split_cells(whole, tiles, options.weights);
  std::array<Index, static_cast<std::size_t>(D)> cells, nodes;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    cells[k] = whole.cells(static_cast<int>(k));
    nodes[k] = cells[k] + Shape::halo;
  }
  std::vector<CellRange<D>> of_windows;
  for (const auto& box : boxes) {
    auto range = box.grown(Shape::halo, cells);
    for (Index& end : range.end) end += Shape::halo;
    of_windows.push_back(range);
  }
  return TileMaker<S>::make_all(
      ranks, tiles, [whole, boxes](int t) { return split_grid<Shape>(whole, boxes, t); },
      CopiesInWindows<D>(of_windows, nodes), make);
}
}  // namespace detail

/// The same over a grid: the tiles are boxes of its cells, and `make` is given windows of it (`WindowGrid`).
template <int D, class T, class Make>
auto distribute(Ranks& ranks, const CartesianGrid<D, T>& whole, const TileOptions& options, Make&& make) {
  return detail::distribute_grid(ranks, whole, options, make);
}
template <int D, class T, class Make>
auto distribute(Ranks& ranks, const RectilinearGrid<D, T>& whole, const TileOptions& options, Make&& make) {
  return detail::distribute_grid(ranks, whole, options, make);
}

/// Refused by the compiler: what cannot be cut.
template <class Mesh, class Make>
void distribute(Ranks&, const Mesh&, const TileOptions&, Make&&) {
  static_assert(
      !std::is_object_v<Mesh>,
      "distribute: the mesh must be the MeshData of simplices, a CartesianGrid or a RectilinearGrid; "
      "periodic grids cannot be cut into tiles");
}

/// Steps all tiles to `options.end`: see `run` of a scene. Each tile has its own copies of the observers, which are called at once
/// from several threads: what they write must be their own, or be written where `scene.communicator().first()`.
template <class S, class... Observers>
void run(Tiled<S>& tiled, const RunOptions& options, Observers&&... observers) {
  detail::check_observers<Observers...>();
  tiled.ranks().agree(detail::question_of(options));
  tiled.together([&](S& scene) {
    [&](std::remove_cvref_t<Observers>... own) { run(scene, options, own...); }(std::as_const(observers)...);
  });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
