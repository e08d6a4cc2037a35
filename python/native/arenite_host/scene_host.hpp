// Scene host: a scene of any type as a `HostedScene`, made of a host's values.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <arenite/observe/energy.hpp>
#include <arenite/run/every.hpp>
#include <arenite/run/run.hpp>
#include <arenite/run/saved_state.hpp>
#include <arenite/run/settle.hpp>
#include <arenite/scene/state.hpp>
#include <arenite/watch/watch.hpp>
#include <arenite_host/hosted_scene.hpp>
#include <arenite_host/scene_points.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace detail {

/// Energies of a scene, or of all tiles, which then all ask.
template <class Scene>
HostedEnergies energies_for_host(const Scene& scene) {
  if constexpr (tracks_energy<Scene>) {
    const Energies e = energies(scene);
    return {e.kinetic,  e.strain,   e.stored,   e.plastic, e.contact,
            e.external, e.inserted, e.transfer, e.walls,   e.residual};
  } else {
    throw error("energies: name TrackEnergy{} among the scene's parts");
  }
}
/// The same of the reaction of a wall.
template <class Scene>
std::array<std::vector<double>, 2> reaction_for_host(const Scene& scene, const std::string& wall) {
  if constexpr (Scene::template has_part<Reactions>) {
    const auto found = reaction(scene, wall);
    return {std::vector<double>(found.force.begin(), found.force.end()),
            std::vector<double>(found.impulse.begin(), found.impulse.end())};
  } else {
    throw error("reaction: name Reactions{} among the scene's parts");
  }
}
/// Adds the nodes of a mesh for which `owns(node)` is true, with the velocity field of a body.
template <class Scene, class Owns>
void add_nodes_for_host(HostedNodes& all, const Scene& scene, std::size_t body, Owns&& owns) {
  const auto& field = scene.fields[Scene::field_of(body)];
  for (Index i = 0; i < Scene::Shape::node_count(scene.mesh); ++i) {
    if (!owns(i)) continue;
    const auto x = Scene::Shape::node_position(scene.mesh, i);
    all.mass.push_back(static_cast<double>(field.mass[i]));
    for (int k = 0; k < Scene::D; ++k) {
      all.position.push_back(static_cast<double>(x[k]));
      all.velocity.push_back(static_cast<double>(field.velocity[i][k]));
    }
  }
}

template <class P>
concept can_be_switched_off = requires(P& part) {
  part.switch_off();
};
/// Whether a part of a scene damps; the velocities at the start of the step, which that takes, others ask for, too.
template <class Scene>
inline constexpr bool has_damping = []<class... P>(std::type_identity<std::tuple<P...>>) {
  return (can_be_switched_off<P> || ...);
}(std::type_identity<typename Scene::Parts>{});
template <class Scene>
void switch_off_damping(Scene& scene) {
  scene.for_each_part([](auto& part) {
    if constexpr (can_be_switched_off<std::remove_reference_t<decltype(part)>>) part.switch_off();
  });
}
inline std::string needs_damping(const char* what) {
  return joined_text({what, ": name a part that damps: LocalDamping or ViscousDamping"});
}
template <class Scene>
double out_of_balance_for_host(const Scene& scene) {
  if constexpr (has_damping<Scene>)
    return out_of_balance(scene);
  else
    throw error(needs_damping("out_of_balance"));
}
/// Limits of a run's watch.
inline WatchLimits watch_limits(const HostedRun& run) {
  return run.limits ? read<WatchLimits>(*run.limits, ReadContext{.name = "WatchLimits"}) : WatchLimits();
}
/// The quantities that a watch has checked.
inline std::vector<HostedWatched> seen_by(const Watch& watch) {
  std::vector<HostedWatched> all;
  for (const Watched& w : watch.seen())
    all.push_back(
        {std::string(w.name), std::string(w.meaning), w.limit, w.worst, w.time, w.body, w.place, w.warned});
  return all;
}

}  // namespace detail

