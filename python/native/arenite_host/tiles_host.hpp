// Tiles host: a scene that is cut into tiles, on the ranks of a host's, as a `HostedScene`.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <chrono>
#include <concepts>
#include <cstddef>
#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/particles/point_ids.hpp>
#include <arenite/tiles/run_of_tiles.hpp>
#include <arenite/tiles/saved_tiles.hpp>
#include <arenite/tiles/tiled.hpp>
#include <arenite_host/scene_host.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// A watch that a run may have.
class WatchIfAny {
 public:
  WatchIfAny(const HostedRun& run, std::vector<HostedWatched>& seen) : seen_{&seen} {
    if (run.watch && run.limits) watch_.emplace(watch_limits(run));
  }
  template <class S>
  void operator()(const S& scene) {
    if (watch_) (*watch_)(scene);
  }
  /// `seen` becomes what that of the first tile of all has seen, on its rank.
  template <class S>
  void finish(const S& scene) {
    if (!watch_) return;
    watch_->finish(scene);
    if (scene.communicator().first()) *seen_ = seen_by(*watch_);
  }
  template <class F>
  void visit_state(F&& f) {
    if (watch_) watch_->visit_state(f);
  }

 private:
  std::vector<HostedWatched>* seen_;
  std::optional<Watch> watch_{};
};

/// The signals in a value, in its order.
inline void add_signals(const Value& value, std::vector<HostSignal>& to) {
  if (const auto* signal = value.get<HostSignal>()) to.push_back(*signal);
  if (const auto* list = value.get<Value::List>())
    for (const Value& item : *list) add_signals(item, to);
  if (const auto* dict = value.get<Value::Dict>())
    for (const auto& [name, item] : *dict) add_signals(item, to);
}

/// Makes the scenes of tiles of a host's values, whose functions of place see the places of the whole.
template <class Whole>
class MakeTile {
 public:
  using Reader = SceneReader<Whole>;

  explicit MakeTile(const Value& values) : values_{std::make_shared<const Value>(values)} {}
  const Value& values() const { return *values_; }

  /// If one process has all tiles it makes the whole scene first, for its warnings and refusals, and discards it; ranks have no
  /// memory for it, and only evaluate its functions of place.
  void ask_whole(const Ranks& ranks) {
    const auto mesh = whole_mesh();
    if (ranks.size() == 1) {
      Reader::over(mesh, *values_, memory_.get());
      without_warnings_ = true;
    } else {
      Reader::ask_places(mesh, *values_, *memory_);
    }
    memory_->close();
  }
  void forget_places() { *memory_ = {}; }
  /// As `ask_whole` for points of a body that join tiles like this one.
  template <class S>
  PlaceMemory ask_fill(const S& tile, std::size_t body, const Value& fill) const {
    PlaceMemory memory;
    const auto mesh = whole_mesh();
    with_body(tile, body, [&](const auto& of) {
      using Law = std::remove_cvref_t<decltype(of.law)>;
      read_fill<S, Fill<Law>>(mesh, fill, {.name = "fill", .dimension = S::D, .memory = &memory});
    });
    memory.close();
    return memory;
  }

  template <class Mesh, class Portion>
  auto operator()(const Mesh& mesh, const Portion& portion) const {
    std::optional<WithoutWarnings> silent;
    if (without_warnings_) silent.emplace();
    const OwnedCells<Whole::D> cells{portion.portion};
    return std::move(*Reader::over(mesh, *values_, memory_.get(), cells, PointIds{}, portion));
  }

 private:
  auto whole_mesh() const {
    return read<typename Whole::Mesh>(Reader::given(*values_, "mesh"), Reader::at() / "mesh");
  }

  std::shared_ptr<const Value> values_;
  std::shared_ptr<PlaceMemory> memory_ = std::make_shared<PlaceMemory>();
  bool without_warnings_ = false;
};

}  // namespace detail

