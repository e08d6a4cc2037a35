// arenite-ffp-mpi: a drop on the ranks of MPI, mpirun -n 4 arenite-ffp-mpi drop --kinematics slice ..
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <arenite/arenite.hpp>
#include <arenite/mpi.hpp>
#include <arenite/observe/vtu.hpp>
#include <arenite/run/every.hpp>
#include <arenite/run/progress.hpp>
#include <arenite/run/run_status.hpp>
#include <arenite/run/stop_signals.hpp>
#include <arenite/watch/watch.hpp>

#include "../command/read_drop.hpp"
#include "../drop/drop_folder.hpp"
#include "../drop/earlier_run.hpp"
#include "../drop/history_row.hpp"
#include "../drop/model.hpp"
#include "../drop/model_space.hpp"
#include "../drop/results.hpp"
#include "../drop/step_count.hpp"
#include "../drop/summary_file.hpp"
#include "../text/say.hpp"

namespace arenite::ffp {

namespace {

/// Throws `error` for what a drop on ranks cannot be, or does not do.
void check_on_ranks(const DropOptions& o) {
  const auto refuse = [](bool given, const char* option) {
    if (given) throw error(joined_text({option, ": arenite-ffp has it, arenite-ffp-mpi does not"}));
  };
  if (!o.in_space()) {
    refuse(o.on_grid(), "--mesh-kind = grid");
    refuse(o.law.kind != LawKind::mohr_coulomb, "--law");
    refuse(!o.averages(), "--anti-locking = off");
  }
  refuse(o.device != DeviceKind::rigid, "--device = elastic");
  refuse(o.contact_kind() != ContactKind::rigid, "--contact");
  refuse(o.split_share() > 0, "--split");
  refuse(!o.mesh.empty(), "--mesh");
  refuse(o.error_bar, "--error-bar");
}

/// The history, on the rank of the first tile: rows so far, and their file.
struct HistoryOnRank {
  std::filesystem::path path;
  const HistoryRows* rows = nullptr;
  std::optional<HistoryFile> file{};
};

/// Records the rows of the history; only the first tile keeps and writes them.
class RowsOnRanks {
 public:
  RowsOnRanks(HistoryOnRank& shown, double whole, const DropOptions& o)
      : shown_{&shown}, whole_{whole}, start_{o.start()}, turns_{o.in_space()} {}

  template <class Scene>
  void operator()(const Scene& scene) {
    const bool first = scene.communicator().first();
    const HistoryRow row =
        history_row(scene, first && !rows_.all.empty() ? &rows_.all.back() : nullptr, start_, whole_);
    if (!first) return;
    if (!shown_->file) {
      shown_->file.emplace(shown_->path, turns_);
      for (const HistoryRow& earlier : rows_.all) shown_->file->write(earlier);
    }
    shown_->file->write(row);
    rows_.all.push_back(row);
    shown_->rows = &rows_;
  }
  template <class F>
  void visit_state(F&& f) {
    f("history", rows_);
  }

 private:
  HistoryOnRank* shown_;
  double whole_;
  DeviceStart start_;
  bool turns_;
  HistoryRows rows_{};
};

/// An observer that may be off.
template <class F>
struct When {
  bool on;
  F f;

