// arenite-ffp-mpi: a drop on the ranks of MPI, mpirun -n 4 arenite-ffp-mpi drop --kinematics slice ..
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <arenite/arenite.hpp>
#include <arenite/mpi.hpp>
#include <arenite/observe/vtu.hpp>
#include <arenite/run/every.hpp>
#include <arenite/run/progress.hpp>
#include <arenite/run/run_status.hpp>

#include "../command/read_drop.hpp"
#include "../drop/drop_folder.hpp"
#include "../drop/history_row.hpp"
#include "../drop/model.hpp"
#include "../drop/results.hpp"
#include "../drop/summary_file.hpp"
#include "../text/say.hpp"

namespace arenite::ffp {

namespace {

/// Throws `error` for what a drop on ranks cannot be, or does not do.
void check_on_ranks(const DropOptions& o) {
  const auto refuse = [](bool given, const char* option) {
    if (given) throw error(joined_text({option, ": arenite-ffp has it, arenite-ffp-mpi does not"}));
  };
  refuse(o.on_grid(), "--mesh-kind = grid");
  refuse(o.device != DeviceKind::rigid, "--device = elastic");
  refuse(o.law.kind != LawKind::mohr_coulomb, "--law");
  refuse(o.contact_kind() != ContactKind::rigid, "--contact");
  refuse(!o.averages(), "--anti-locking = off");
  refuse(o.split_share() > 0, "--split");
  refuse(!o.mesh.empty(), "--mesh");
  refuse(o.resume, "--resume");
  refuse(o.error_bar, "--error-bar");
}

/// Takes the rows of the history down, on the rank of the first tile.
class RowsOnRanks {
 public:
  struct Rows {
    std::vector<HistoryRow> all{};
    std::optional<HistoryFile> file{};
  };
  RowsOnRanks(Rows& rows, double whole, double tip_above)
      : rows_{&rows}, whole_{whole}, tip_above_{tip_above} {}

  template <class Scene>
  void operator()(const Scene& scene) const {
    const bool first = scene.communicator().first();
    HistoryRow row = history_row(scene, first && !rows_->all.empty() ? &rows_->all.back() : nullptr, whole_);
    if (!first) return;
    row.penetration_m -= tip_above_;
    rows_->file->write(row);
    rows_->all.push_back(row);
  }

 private:
  Rows* rows_;
  double whole_, tip_above_;
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
    f.visit_state(g);
  }
  template <class Scene>
  void follow_state(const Scene& scene) {
    if constexpr (requires { f.follow_state(scene); })
      if (on) f.follow_state(scene);
  }
};
template <class F>
When(bool, F) -> When<F>;

template <class Model>
void drop_on(mpi::World& world, const DropOptions& o, int tiles) {
  const auto data = Model::generate(o);
  const SimplexMesh<Model::dimension> whole(data);
  const auto motion = motion_of<LedByRigid<"device">>(o, whole);
  std::vector<double> weights;  // only the sand has points
  for (Index c = 0; c < whole.cell_count(); ++c)
    weights.push_back(whole.region(c) == whole.region_number("soil") ? 1 : 0.01);
  const auto make = [&](auto mesh, auto portion) {
    return rigid_scene_in<Model, NodalAndElementAverage, RigidVelocity>(std::move(mesh), motion, o,
                                                                        plain_sand(o), PointIds{}, portion);
  };
  auto scene = distribute(world, data, {.tiles = tiles, .weights = weights}, make);

  const bool writes = world.rank() == 0;
  std::unique_ptr<RunFolder> folder;
  RowsOnRanks::Rows rows;
  RunNumbers numbers;
  numbers.started = utc_now();
  numbers.threads = threads();
  numbers.points = static_cast<long>(scene.sum([](const auto& tile) { return tile.point_count(); }));
  const auto write_summary = [&](const std::string& status) {
    numbers.status = status;
    std::optional<DropFigures> figures;
    if (!rows.all.empty()) {
      figures = figures_of(rows.all);
      numbers.steps = static_cast<long>(rows.all.size()) - 1;
      numbers.lost_points = static_cast<long>(rows.all.back().lost_points);
    }
    write_json(summary_file(folder->path()), summary_of(o, figures, numbers));
  };
  if (writes) {
    folder.reset(new RunFolder(drop_folder(o.out)));
    rows.file.emplace(folder->path() / "history.csv");
    write_summary("running");
    if (!o.quiet)
      say(joined_text({numbers.points, " points in ", scene.tiles(), " tiles on ", world.size(), " ranks"}));
  }
  world.meet();
  try {
    run(scene, {.end = o.end, .courant = o.courant_number()}, rebalancing(make),
        RowsOnRanks(rows, Model::whole, o.body().tip_above()),
        When{o.fields_every > 0, every(o.fields_every > 0 ? o.fields_every : 1, vtu(o.out + "/fields"))},
        When{!o.quiet, Progress(o.end, {.tenths = true})});
  } catch (const std::exception& e) {
    numbers.failure = e.what();
    if (writes) write_summary("failed");
    throw;
  }
  if (!writes) return;
  write_summary("done");
  if (!o.quiet) std::cout << sentence_of(figures_of(rows.all), o.out) << std::endl;
}

/// The value of `--tiles N` (one a rank without), which is taken out of the words.
int take_tiles(std::vector<std::string>& words) {
  const auto at = std::ranges::find(words, "--tiles");
  if (at == words.end()) return 0;
  require(at + 1 != words.end(), "--tiles", "", "needs a number");
  const std::string text = at[1];
  const int tiles =
      text.size() < 8 && text.find_first_not_of("0123456789") == std::string::npos && !text.empty()
          ? std::stoi(text)
          : 0;
  require(tiles > 0, "--tiles", shown(text), "must be a number of tiles, at least 1");
  words.erase(at, at + 2);
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
  check_on_ranks(*options);
  set_threads(options->threads);
  if (options->kinematics == Kinematics::slice)
    drop_on<SliceModel>(world, *options, tiles);
  else
    drop_on<AxisymmetricModel>(world, *options, tiles);
}

}  // namespace arenite::ffp

int main(int argc, char** argv) {
  return arenite::mpi::program(argc, argv, [&](arenite::mpi::World& world) {
    arenite::ffp::drop_on_ranks(world, {argv + 1, argv + argc});
  });
}