/// `values`: names with values: "kinematics", "mesh", "numerics", and "parts", a list in the order of the
/// scene's type; of `Bodies` and `BodyList` a list of fills.
template <class Scene>
class SceneHost : public HostedScene {
 public:
  static constexpr int D = Scene::D;

  explicit SceneHost(std::unique_ptr<Scene> scene) : scene_{std::move(scene)} {}

  int dimension() const override { return D; }
  double time() const override { return scene_->time; }
  double time_step() const override { return scene_->time_step; }
  std::size_t steps() const override { return scene_->steps; }
  std::size_t generation() const override { return generation_; }
  double stable_step() const override { return arenite::stable_step(*scene_); }
  void step(double dt) override {
    const Moved moved(*this);
    arenite::step(*scene_, dt);
  }

  bool run(const HostedRun& run) override {
    const Moved moved(*this);
    std::vector<Every<std::function<RunFlow(const Scene&)>>> timers;
    for (std::size_t k = 0; k < run.periods.size(); ++k)
      timers.emplace_back(run.periods[k], [this, &run, k](const Scene&) {
        look_for_moves();
        return run.due(k) ? RunFlow::stop : RunFlow::go_on;
      });
    if (run.resumed)
      for (auto& timer : timers) timer.resume_at(scene_->time);
    bool first = true;
    watch_ = given_watch(run);
    const auto observe = [&](const Scene& scene) {
      bool stops = false;
      for (auto& timer : timers) stops = timer(scene) == RunFlow::stop || stops;
      look_for_moves();
      if (!first && run.after_step) stops = run.after_step() || stops;
      if (watch_) (*watch_)(scene);
      first = false;
      return stops ? RunFlow::stop : RunFlow::go_on;
    };
    const bool watch = run.watch && !watch_;  // that of `run`
    bool settled = false;
    if (!run.settle)
      arenite::run(*scene_,
                   {.end = run.end, .courant = run.courant, .max_step = run.max_step, .watch = watch},
                   observe);
    else if constexpr (detail::has_damping<Scene>)
      settled = arenite::settle(
          *scene_, {.ratio = *run.settle, .end = run.end, .courant = run.courant, .watch = watch}, observe);
    else
      throw error(detail::needs_damping("settle"));
    if (watch_) watch_->finish(*scene_);
    return settled || !(scene_->time < run.end);
  }
  std::function<double(bool)> steps(const HostedRun& run) override {
    const RunOptions options{.end = run.end, .courant = run.courant, .max_step = run.max_step};
    options.check(scene_->time, true);
    const double span = std::isfinite(options.end) ? options.end - scene_->time : 0;
    return [this, options, span, watch = std::make_shared<LoopWatch>(*this, run)](bool written) {
      if (!(scene_->time < options.end)) return 0.0;
      watch->before(written);
      const Moved moved(*this);
      const double dt = step_towards(*scene_, options, span);
      watch->after(!(scene_->time < options.end));
      return dt;
    };
  }
  std::vector<HostedWatched> watched() const override {
    return watch_ ? detail::seen_by(*watch_) : std::vector<HostedWatched>();
  }
  double out_of_balance() const override { return detail::out_of_balance_for_host(*scene_); }
  void switch_off_damping() override { detail::switch_off_damping(*scene_); }

  std::vector<StateSlot> state() override { return state_slots(*scene_); }

  HostedNodes nodes(std::size_t body) const override {
    HostedNodes all;
    detail::add_nodes_for_host(all, *scene_, body, [](Index) { return true; });
    return all;
  }
  HostedCells cells() const override {
    HostedCells all;
    if constexpr (is_simplex_mesh<typename Scene::Mesh>) {
      all.corners = D + 1;
      for (Index c = 0; c < scene_->mesh.cell_count(); ++c)
        for (const Index i : scene_->mesh.nodes(c)) all.nodes.push_back(i);
    }
    return all;
  }
  HostedEnergies energies() const override { return detail::energies_for_host(*scene_); }
  std::array<std::vector<double>, 2> reaction(const std::string& wall) const override {
    return detail::reaction_for_host(*scene_, wall);
  }

