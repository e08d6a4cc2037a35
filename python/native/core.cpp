// The native core of the Python package: opens shared objects with compositions, and hands their scenes and
// laws to Python. It knows no composition itself.
#include <dlfcn.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <arenite/io/pvd.hpp>
#include <arenite/io/vtu.hpp>
#include <arenite/run/run_in_folder.hpp>
#include <arenite_host/plugin.hpp>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "checks.hpp"
#include "meshes.hpp"
#include "values.hpp"

namespace arenite::python {

/// Calls `f()` without the interpreter's lock. What a function of Python raised is raised again, in the place
/// of the error that its missing value led to.
template <class F>
std::invoke_result_t<F> without_lock(F&& f) {
  const CallFromPython call;
  const py::gil_scoped_release released;
  try {
    if constexpr (std::is_void_v<std::invoke_result_t<F>>) {
      f();
      Raised::instance().rethrow();
    } else {
      auto result = f();
      Raised::instance().rethrow();
      return result;
    }
  } catch (const error&) {
    Raised::instance().rethrow();
    throw;
  }
}

/// A function of a shared object; `without`: what an object lacks that has none.
template <class Function>
Function* function_of(const std::string& path, const char* name, const char* without) {
  void* const object = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (object == nullptr) throw error(joined_text({"arenite: cannot open ", path, ": ", dlerror()}));
  const auto found = reinterpret_cast<Function*>(dlsym(object, name));
  if (found == nullptr) throw error(joined_text({"arenite: ", path, " ", without}));
  return found;
}

/// The ranks that have the tiles of scenes: those of MPI, which a shared object of the machine's MPI makes of the address of a
/// communicator, or only this process.
class RanksHandle {
 public:
  RanksHandle() : ranks_{new OneRank, [](Ranks* r) { delete r; }} {}
  RanksHandle(const std::string& path, std::uintptr_t communicator)
      : ranks_{make_ranks(path, communicator), find<void(Ranks*)>(path, "arenite_end_ranks")} {}

  /// Of the MPI that a shared object is linked with.
  static std::string version(const std::string& path) {
    return find<const char*()>(path, "arenite_mpi_version")();
  }
  Ranks& operator*() const { return *ranks_; }

 private:
  template <class Function>
  static Function* find(const std::string& path, const char* name) {
    return function_of<Function>(path, name, "makes no ranks of MPI");
  }
  static Ranks* make_ranks(const std::string& path, std::uintptr_t communicator) {
    return find<Ranks*(std::uintptr_t)>(path, "arenite_ranks")(communicator);
  }

  std::unique_ptr<Ranks, void (*)(Ranks*)> ranks_;
};

/// A scene in Python. One thread uses it at a time, and functions that a step calls not at all.
class SceneHandle {
 public:
  /// `ranks`: of a scene that is cut into tiles.
  explicit SceneHandle(std::unique_ptr<HostedScene> scene, std::shared_ptr<RanksHandle> ranks = nullptr)
      : ranks_{std::move(ranks)}, scene_{std::move(scene)} {}

  /// Calls `f(scene)` without the interpreter's lock.
  template <class F>
  auto outside(F&& f) {
    const Use use(in_use_);
    return without_lock([&] { return f(*scene_); });
  }
  /// Calls `f(scene)` with it.
  template <class F>
  auto inside(F&& f) {
    const Use use(in_use_);
    return f(*scene_);
  }

  /// Runs to `end`; calls `due(k)` when period k is due, `after_step()` after each step, and `now_and_then()`
  /// some times a second, all between steps, where they may use the scene; one of the first two that returns
  /// true ends the run. Returns what `HostedScene::run` does.
  bool run(double end, double courant, double max_step, std::optional<double> settle, bool resumed,
           std::vector<double> periods, const py::function& due,
           const std::optional<py::function>& after_step, py::handle watch,
           const std::optional<py::function>& now_and_then) {
    HostedRun run = run_of(end, courant, max_step, watch);
    run.settle = settle;
    run.resumed = resumed;
    run.periods = std::move(periods);
    const auto call = [&](const py::function& f, auto... arguments) {
      const py::gil_scoped_acquire lock;
      const Pause pause(in_use_);
      try {
        return f(arguments...).template cast<bool>();
      } catch (const py::error_already_set& e) {
        Raised::instance().keep(std::current_exception());
        const std::string told = e.what();  // other ranks need no traceback
        throw run_error(told.substr(0, told.find("\n\nAt:")));
      }
    };
    using Clock = std::chrono::steady_clock;
    auto looked = Clock::now();
    run.due = [&](std::size_t k) { return call(due, k); };
    run.each_step = after_step.has_value();
    run.after_step = [&] {
      const bool stops = after_step && call(*after_step);
      if (const auto now = Clock::now(); now - looked > std::chrono::milliseconds(20)) {
        looked = now;
        const py::gil_scoped_acquire lock;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        const Pause pause(in_use_);
        if (now_and_then) (*now_and_then)();
      }
      return stops;
    };
    return outside([&](HostedScene& scene) { return scene.run(run); });
  }