/// Calls of the host that change or ask for something are made on all ranks.
template <class S, class Make>
class TilesHost : public HostedScene {
 public:
  TilesHost(Tiled<S> tiled, Make make, RebalanceOptions options)
      : tiled_{std::move(tiled)}, make_{std::move(make)}, options_{options} {
    detail::add_signals(make_.values(), signals_);
  }

  int dimension() const override { return S::D; }
  double time() const override { return tiled_.time(); }
  double time_step() const override { return tiled_.first().time_step; }
  std::size_t steps() const override { return tiled_.steps(); }
  std::size_t generation() const override { return generation_; }
  double stable_step() const override {
    return tiled_.of_all([](S& s) { return s.communicator().least(arenite::stable_step(s)); });
  }
  void step(double dt) override {
    ++generation_;
    agree("a step");
    tiled_.together([dt](S& s) { arenite::step(s, dt); });
  }

  bool run(const HostedRun& run) override {
    ++generation_;
    watched_.clear();
    const bool watch = run.watch && !run.limits;  // that of `run`
    if (!run.settle)
      return go(run, {.end = run.end, .courant = run.courant, .max_step = run.max_step, .watch = watch});
    if constexpr (detail::has_damping<S>) {
      const SettleOptions options{
          .ratio = *run.settle, .end = run.end, .courant = run.courant, .watch = watch};
      return go(run, options.of_run(time()), Settled{options, steps()});
    } else {
      throw error(detail::needs_damping("settle"));
    }
  }
  std::function<double(bool)> steps(const HostedRun&) override { refuse("steps"); }
  std::vector<HostedWatched> watched() const override { return watched_; }
  double out_of_balance() const override {
    return alike([](const S& s) { return detail::out_of_balance_for_host(s); });
  }
  void switch_off_damping() override {
    tiled_.for_each_tile([](S& s) { detail::switch_off_damping(s); });
  }

  /// Of the tiles here, under "tiles/NUMBER".
  std::vector<StateSlot> state() override {
    std::vector<StateSlot> all;
    tiled_.for_each_tile([&](S& s) {
      for (auto& slot : state_slots(s)) {
        slot.name = joined_text({"tiles/", s.portion().number, "/", slot.name});
        all.push_back(std::move(slot));
      }
    });
    return all;
  }
  /// Those that the tiles here count in sums.
  HostedNodes nodes(std::size_t body) const override {
    HostedNodes all;
    tiled_.for_each_tile([&](const S& s) {
      detail::add_nodes_for_host(all, s, body, [&](Index i) { return s.portion().owns_node(i); });
    });
    return all;
  }
  HostedCells cells() const override { refuse("cells"); }
  HostedEnergies energies() const override {
    return alike([](const S& s) { return detail::energies_for_host(s); });
  }
  std::array<std::vector<double>, 2> reaction(const std::string& wall) const override {
    return alike([&](const S& s) { return detail::reaction_for_host(s, wall); });
  }