  HostedTotals fill(std::size_t body, const Value& values) override {
    ++generation_;
    return detail::fill_more(*scene_, body, values);
  }
  HostedTotals insert(std::size_t body, const Value& points) override {
    ++generation_;
    return detail::insert_rows(*scene_, body, points);
  }
  HostedTotals remove(std::size_t body, const Value& where) override {
    ++generation_;
    return detail::remove_where(*scene_, body, where);
  }
  HostedProbes probe(std::size_t body, const std::vector<double>& places) const override {
    return detail::probe_places(*scene_, body, places);
  }
  std::vector<double> section_force(std::size_t body, const Value& section, bool of_nodes) const override {
    return detail::force_across(*scene_, body, section, of_nodes);
  }

  void save(const std::string& path, const std::string& recipe) const override {
    save_state(*scene_, SavedState(path, recipe));
  }
  void restore(const std::string& path, const std::string& recipe) override {
    ++generation_;
    restore_state(*scene_, SavedState(path, recipe));
  }
  void follow() override {
    ++generation_;
    follow_state(*scene_);
  }
  std::unique_ptr<HostedScene> copy() const override {
    return std::make_unique<SceneHost>(std::make_unique<Scene>(*scene_));
  }

 private:
  /// A watch with limits, if the run has one.
  static std::shared_ptr<Watch> given_watch(const HostedRun& run) {
    return run.watch && run.limits ? std::make_shared<Watch>(detail::watch_limits(run)) : nullptr;
  }

  /// The watch of a host's own loop. No part accounts for the energy of numbers that the host writes: before
  /// a check that they would falsify, the watch is restarted.
  class LoopWatch {
   public:
    LoopWatch(SceneHost& host, const HostedRun& run)
        : host_{host}, run_{run}, every_{detail::watch_limits(run).every} {
      begin();
    }
    void before(bool written) {
      written_ = written_ || written;
      if (written_ && host_.scene_->steps + 1 >= begun_ + every_) begin();
    }
    void after(bool at_end) {
      look([&](auto& watch) { at_end && !written_ ? watch.finish(*host_.scene_) : watch(*host_.scene_); });
    }

   private:
    void begin() {
      written_ = false;
      begun_ = host_.scene_->steps;
      host_.watch_ = given_watch(run_);
      own_.emplace(*host_.scene_, run_.watch && !host_.watch_, false);
      look([&](auto& watch) { watch(*host_.scene_); });
    }
    template <class F>
    void look(F&& f) {
      if (host_.watch_)
        f(*host_.watch_);
      else
        f(*own_);
    }

    SceneHost& host_;
    HostedRun run_;
    std::size_t every_;  // steps between checks
    std::optional<DefaultWatch> own_{};
    std::size_t begun_ = 0;
    bool written_ = false;
  };

  /// Checks for moved points when a call begins and when it ends, however it ends.
  class Moved {
   public:
    explicit Moved(SceneHost& host) : host_{host} { host.look_for_moves(); }
    ~Moved() { host_.look_for_moves(); }
    Moved(const Moved&) = delete;
    Moved& operator=(const Moved&) = delete;

   private:
    SceneHost& host_;
  };

  /// A step may change the places of points.
  void look_for_moves() {
    if (scene_->steps != seen_) ++generation_;
    seen_ = scene_->steps;
  }

  std::unique_ptr<Scene> scene_;
  std::shared_ptr<Watch> watch_{};  // of the last run
  std::size_t generation_ = 0, seen_ = 0;
};

namespace detail {

/// Reads the recipes of a scene.
template <class Scene>
class SceneReader;

template <class K, class M, class N, class... Given>
class SceneReader<Scene<K, M, N, Given...>> {
 public:
  static constexpr ReadContext at() { return {.name = "Scene", .dimension = M::dimension}; }
  static const Value& given(const Value& values, const char* key) {
    static const Value nothing;
    const Value* const found = values.find(key);
    return found ? *found : nothing;
  }

  /// The same over another mesh, with more parts.
  template <class Mesh, class... More>
  using Over = Scene<K, Mesh, N, Given..., More...>;