  /// The same without callbacks, one step at each call of what is returned, which returns its length; 0 at
  /// the end.
  static py::cpp_function steps(py::object self, double end, double courant, double max_step,
                                py::handle watch) {
    const HostedRun run = run_of(end, courant, max_step, watch);
    const auto next = self.cast<SceneHandle&>().outside([&](HostedScene& scene) { return scene.steps(run); });
    return [self = std::move(self), next](bool written) {
      return self.cast<SceneHandle&>().outside([&](HostedScene&) { return next(written); });
    };
  }

  /// The numbers of a value of the state, where they are; Python's side checks that they still are.
  static py::array column(const StateSlot& entry, const py::object& owner) {
    const std::string type =
        entry.kind == 'b' ? "?" : std::string(1, entry.kind) + std::to_string(entry.bytes);
    return py::array(py::dtype(type), std::vector<py::ssize_t>{static_cast<py::ssize_t>(entry.count)},
                     std::vector<py::ssize_t>{static_cast<py::ssize_t>(entry.bytes)}, entry.data, owner);
  }

 private:
  /// `watch`: whether it is watched, or limits by name.
  static HostedRun run_of(double end, double courant, double max_step, py::handle watch) {
    return {.end = end,
            .courant = courant,
            .max_step = max_step,
            .watch = !watch.is(py::bool_(false)),
            .limits = py::isinstance<py::dict>(watch) ? std::optional(value_of(watch)) : std::nullopt};
  }

  /// The scene at work; the flag is read and written only with the interpreter's lock.
  class Use {
   public:
    explicit Use(bool& in_use) : in_use_{in_use} {
      if (in_use)
        throw error(
            "Scene: is within a step: neither another thread nor a function that the step calls may "
            "use it");
      in_use = true;
    }
    ~Use() { in_use_ = false; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    bool& in_use_;
  };
  /// Between two steps of a run.
  class Pause {
   public:
    explicit Pause(bool& in_use) : in_use_{in_use} { in_use = false; }
    ~Pause() { in_use_ = true; }
    Pause(const Pause&) = delete;
    Pause& operator=(const Pause&) = delete;

   private:
    bool& in_use_;
  };

  std::shared_ptr<RanksHandle> ranks_;  // outlive the scene
  std::unique_ptr<HostedScene> scene_;
  bool in_use_ = false;
};

/// A shared object with compositions.
class PluginHandle {
 public:
  /// Warnings are Python's.
  static void warn_in_python(const std::string& text) {
    const py::gil_scoped_acquire lock;
    const py::object category = py::module_::import("arenite._errors").attr("Warning");
    if (PyErr_WarnEx(category.ptr(), text.c_str(), 2) == 0) return;
    if (may_throw()) throw py::error_already_set();
    py::error_already_set raised;
    Raised::instance().keep(std::make_exception_ptr(raised));
  }

  explicit PluginHandle(const std::string& path) : path_{path} {
    plugin_ = function_of<const Plugin*()>(path, "arenite_plugin", "holds no compositions")();
    if (plugin_->version != library_version)
      throw error(
          joined_text({"arenite: ", path, " is of version ", plugin_->version, ", not ", library_version}));
    plugin_->on_warning(&warn_in_python);
  }

  const Plugin& operator*() const { return *plugin_; }
  const Plugin* operator->() const { return plugin_; }

  std::vector<std::string> scenes() const { return types(plugin_->scenes); }
  std::vector<std::string> laws() const { return types(plugin_->laws); }
  std::vector<std::string> tiles() const { return types(plugin_->tiles); }

