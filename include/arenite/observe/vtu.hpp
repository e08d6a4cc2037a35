// VTU files of a scene: points and mesh, for ParaView.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <arenite/core/array_memory.hpp>
#include <arenite/io/pvd.hpp>
#include <arenite/io/vtu.hpp>
#include <arenite/law/with_deviatoric_strain.hpp>
#include <arenite/scene/scene.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

template <class T, int D>
std::array<T, 3> three(const Vec<T, D>& v) {
  if constexpr (D == 2)
    return {v[0], v[1], T(0)};
  else
    return {v[0], v[1], v[2]};
}

template <class T, int D>
std::array<T, 6> six(const Sym<T, D>& s) {
  if constexpr (D == 2)
    return {s[0], s[1], s[2], s[3], T(0), T(0)};
  else
    return {s[0], s[1], s[2], s[3], s[4], s[5]};
}

}  // namespace detail

/// What of the points goes into a file, besides position, velocity, stress, pressure and V/V0.
struct VtuPoints {
  /// Named members of the law's history; none given: all. Bodies whose law lacks one go without.
  std::optional<std::vector<std::string>> history{};
  bool mass = false;  ///< kg
  bool id = false;    ///< of a scene with `PointIds`
};

/// Points of a body: velocity, stress (xx, yy, zz, xy, yz, zx), mean pressure (compression positive), V/V0,
/// the deviatoric strain of a `WithDeviatoricStrain` law, and the named members of the law's history. The
/// body must outlive what is returned.
template <class L, class T, int D, ExtraColumns E>
VtuData points_vtu(const Body<L, T, D, E>& body, const VtuPoints& wanted = {}) {
  const auto& points = body.points;
  const std::size_t n = points.size();
  const T density = static_cast<T>(body.law.density());
  VtuData data{
      vtu_array("position", n, [&points](std::size_t p) { return detail::three<T, D>(points.position[p]); }),
      {vtu_vertices(n)},
      {vtu_array("velocity", n, [&points](std::size_t p) { return detail::three<T, D>(points.velocity[p]); }),
       vtu_array("stress", n, [&points](std::size_t p) { return detail::six<T, D>(points.stress[p]); }),
       vtu_array("pressure", n, [&points](std::size_t p) { return T(-trace(points.stress[p]) / 3); }),
       vtu_array(
           "volume_ratio", n,
           [&points, density](std::size_t p) { return T(points.volume[p] * density / points.mass[p]); })},
      {}};
  if constexpr (has_deviatoric_strain<L>)
    data.point_data.push_back(vtu_array("deviatoric_strain", n, [&points](std::size_t p) {
      return L::deviatoric_strain(points.load_history(p));
    }));
  for (std::size_t k = 0; k < points.history.size(); ++k)
    if (const auto name = history_names<typename L::template History<T>>[k];
        !name.empty() && (!wanted.history || std::ranges::count(*wanted.history, name) > 0))
      data.point_data.push_back(vtu_array(std::string(name), 1, points.history[k]));
  if (wanted.mass) data.point_data.push_back(vtu_array("mass", 1, points.mass));
  if constexpr (Points<T, D, L, E>::has_ids) {
    if (wanted.id)
      data.point_data.push_back(
          vtu_array("id", n, [&points](std::size_t p) { return static_cast<std::int64_t>(points.id[p]); }));
  } else {
    require(!wanted.id, "VtuPoints.id", wanted.id, "needs a scene with PointIds{}");
  }
  return data;
}

/// Cells of a simplex mesh with their region; only those of region `only` if it is not negative. The mesh
/// must outlive what is returned.
template <int D, class T>
VtuData mesh_vtu(const SimplexMesh<D, T>& mesh, int only = -1) {
  std::vector<Index> cells;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    if (only < 0 || mesh.region(c) == only) cells.push_back(c);
  const std::size_t n = cells.size();
  return {
      vtu_array("position", mesh.node_count(),
                [&mesh](std::size_t i) { return detail::three<T, D>(mesh.position(static_cast<Index>(i))); }),
      {VtuCells{D + 1, n, [&mesh, cells](std::size_t c, std::size_t k) { return mesh.nodes(cells[c])[k]; }}},
      {},
      {vtu_array("region", n,
                 [&mesh, cells](std::size_t c) { return std::int32_t{mesh.region(cells[c])}; })}};
}

/// `body_names`: in the order of the bodies, for their names in the scene ("body0", .. if they have none);
/// `mesh`: write a simplex mesh too; `region`: and one of its regions apart.
struct VtuOptions {
  std::vector<std::string> body_names{};
  bool mesh = false;
  std::string region{};
  VtuPoints points{};    ///< more and fewer numbers of the points
  bool resumed = false;  ///< goes on with the series that is there, behind its frames before the scene's time
};