  /// `memory`, and the cells that may contain points: of a scene that is cut into tiles.
  template <class Mesh, class Owns = OwnsAllCells, class... More>
  static std::unique_ptr<Over<Mesh, More...>> over(const Mesh& mesh, const Value& values,
                                                   PlaceMemory* memory = nullptr, const Owns& owns = {},
                                                   More... more) {
    using Made = Over<Mesh, More...>;
    return with_parts<Made>(mesh, values, memory, owns, [&](auto&&... part) {
      return std::make_unique<Made>(read<K>(given(values, "kinematics"), at() / "kinematics"), mesh,
                                    read<N>(given(values, "numerics"), at() / "numerics"), std::move(part)...,
                                    std::move(more)...);
    });
  }
  /// Only reads the parts: `memory` then has the values of functions of place in this mesh.
  template <class Mesh>
  static void ask_places(const Mesh& mesh, const Value& values, PlaceMemory& memory) {
    with_parts<Over<Mesh>>(mesh, values, &memory, OwnsAllCells{}, [](auto&&...) {});
  }

 private:
  template <class Made, class Owns, class F>
  static auto with_parts(const typename Made::Mesh& mesh, const Value& values, PlaceMemory* memory,
                         const Owns& owns, F&& f) {
    const auto nodes = node_positions<Made>(mesh);
    ReadContext in_mesh = at();
    in_mesh.nodes = &nodes;
    in_mesh.memory = memory;
    const Value& parts = given(values, "parts");
    const auto* list = parts.template get<Value::List>();
    if (list == nullptr || list->size() != sizeof...(Given))
      at().refuse(parts, joined_text({"must be a list of ", sizeof...(Given), " parts"}));
    return [&]<std::size_t... At>(std::index_sequence<At...>) {
      return f(Part<Made, Given>::read(mesh, (*list)[At], in_mesh[At], owns)...);
    }
    (std::index_sequence_for<Given...>{});
  }
  template <class Made, class P>
  struct Part {
    template <class Owns>
    static P read(const typename Made::Mesh&, const Value& value, const ReadContext& at, const Owns&) {
      return arenite::read<P>(value, at);
    }
  };
  template <class Made, class... F>
  struct Part<Made, Bodies<F...>> {
    template <class Owns>
    static Bodies<F...> read(const typename Made::Mesh& mesh, const Value& value, const ReadContext& in_mesh,
                             const Owns& owns) {
      const ReadContext at = in_mesh.renamed("bodies");
      const auto* list = value.get<Value::List>();
      if (list == nullptr || list->size() != sizeof...(F))
        at.refuse(value, joined_text({"must be a list of ", sizeof...(F), " bodies"}));
      return [&]<std::size_t... At>(std::index_sequence<At...>) {
        return Bodies<F...>{std::tuple<F...>{read_fill<Made, F>(mesh, (*list)[At], at[At], owns)...}};
      }
      (std::index_sequence_for<F...>{});
    }
  };
  template <class Made, class F>
  struct Part<Made, BodyList<F>> {
    template <class Owns>
    static BodyList<F> read(const typename Made::Mesh& mesh, const Value& value, const ReadContext& in_mesh,
                            const Owns& owns) {
      const ReadContext at = in_mesh.renamed("bodies");
      const auto* list = value.get<Value::List>();
      if (list == nullptr || list->empty()) at.refuse(value, "must be a list of bodies");
      BodyList<F> made;
      for (std::size_t k = 0; k < list->size(); ++k)
        made.fills.push_back(read_fill<Made, F>(mesh, (*list)[k], at[k], owns));
      return made;
    }
  };
};

}  // namespace detail

/// Makes a scene of a host's values. Throws `error` as the scene's own constructor does, and for values that
/// do not fit its recipes.
template <class Scene>
std::unique_ptr<HostedScene> make_hosted(const Value& values) {
  using Reader = detail::SceneReader<Scene>;
  const auto mesh = read<typename Scene::Mesh>(Reader::given(values, "mesh"), Reader::at() / "mesh");
  return std::make_unique<SceneHost<Scene>>(Reader::over(mesh, values));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