  SceneHandle scene(const std::string& type, py::handle values) const {
    const Value given = value_of(values);
    const auto& maker = find(plugin_->scenes, type);
    return without_lock([&] { return SceneHandle(maker.make(given)); });
  }
  SceneHandle scene_in_tiles(const std::string& type, py::handle values, std::shared_ptr<RanksHandle> ranks,
                             TileOptions cut, RebalanceOptions moves) const {
    const Value given = value_of(values);
    const auto& maker = find(plugin_->tiles, type);
    return without_lock([&] {
      auto scene = maker.make(given, **ranks, cut, moves);
      return SceneHandle(std::move(scene), std::move(ranks));
    });
  }
  std::shared_ptr<HostedLaw> law(const std::string& type, py::handle values) const {
    const Value given = value_of(values);
    const auto& maker = find(plugin_->laws, type);
    return without_lock([&] { return std::shared_ptr<HostedLaw>(maker.make(given)); });
  }

 private:
  template <class Makers>
  static std::vector<std::string> types(const Makers& makers) {
    std::vector<std::string> all;
    for (const auto& m : makers) all.push_back(m.type);
    return all;
  }
  template <class Makers>
  const typename Makers::value_type& find(const Makers& makers, const std::string& type) const {
    for (const auto& m : makers)
      if (m.type == type) return m;
    throw error(joined_text({"arenite: ", path_, " does not hold ", type}));
  }

  std::string path_;
  const Plugin* plugin_;
};

namespace {

using Rows = py::array_t<double, py::array::c_style>;
using RowsIn = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Columns of stresses: 4 in the plane, 6 in space.
int dimension_of(const py::array& stress) {
  const auto columns = stress.ndim() == 2 ? stress.shape(1) : 0;
  if (columns != 4 && columns != 6)
    throw error(joined_text({"stress: shape: must be [n, 6], or [n, 4] in the plane"}));
  return columns == 6 ? 3 : 2;
}
void check_rows(const char* name, const py::array& a, py::ssize_t n, py::ssize_t columns) {
  if (a.ndim() == 2 && a.shape(0) == n && a.shape(1) == columns) return;
  throw error(joined_text({name, ": shape: must be [", n, ", ", columns, "]"}));
}

py::tuple update(const HostedLaw& law, RowsIn stress, RowsIn strain, std::optional<RowsIn> spin, double dt,
                 std::optional<RowsIn> history) {
  const int dimension = dimension_of(stress);
  const py::ssize_t n = stress.shape(0), h = static_cast<py::ssize_t>(law.history_start().size());
  check_rows("strain", strain, n, stress.shape(1));
  if (spin) check_rows("spin", *spin, n, dimension == 2 ? 1 : 3);
  Rows stress_after({n, stress.shape(1)}), history_after({n, h}), opening(n), dilation(n);
  std::copy_n(stress.data(), stress.size(), stress_after.mutable_data());
  if (history) {
    check_rows("history", *history, n, h);
    std::copy_n(history->data(), history->size(), history_after.mutable_data());
  } else {
    const auto start = law.history_start();
    for (py::ssize_t p = 0; p < n; ++p)
      std::copy(start.begin(), start.end(), history_after.mutable_data() + p * h);
  }
  const HostedUpdate u{.dimension = dimension,
                       .n = static_cast<std::size_t>(n),
                       .dt = dt,
                       .stress = stress_after.mutable_data(),
                       .strain = strain.data(),
                       .spin = spin ? spin->data() : nullptr,
                       .history = history_after.mutable_data(),
                       .opening = opening.mutable_data(),
                       .dilation = dilation.mutable_data()};
  {
    const py::gil_scoped_release released;
    law.update(u);
  }
  return py::make_tuple(stress_after, history_after, opening, dilation);
}

py::array_t<double> energy(const HostedLaw& law, RowsIn stress, std::optional<RowsIn> history) {
  const int dimension = dimension_of(stress);
  const py::ssize_t n = stress.shape(0), h = static_cast<py::ssize_t>(law.history_start().size());
  if (history) check_rows("history", *history, n, h);
  if (!history && h > 0) throw error("history: nothing: must be given for a law that has one");
  Rows out(n);
  double* const to = out.mutable_data();
  const double *s = stress.data(), *m = history ? history->data() : nullptr;
  const py::gil_scoped_release released;
  law.elastic_energy(dimension, static_cast<std::size_t>(n), s, m, to);
  return out;
}

py::dict drive(const HostedLaw& law, int dimension, py::handle stages, std::vector<double> stress,
               std::vector<double> history) {
  const Value given = value_of(stages);
  if (history.empty()) history = law.history_start();
  HostedPath path;
  {
    const py::gil_scoped_release released;
    path = law.drive(dimension, given, stress, history);
  }
  const auto rows = static_cast<py::ssize_t>(path.rows);
  py::dict all;
  const auto add = [&](const char* name, const std::vector<double>& numbers) {
    const auto columns = rows > 0 ? static_cast<py::ssize_t>(numbers.size()) / rows : 0;
    all[name] = numpy_of(numbers, {rows, columns});
  };
  add("stress", path.stress);
  add("strain", path.strain);
  add("history", path.history);
  all["time"] = numpy_of(path.time, {rows});
  all["opening"] = numpy_of(path.opening, {rows});
  all["dilation"] = numpy_of(path.dilation, {rows});
  all["work"] = numpy_of(path.work, {rows});
  return all;
}

/// Numbers of an array for a VTU file, fetched while it is written.
VtuArray vtu_of(const std::string& name, const RowsIn& a) {
  const std::size_t components = a.ndim() == 2 ? static_cast<std::size_t>(a.shape(1)) : 1;
  return vtu_array(name, components, std::span<const double>(a.data(), static_cast<std::size_t>(a.size())));
}

/// Writes points [n, 3] with their fields, as vertices or as the corners of cells [m, k].
void write_points(const std::string& path, const RowsIn& position,
                  std::optional<py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast>> cells,
                  const std::map<std::string, RowsIn>& fields) {
  const auto n = static_cast<std::size_t>(position.shape(0));
  VtuData data{vtu_of("position", position), {vtu_vertices(n)}, {}, {}};
  if (cells) {
    const auto corners = static_cast<std::size_t>(cells->shape(1));
    data.cells = {{corners, static_cast<std::size_t>(cells->shape(0)),
                   [from = cells->data(), corners](std::size_t cell, std::size_t corner) {
                     return static_cast<Index>(from[cell * corners + corner]);
                   }}};
  }
  for (const auto& [name, rows] : fields) data.point_data.push_back(vtu_of(name, rows));
  const py::gil_scoped_release released;
  write_vtu(path, data);
}

py::tuple totals_of(const HostedTotals& t) {
  return py::make_tuple(t.count, t.mass, t.momentum, t.kinetic_energy, t.strain_energy);
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "Native core of arenite: scenes and laws of compositions in shared objects.";
  m.attr("version") = std::string(library_version);
  on_warning(&PluginHandle::warn_in_python);
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const run_error& e) {
      py::set_error(py::module_::import("arenite._errors").attr("RunError"), e.what());
    } catch (const error& e) {
      py::set_error(py::module_::import("arenite._errors").attr("Error"), e.what());
    }
  });