  HostedTotals fill(std::size_t body, const Value& fill) override {
    PlaceMemory memory = make_.ask_fill(tiled_.first(), body, fill);
    const auto all = change([&](S& s) { return detail::fill_more(s, body, fill, &memory); });
    const Value* const may_be_empty = fill.find("may_be_empty");
    require(
        all.count > 0 || (may_be_empty != nullptr && read<bool>(*may_be_empty, ReadContext{.name = "fill"})),
        "fill: points", all.count, "the region holds no point of the mesh");
    return all;
  }
  HostedTotals insert(std::size_t body, const Value& points) override {
    ++generation_;
    return alike([&](S& s) { return sum_of(s, detail::insert_rows(s, body, points)); });
  }
  HostedTotals remove(std::size_t body, const Value& where) override {
    const HostArray* const flags = where.array();  // of the points of the tiles here, tile by tile
    if (flags == nullptr) return change([&](S& s) { return detail::remove_where(s, body, where); });
    std::map<int, Value> of_tile;
    std::size_t points = 0;
    tiled_.for_each_tile([&](const S& s) {
      detail::with_body(s, body, [&](const auto& of) {
        const std::size_t begin = std::min(points, flags->numbers.size());
        points += of.points.size();
        const std::size_t end = std::min(points, flags->numbers.size());
        const auto at = [&](std::size_t k) {
          return flags->numbers.begin() + static_cast<std::ptrdiff_t>(k);
        };
        of_tile[s.portion().number] =
            std::make_shared<const HostArray>(HostArray{{at(begin), at(end)}, {end - begin}});
      });
    });
    if (flags->numbers.size() != points) {
      const error refused(joined_text(
          {"where = ", where.text(), ": must have one for each of ", points, " points of the tiles here"}));
      tiled_.ranks().fail(refused.what());
      throw refused;
    }
    return change([&](S& s) { return detail::remove_where(s, body, of_tile.at(s.portion().number)); });
  }
  HostedProbes probe(std::size_t body, const std::vector<double>& places) const override {
    return tiled_.of_all([&](S& s) { return detail::probe_places(s, body, places); });
  }
  std::vector<double> section_force(std::size_t body, const Value& section, bool of_nodes) const override {
    return alike([&](const S& s) { return detail::force_across(s, body, section, of_nodes); });
  }

  void save(const std::string& path, const std::string& recipe) const override {
    save_state(tiled_, SavedState(path, recipe));
  }
  void restore(const std::string& path, const std::string& recipe) override {
    ++generation_;
    restore_state(tiled_, SavedState(path, recipe));
  }
  void follow() override {
    ++generation_;
    tiled_.together([](S& s) { follow_state(s); });
  }
  std::unique_ptr<HostedScene> copy() const override { refuse("copy"); }

 private:
  [[noreturn]] static void refuse(const char* what) {
    throw error(joined_text({what, ": is not there for a scene that is cut into tiles"}));
  }
  /// After calls of the host, which may have asked for something on only one rank, or set a signal.
  bool agree(const char* asks, bool yes = false) {
    Question question{asks};
    for (const HostSignal& signal : signals_)
      for (const double component : *signal) question.with("component of a Signal", component);
    return tiled_.ranks().agree(question, yes);
  }
  /// Runs in parts: between them the host is called, whose calls may ask all tiles, and which stops on all ranks if it does on one. Returns
  /// what `run` does.
  template <class... Observers>
  bool go(const HostedRun& run, const RunOptions& options, Observers... observers) {
    Ranks& ranks = tiled_.ranks();
    RunOfTiles run_of_tiles(tiled_, options, rebalancing(make_, options_), detail::WatchIfAny(run, watched_),
                            std::move(observers)...);
    std::vector<Every<std::function<RunFlow(const S&)>>> timers;
    for (std::size_t k = 0; k < run.periods.size(); ++k)
      timers.emplace_back(run.periods[k],
                          [&run, k](const S&) { return run.due(k) ? RunFlow::stop : RunFlow::go_on; });
    bool asks = false, stops = false;  // whether a call may have asked to stop, and has
    double due = 0;
    const auto failing_all = [&ranks](auto&& f) {  // all ranks end with what one throws
      try {
        f();
      } catch (const std::exception& e) {
        ranks.fail(e.what());
        throw;
      }
    };
    const auto call = [&] {
      for (auto& timer : timers) {
        if (time() < timer.due()) continue;
        stops = timer(tiled_.first()) == RunFlow::stop || stops;
        asks = true;
      }
      due = std::numeric_limits<double>::infinity();
      for (const auto& timer : timers) due = std::min(due, timer.due());
    };
    if (run.resumed)
      for (auto& timer : timers) timer.resume_at(time());
    failing_all([&] { call(); });
    stops = agree("the next steps of its run", stops);
    run_of_tiles.begin();
    using Clock = std::chrono::steady_clock;
    int most = 1;
    while (!stops && !run_of_tiles.has_ended()) {
      const auto start = Clock::now();
      run_of_tiles.advance(run.each_step ? 1 : most, due);
      ++generation_;
      // The host is called some times a second.
      const double took = std::chrono::duration<double>(Clock::now() - start).count();
      most = took < 0.02 ? std::min(2 * most, 1 << 20) : took > 0.1 ? std::max(most / 2, 1) : most;
      failing_all([&] {
        call();
        if (run.after_step) stops = run.after_step() || stops;
      });
      if (asks || run.each_step) stops = agree("the next steps of its run", stops);
      asks = false;
    }
    run_of_tiles.finish();
    ++generation_;
    if constexpr ((std::same_as<Observers, Settled> || ...))
      return run_of_tiles.template observer<Settled>().at_end(time());
    else
      return !(time() < run.end);
  }
  /// Result of `f(scene)` for the first tile here. An `error` of it is thrown by all tiles of all ranks, after all have made the same
  /// exchanges: then all can be asked again. (A single rank can after any failure.)
  template <class F>
  auto alike(F&& f) const {
    if (tiled_.ranks().size() == 1) return tiled_.of_all(f);
    std::exception_ptr refused;
    std::mutex mutex;
    auto found = tiled_.of_all([&](S& s) {
      std::optional<std::invoke_result_t<F&, S&>> of_tile;
      try {
        of_tile = f(s);
      } catch (const run_error&) {
        throw;
      } catch (const error&) {
        const std::lock_guard lock(mutex);
        refused = std::current_exception();
      }
      return of_tile;
    });
    if (refused) std::rethrow_exception(refused);
    return *std::move(found);
  }
  /// Sums over all tiles of the points added or removed.
  static HostedTotals sum_of(S& s, HostedTotals all) {
    auto count = static_cast<double>(all.count);
    all.momentum.resize(static_cast<std::size_t>(S::D));
    sum_over(s.communicator(), count, all.mass, all.kinetic_energy, all.strain_energy);
    s.communicator().sum(all.momentum);
    all.count = static_cast<std::size_t>(count);
    return all;
  }
  template <class F>
  HostedTotals change(F&& f) {
    ++generation_;
    return tiled_.of_all([&](S& s) { return sum_of(s, f(s)); });
  }