  template <class Scene>
  void operator()(const Scene& scene) {
    if (on) f(scene);
  }
  template <class G>
  void visit_state(G&& g) {
    if constexpr (requires { f.visit_state(g); }) f.visit_state(g);
  }
  template <class Scene>
  void follow_state(const Scene& scene) {
    if constexpr (requires { f.follow_state(scene); })
      if (on) f.follow_state(scene);
  }
  template <class Scene>
  void finish(const Scene& scene) {
    if constexpr (requires { f.finish(scene); })
      if (on) f.finish(scene);
  }
};
template <class F>
When(bool, F) -> When<F>;

/// The state of earlier runs in the folder: all ranks read it before one of them changes it.
EarlierRun earlier_on_ranks(mpi::World& world, const DropOptions& o) {
  EarlierRun earlier;
  if (o.resume) earlier = earlier_run(o, true);
  world.meet();
  return earlier;
}

/// `whole`: mesh or grid; `weights`: [cells] what each costs; `make(mesh, portion)`: the scene of a tile. Masses and forces of the
/// experiment are `times` those of the scene.
template <class Whole, class Make>
void drop_on(mpi::World& world, const DropOptions& o, const EarlierRun& earlier, int tiles, double times,
             const Whole& whole, const std::vector<double>& weights, const Make& make) {
  const bool writes = world.rank() == 0, tells = writes && !o.quiet;
  auto scene = distribute(world, whole, {.tiles = tiles, .weights = weights}, make);
  const double length = scene.least([&](const auto& tile) {
    return expected_steps(tile, {.end = o.end, .courant = o.courant_number()}).length;
  });
  const ExpectedSteps expected{std::ceil(o.end / length), length};
  accept_steps(expected, o, [&] { return o.cell_size(); });

  std::unique_ptr<RunFolder> folder;
  HistoryOnRank history{std::filesystem::path(o.out) / "history.csv"};
  RunNumbers numbers;
  numbers.started = earlier.has_state ? earlier.started : utc_now();
  numbers.resumed_at_s = earlier.resumed_at_s;
  numbers.threads = threads();
  numbers.register_bytes = native_register_bytes;
  numbers.expected_steps = static_cast<long>(std::min(expected.count, 1e18));
  numbers.wall_s = earlier.has_state ? earlier.wall_s : 0;
  numbers.points = static_cast<long>(scene.sum([](const auto& tile) { return tile.point_count(); }));
  using Clock = std::chrono::steady_clock;
  auto counted_to = Clock::now();
  const auto write_summary = [&](const std::string& status) {
    if (!writes) return;
    numbers.status = status;
    std::optional<DropFigures> figures;
    const auto now = Clock::now();
    numbers.wall_s += std::chrono::duration<double>(now - std::exchange(counted_to, now)).count();
    if (history.rows) {
      figures = figures_of(history.rows->all);
      numbers.steps = static_cast<long>(history.rows->all.size()) - 1;
      numbers.point_steps = static_cast<double>(numbers.points) * static_cast<double>(numbers.steps);
      numbers.lost_points = static_cast<long>(history.rows->all.back().lost_points);
    }
    ffp::write_summary(folder->path(), o, figures, numbers);
  };
  if (writes) {
    folder.reset(new RunFolder(
        drop_folder(o.out, earlier.has_state ? RunFolder::Earlier::kept : RunFolder::Earlier::removed)));
    if (!earlier.has_state) remove_saved_tiles(o.out);
    write_summary("running");
    if (tells)
      say(joined_text({numbers.points, " points in ", scene.tiles(), " tiles on ", world.size(), " ranks"}));
  }
  world.meet();

  const StopSignals signals;
  const SavedState saved(std::filesystem::path(o.out) / saved_tiles_name, hash_of_inputs(o));
  const auto period = [](double given) {
    return given > 0 ? given : std::numeric_limits<double>::infinity();
  };
  RunOfTiles run(
      scene, RunOptions{.end = o.end, .courant = o.courant_number(), .watch = false}, rebalancing(make),
      RowsOnRanks(history, times, o),
      When{o.fields_every > 0,
           every(period(o.fields_every), VtuSeries(o.out + "/fields", {.resumed = earlier.has_state}))},
      When{!o.no_watch,
           Watch(WatchLimits{.energy_gain = o.watch_energy, .volume = o.watch_volume, .lost = o.watch_lost})},
      When{!o.quiet, Progress(o.end, {.tenths = true})});
  try {
    auto saves = every(period(o.checkpoint_every), [&](const auto&) {
      run.save(saved);
      write_summary("running");
    });
    if (earlier.has_state) {
      run.restore(saved);
      numbers.resumed_at_s.push_back(scene.time());
      if (tells) say(joined_text({"resumed at t = ", scene.time(), " s, step ", scene.steps()}));
    } else {
      run.begin();
    }
    struct Now {
      double time;
    };
    saves.resume_at(scene.time());
    constexpr int most = 50;  // steps until all check for signals
    while (!run.has_ended()) {
      run.advance(most, saves.due());
      if (run.has_ended()) break;
      saves(Now{scene.time()});
      if (world.least(signals.has_come() ? 0 : 1) > 0) continue;
      run.save(saved);
      throw Interruption(SIGTERM);
    }
    run.finish();
  } catch (const std::exception& e) {
    numbers.failure = e.what();
    write_summary(dynamic_cast<const Interruption*>(&e) ? "interrupted" : "failed");
    throw;
  }
  if (!writes) return;
  write_summary("done");
  remove_saved_tiles(o.out);
  if (tells) std::cout << sentence_of(figures_of(history.rows->all), o) << std::endl;
}

constexpr double without_points = 0.01;  ///< cost of a cell outside of the sand, over one within

template <class Model>
void drop_in_mesh(mpi::World& world, const DropOptions& o, const EarlierRun& earlier, int tiles) {
  const auto data = Model::generate(o);
  const SimplexMesh<Model::dimension> whole(data);
  const auto motion = motion_of<LedByRigid<"device">>(o, whole);
  std::vector<double> weights;
  for (Index c = 0; c < whole.cell_count(); ++c)
    weights.push_back(whole.region(c) == whole.region_number("soil") ? 1 : without_points);
  drop_on(world, o, earlier, tiles, Model::whole, data, weights, [&](auto mesh, auto portion) {
    return rigid_scene_in<Model, NodalAndElementAverage, RigidVelocity>(std::move(mesh), motion, o,
                                                                        plain_sand(o), PointIds{}, portion);
  });
}
void drop_in_space(mpi::World& world, const DropOptions& o, const EarlierRun& earlier, int tiles) {
  const auto whole = SpaceModel::mesh(o);
  std::vector<double> weights;
  for (Index c = 0; c < whole.cell_count(); ++c)
    weights.push_back(whole.corner(c)[1] < 0 ? 1 : without_points);
  drop_on(world, o, earlier, tiles, SpaceModel::whole, whole, weights,
          [&](auto mesh, auto portion) { return space_scene_in(std::move(mesh), o, PointIds{}, portion); });
}

/// The value of `--tiles N` or `--tiles=N` (one a rank without; the last one counts), which is taken out of the words.
int take_tiles(std::vector<std::string>& words) {
  const std::string name = "--tiles";
  int tiles = 0;
  for (auto word = words.begin(); word != words.end();) {
    const bool with_value = word->starts_with(name + "=");
    if (!with_value && *word != name) {
      ++word;
      continue;
    }
    const auto value = with_value ? word : word + 1;
    require(value != words.end(), name, "", "needs a number");
    const std::string text = with_value ? word->substr(name.size() + 1) : *value;
    const bool is_number =
        !text.empty() && text.size() < 8 && text.find_first_not_of("0123456789") == text.npos;
    tiles = is_number ? std::stoi(text) : 0;
    require(tiles > 0, name, shown(text), "must be a number of tiles, at least 1");
    word = words.erase(word, value + 1);
  }
  return tiles;
}

}  // namespace

void drop_on_ranks(mpi::World& world, std::vector<std::string> words) {
  require(!words.empty() && words.front() == "drop", "arenite-ffp-mpi",
          words.empty() ? "" : shown(words.front()), "the command must be drop");
  words.erase(words.begin());
  const int tiles = take_tiles(words);
  std::ostringstream answer;
  const auto options = read_drop(words, answer);
  if (!options) {
    if (world.rank() == 0)
      std::cout << answer.str()
                << "On ranks also --tiles N: pieces of the whole, at least one a rank [one a rank]\n";
    return;
  }
  Question question{"a drop", told_of(*options)};
  world.agree(question.with("--tiles", tiles));
  check_on_ranks(*options);
  set_threads(options->threads);
  const EarlierRun earlier = earlier_on_ranks(world, *options);
  if (earlier.finished) {
    if (world.rank() == 0) remove_saved_tiles(options->out);  // of a run that was killed as it ended
    if (world.rank() == 0 && !options->quiet)
      say(joined_text({"the run in ", shown(options->out), " is finished; nothing to do"}));
  } else if (options->in_space()) {
    drop_in_space(world, *options, earlier, tiles);
  } else if (options->kinematics == Kinematics::slice) {
    drop_in_mesh<SliceModel>(world, *options, earlier, tiles);
  } else {
    drop_in_mesh<AxisymmetricModel>(world, *options, earlier, tiles);
  }
}

}  // namespace arenite::ffp

int main(int argc, char** argv) {
  return arenite::mpi::program(argc, argv, [&](arenite::mpi::World& world) {
    arenite::ffp::drop_on_ranks(world, {argv + 1, argv + argc});
  });
}