  m.def("supports", [](const std::string& feature) -> bool {
    __builtin_cpu_init();
    if (feature == "avx2") return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (feature == "avx512")
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
    return true;
  });

  m.def("check", [](const std::string& recipe, py::handle values) {
    const CallFromPython call;
    check_recipe(recipe, value_of(values));
  });
  m.def("check_together", &check_together);
  m.def("checked_recipes", &checked_recipes);
  m.def("frictions", &frictions);
  m.def("check_scene", [](const std::string& mesh_type, py::handle mesh,
                          const std::vector<std::string>& types, py::handle parts) {
    const CallFromPython call;
    check_scene(mesh_type, value_of(mesh), types, value_of(parts));
  });
  add_meshes(m);

  py::class_<Signal>(m, "Signal")
      .def(py::init<>())
      .def("get", [](const Signal& s) { return *s.value; })
      .def("set", [](Signal& s, std::array<double, 3> v) { *s.value = v; });

  py::class_<RanksHandle, std::shared_ptr<RanksHandle>>(m, "Ranks")
      .def(py::init<>())
      .def(py::init<std::string, std::uintptr_t>())
      .def_static("version", &RanksHandle::version)
      .def_property_readonly("rank", [](const RanksHandle& r) { return (*r).rank(); })
      .def_property_readonly("size", [](const RanksHandle& r) { return (*r).size(); })
      .def("gather",
           [](const RanksHandle& r, const std::vector<double>& numbers) {
             return without_lock([&] { return (*r).gather(numbers); });
           })
      .def("agree",
           [](const RanksHandle& r, const std::string& asks,
              std::vector<std::pair<std::string, std::string>> given) {
             without_lock([&] { (*r).agree({asks, std::move(given)}); });
           })
      .def("leave", [](const RanksHandle& r) { (*r).leave(); })
      .def("fail", [](const RanksHandle& r, const std::string& what) { (*r).fail(what); });