  mutable Tiled<S> tiled_;  // asking is a step of all ranks
  Make make_;
  RebalanceOptions options_;
  std::vector<HostSignal> signals_{};
  std::vector<HostedWatched> watched_{};
  std::size_t generation_ = 0;
};

/// Makes a scene of a host's values, as `make_hosted` does, and cuts it into tiles: on all ranks. `ranks` must outlive it.
template <class Scene>
std::unique_ptr<HostedScene> make_hosted_tiles(const Value& values, Ranks& ranks, const TileOptions& cut,
                                               const RebalanceOptions& moves) {
  using Mesh = typename Scene::Mesh;
  using Reader = detail::SceneReader<Scene>;
  constexpr bool is_cut_in_double = !is_simplex_mesh<Mesh> || std::is_same_v<typename Mesh::scalar, double>;
  static_assert(is_cut_in_double, "tiles: a mesh of simplices must be of float64");
  const Value& mesh = Reader::given(values, "mesh");
  detail::MakeTile<Scene> make(values);
  const auto host = [&](auto tiled) -> std::unique_ptr<HostedScene> {
    using S = typename decltype(tiled)::Scene;
    if (ranks.size() == 1) make.forget_places();  // no more tiles are made
    return std::make_unique<TilesHost<S, detail::MakeTile<Scene>>>(std::move(tiled), make, moves);
  };
  if constexpr (is_cut_in_double) {
    make.ask_whole(ranks);
    if constexpr (is_simplex_mesh<Mesh>)
      return host(distribute(
          ranks, read<MeshData<Scene::D>>(mesh, ReadContext{.name = "SimplexMesh", .dimension = Scene::D}),
          cut, make));
    else
      return host(distribute(ranks, read<Mesh>(mesh, Reader::at() / "mesh"), cut, make));
  } else {
    return nullptr;  // already reported
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