namespace detail {

/// The folder of files `prefix`_.., made if it is not there; returns the prefix.
inline std::filesystem::path named(std::filesystem::path path, std::string_view end) { return path += end; }
inline const std::filesystem::path& make_folder(const std::filesystem::path& prefix) {
  std::error_code code;
  if (prefix.has_parent_path()) std::filesystem::create_directories(prefix.parent_path(), code);
  require(!code, "vtu: folder", prefix.parent_path().string(),
          {"cannot be made: ", code.message()});
  return prefix;
}

/// Names of what a frame consists of: bodies, mesh, region.
template <class Scene>
auto frame_parts(const VtuOptions& options) {
  std::vector<std::string, ArrayMemory<std::string>> names;
  for (std::size_t k = 0; k < Scene::body_count; ++k)
    names.push_back(k < options.body_names.size()  ? options.body_names[k]
                    : Scene::body_names[k].empty() ? joined_text({"body", k})
                                                   : Scene::body_name(k));
  if constexpr (is_simplex_mesh<typename Scene::Mesh>) {
    if (options.mesh) names.emplace_back("mesh");
    if (!options.region.empty()) names.push_back(options.region);
  }
  return names;
}

/// Calls `f(data)` for each of them.
template <class Scene, class F>
void for_each_frame_part(const Scene& scene, const VtuOptions& options, F&& f) {
  scene.for_each_body([&](const auto& body, const auto&) { f(points_vtu(body, options.points)); });
  if constexpr (is_simplex_mesh<typename Scene::Mesh>) {
    if (options.mesh) f(mesh_vtu(scene.mesh));
    if (!options.region.empty()) f(mesh_vtu(scene.mesh, scene.mesh.region_number(options.region)));
  }
}

}  // namespace detail

/// Observer that writes the points of each body as PREFIX_body0_0000.vtu, .., the listed parts of the mesh,
/// and PREFIX.pvd, which ParaView opens as one series. Creates the folder. Use with `every(period,
/// vtu(prefix))`. Restored with a state, or `resumed`, it goes on with the series; else one of an earlier run
/// is replaced with a warning, and kept by an `error` if the scene is past its first frame.
class VtuSeries {
 public:
  explicit VtuSeries(std::filesystem::path prefix, VtuOptions options = {})
      : prefix_{std::move(prefix)},
        options_{std::move(options)},
        pvd_{detail::named(detail::make_folder(prefix_), ".pvd"), true} {}

  template <class Scene>
  void operator()(const Scene& scene) {
    if (times_.empty()) {
      times_ = kept_times(pvd_.path(), pvd_times(pvd_.path()), scene.time, options_.resumed);
      follow_state(scene);
    }
    const bool again = !times_.empty() && times_.back() == scene.time;  // at the start of a run that goes on
    const std::size_t frame = times_.size() - (again ? 1 : 0);
    std::size_t part = 0;
    const auto names = detail::frame_parts<Scene>(options_);
    detail::for_each_frame_part(scene, options_, [&](const VtuData& data) {
      const auto file = file_of(names[part], frame);
      write_vtu(file, data);
      if (!again) pvd_.add(scene.time, file, static_cast<int>(part));
      ++part;
    });
    if (!again) times_.push_back(scene.time);
  }

  /// Times of the files so far, s.
  template <class F>
  void visit_state(F&& f) {
    f("times", times_);
  }
  /// Lists the files of an earlier part of the run, which must be there.
  template <class Scene>
  void follow_state(const Scene&) {
    const auto names = detail::frame_parts<Scene>(options_);
    std::vector<PvdEntry> entries;
    for (std::size_t frame = 0; frame < times_.size(); ++frame)
      for (std::size_t part = 0; part < names.size(); ++part)
        entries.push_back({times_[frame], file_of(names[part], frame), static_cast<int>(part)});
    pvd_.replace(std::move(entries));
  }

 private:
  std::filesystem::path file_of(const std::string& name, std::size_t frame) const {
    std::string digits = std::to_string(frame);
    digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
    return detail::named(prefix_, joined_text({"_", name, "_", digits, ".vtu"}));
  }

  std::filesystem::path prefix_;
  VtuOptions options_;
  PvdWriter pvd_;
  std::vector<double> times_;  // [frames] s
};

/// Observer that writes files `prefix`_..: see `VtuSeries`.
inline VtuSeries vtu(std::filesystem::path prefix, VtuOptions options) {
  return VtuSeries(std::move(prefix), std::move(options));
}
inline VtuSeries vtu(std::filesystem::path prefix) { return VtuSeries(std::move(prefix)); }

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