  py::class_<PluginHandle>(m, "Plugin")
      .def(py::init<std::string>())
      .def("scenes", &PluginHandle::scenes)
      .def("laws", &PluginHandle::laws)
      .def("scene", &PluginHandle::scene)
      .def("law", &PluginHandle::law)
      .def("tiles", &PluginHandle::tiles)
      .def("scene_in_tiles",
           [](const PluginHandle& p, const std::string& type, py::handle values,
              std::shared_ptr<RanksHandle> ranks, int tiles, std::vector<double> weights,
              std::vector<int> tile, int every, double most) {
             return p.scene_in_tiles(type, values, std::move(ranks),
                                     {.tiles = tiles, .weights = std::move(weights), .tile = std::move(tile)},
                                     {.every = every, .most = most});
           })
      .def("set_threads", [](const PluginHandle& p, int n) { p->set_threads(n); });

  m.def("write_vtu", &write_points);
  py::class_<PvdWriter>(m, "PvdWriter")
      .def(py::init<std::filesystem::path, bool>())
      .def("kept",
           [](const PvdWriter& pvd, double time, bool resumed, bool warns) {
             const CallFromPython call;
             std::vector<std::tuple<double, std::string, int>> files;
             for (const auto& [at, file, part] : kept_entries(pvd.path(), time, resumed, warns))
               files.emplace_back(at, file.string(), part);
             return files;
           })
      .def("replace", [](PvdWriter& pvd, const std::vector<std::tuple<double, std::string, int>>& files) {
        std::vector<PvdEntry> entries;
        for (const auto& [time, file, part] : files) entries.push_back({time, file, part});
        pvd.replace(std::move(entries));
      });

  struct Folder {
    std::unique_ptr<RunFolder> held;
  };
  py::class_<Folder>(m, "RunFolder")
      .def(py::init([](const std::filesystem::path& path, bool kept) {
        const CallFromPython call;
        const auto earlier = kept ? RunFolder::Earlier::kept : RunFolder::Earlier::removed;
        return Folder{std::make_unique<RunFolder>(path, earlier, names_of_record("folder"))};
      }))
      .def("free_reserve", [](Folder& folder) { folder.held->free_reserve(); })
      .def("close", [](Folder& folder) { folder.held.reset(); });
  m.def("utc_now", &utc_now);
  m.def("write_run_status",
        [](const std::filesystem::path& file, const std::string& status, const std::string& failure,
           const std::string& started, const std::array<double, 3>& time_end_wall, std::size_t steps,
           std::size_t points, std::size_t lost_points, const std::vector<double>& resumed_at) {
          const auto [time, end, wall] = time_end_wall;
          write_run_status(file, {.status = status,
                                  .failure = failure,
                                  .started = started,
                                  .updated = utc_now(),
                                  .time = time,
                                  .end = end,
                                  .steps = steps,
                                  .points = points,
                                  .lost_points = lost_points,
                                  .wall = wall,
                                  .resumed_at = resumed_at});
        });

  py::class_<HostedLaw, std::shared_ptr<HostedLaw>>(m, "Law")
      .def("density", &HostedLaw::density)
      .def("wave_modulus", &HostedLaw::wave_modulus)
      .def("history_names", &HostedLaw::history_names)
      .def("history_start", &HostedLaw::history_start)
      .def("update", &update)
      .def("elastic_energy", &energy)
      .def("drive", &drive);

  using Scene = HostedScene;
  const auto getter = [](auto f) {
    return [f](SceneHandle& h) { return h.inside([&](Scene& s) { return f(s); }); };
  };
  py::class_<SceneHandle>(m, "Scene")
      .def("time", getter([](Scene& s) { return s.time(); }))
      .def("time_step", getter([](Scene& s) { return s.time_step(); }))
      .def("steps", getter([](Scene& s) { return s.steps(); }))
      .def("generation", getter([](Scene& s) { return s.generation(); }))
      .def("stable_step", [](SceneHandle& h) { return h.outside([](Scene& s) { return s.stable_step(); }); })
      .def("step", [](SceneHandle& h, double dt) { h.outside([&](Scene& s) { s.step(dt); }); })
      .def("run", &SceneHandle::run)
      .def("steps", &SceneHandle::steps)
      .def("watched",
           [](SceneHandle& h) {
             py::list all;
             for (const HostedWatched& w : h.inside([](Scene& s) { return s.watched(); }))
               all.append(
                   py::make_tuple(w.name, w.meaning, w.limit, w.worst, w.time, w.body, w.place, w.warned));
             return all;
           })
      .def("out_of_balance",
           [](SceneHandle& h) { return h.outside([](Scene& s) { return s.out_of_balance(); }); })
      .def("switch_off_damping", [](SceneHandle& h) { h.outside([](Scene& s) { s.switch_off_damping(); }); })
      .def("columns",
           [](py::object self) {
             auto& h = self.cast<SceneHandle&>();
             py::dict all;
             for (const auto& e : h.inside([](Scene& s) { return s.state(); }))
               all[py::str(e.name)] = h.column(e, self);
             return all;
           })
      .def("nodes",
           [](SceneHandle& h, std::size_t body) {
             const HostedNodes n = h.outside([&](Scene& s) { return s.nodes(body); });
             const auto rows = static_cast<py::ssize_t>(n.mass.size());
             const py::ssize_t d = h.inside([](Scene& s) { return s.dimension(); });
             return py::make_tuple(numpy_of(n.position, {rows, d}), numpy_of(n.mass, {rows}),
                                   numpy_of(n.velocity, {rows, d}));
           })
      .def("cells",
           [](SceneHandle& h) -> py::object {
             const HostedCells c = h.outside([](Scene& s) { return s.cells(); });
             if (c.corners == 0) return py::none();
             py::array_t<std::size_t> a({c.nodes.size() / c.corners, c.corners});
             std::copy(c.nodes.begin(), c.nodes.end(), a.mutable_data());
             return a;
           })
      .def("energies",
           [](SceneHandle& h) {
             const HostedEnergies e = h.outside([](Scene& s) { return s.energies(); });
             return py::make_tuple(e.kinetic, e.strain, e.stored, e.plastic, e.contact, e.external,
                                   e.inserted, e.transfer, e.walls, e.residual);
           })
      .def("reaction",
           [](SceneHandle& h, const std::string& wall) {
             return h.outside([&](Scene& s) { return s.reaction(wall); });
           })
      .def("fill",
           [](SceneHandle& h, std::size_t body, py::handle fill) {
             const Value given = value_of(fill);
             return totals_of(h.outside([&](Scene& s) { return s.fill(body, given); }));
           })
      .def("insert",
           [](SceneHandle& h, std::size_t body, py::handle points) {
             const Value given = value_of(points);
             return totals_of(h.outside([&](Scene& s) { return s.insert(body, given); }));
           })
      .def("remove",
           [](SceneHandle& h, std::size_t body, py::handle where) {
             const Value given = value_of(where);
             return totals_of(h.outside([&](Scene& s) { return s.remove(body, given); }));
           })
      .def("probe",
           [](SceneHandle& h, std::size_t body, const RowsIn& places) {
             const int dimension = h.inside([](Scene& s) { return s.dimension(); });
             if (places.ndim() != 2 || places.shape(1) != dimension)
               throw error(joined_text({"probe: places: must be [n, ", dimension, "]"}));
             const std::vector<double> at(places.data(), places.data() + places.size());
             const HostedProbes found = h.outside([&](Scene& s) { return s.probe(body, at); });
             const py::ssize_t n = places.shape(0);
             return py::make_tuple(numpy_of(found.velocity, {n, dimension}),
                                   numpy_of(found.stress, {n, dimension == 2 ? 4 : 6}));
           })
      .def("section_force",
           [](SceneHandle& h, std::size_t body, py::handle section, bool of_nodes) {
             const Value given = value_of(section);
             return h.outside([&](Scene& s) { return s.section_force(body, given, of_nodes); });
           })
      .def("save", [](SceneHandle& h, const std::string& path,
                      const std::string& recipe) { h.outside([&](Scene& s) { s.save(path, recipe); }); })
      .def("restore",
           [](SceneHandle& h, const std::string& path, const std::string& recipe) {
             h.outside([&](Scene& s) { s.restore(path, recipe); });
           })
      .def("follow", [](SceneHandle& h) { h.outside([](Scene& s) { s.follow(); }); })
      .def("copy", [](SceneHandle& h) { return SceneHandle(h.outside([](Scene& s) { return s.copy(); })); });
}

}  // namespace arenite::python
