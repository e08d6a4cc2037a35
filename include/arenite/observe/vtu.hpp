// VTU files of a scene: points and mesh, for ParaView.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/io/file_path.hpp>
#include <arenite/io/pvd.hpp>
#include <arenite/io/vtu.hpp>
#include <arenite/law/with_deviatoric_strain.hpp>
#include <arenite/observe/point_columns.hpp>
#include <arenite/parallel/array_memory.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Data of the points in a file, besides position, velocity, stress, pressure and V/V0.
struct VtuPoints {
  /// Named members of the law's history; none given: all. Bodies whose law lacks one go without.
  std::optional<std::vector<std::string>> history{};
  bool mass = false;  ///< kg
  bool id = false;    ///< of a scene with `PointIds`
};

namespace detail {

/// Columns of points that a law and a scene add. `arrays`: of the law, after those that all bodies have.
template <class T>
struct MorePoints {
  std::vector<VtuArray> arrays{};
  std::span<const std::string_view> names{};  // of the history's columns, if they have some
  std::vector<const T*> history{};
  const std::vector<std::uint64_t>* id = nullptr;  // null: points have no ids
};

template <class T>
VtuData columns_vtu(const PointColumns<T>& columns, const VtuPoints& wanted, MorePoints<T> more);

}  // namespace detail

/// Points of a body: velocity, stress (xx, yy, zz, xy, yz, zx), mean pressure (compression positive), V/V0,
/// the deviatoric strain of a `WithDeviatoricStrain` law, and the named members of the law's history. The
/// body must outlive what is returned, and no point may be added to it or taken from it meanwhile.
template <class L, class T, int D, ExtraColumns E>
VtuData points_vtu(const Body<L, T, D, E>& body, const VtuPoints& wanted = {}) {
  const auto& points = body.points;
  detail::MorePoints<T> more{.names = history_names<typename L::template History<T>>};
  if constexpr (has_deviatoric_strain<L>)
    more.arrays.push_back(vtu_array("deviatoric_strain", points.size(), [&points](std::size_t p) {
      return L::deviatoric_strain(points.load_history(p));
    }));
  for (const auto& column : points.history) more.history.push_back(column.data());
  if constexpr (Points<T, D, L, E>::has_ids) more.id = &points.id;
  return detail::columns_vtu(columns_of_points(body), wanted, std::move(more));
}

/// Cells of a simplex mesh with their region; only those of the regions `only` if there are any. The mesh
/// must outlive what is returned.
template <int D, class T>
VtuData mesh_vtu(const SimplexMesh<D, T>& mesh, const std::vector<int>& only = {}) {
  std::vector<Index> cells;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    if (only.empty() || mesh.is_in(c, only)) cells.push_back(c);
  const std::size_t n = cells.size();
  return {
      vtu_array("position", mesh.node_count(),
                [&mesh](std::size_t i) {
                  const auto x = mesh.position(static_cast<Index>(i));
                  return std::array{x[0], x[1], D == 3 ? x[D - 1] : T(0)};
                }),
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
  bool resumed = false;  ///< continues the series that is there, after its frames before the scene's time
};

namespace detail {

using VtuNames = std::vector<std::string, ArrayMemory<std::string>>;

/// Names of the parts of a frame: bodies, those beyond `names` by their numbers, mesh, region.
VtuNames frame_parts(const VtuOptions& options, std::size_t bodies, std::span<const std::string_view> names,
                     bool has_mesh);
template <class Scene>
VtuNames frame_parts(const Scene& scene, const VtuOptions& options) {
  return frame_parts(options, scene.number_of_bodies(), Scene::body_names,
                     is_simplex_mesh<typename Scene::Mesh>);
}

/// Calls `f(data)` for each of them.
template <class Scene, class F>
void for_each_frame_part(const Scene& scene, const VtuOptions& options, F&& f) {
  scene.for_each_body([&](const auto& body, const auto&) { f(points_vtu(body, options.points)); });
  if constexpr (is_simplex_mesh<typename Scene::Mesh>) {
    if (options.mesh) f(mesh_vtu(scene.mesh));
    if (!options.region.empty()) f(mesh_vtu(scene.mesh, scene.mesh.region_numbers(options.region)));
  }
}

}  // namespace detail

/// Observer that writes the points of each body as PREFIX_body0_0000.vtu, .., the listed parts of the mesh,
/// and PREFIX.pvd, which ParaView opens as one series. Creates the folder. Use with `every(period,
/// vtu(prefix))`. Of scenes over the portions of a mesh each writes its piece, PREFIX_body0_p2_0000.vtu, and
/// one lists all. Restored with a state, or `resumed`, it continues the series; else one of an earlier run is
/// replaced with a warning, and kept by an `error` if the scene is past its first frame.
class VtuSeries {
 public:
  explicit VtuSeries(FilePath prefix, VtuOptions options = {});

  template <class Scene>
  void operator()(const Scene& scene) {
    piece_ = piece_of(scene);
    begin_frame(scene.time, detail::frame_parts(scene, options_));
    detail::for_each_frame_part(scene, options_, [this](const VtuData& data) { write_part(data); });
    if constexpr (Scene::is_portion)
      scene.communicator().least(0);  // all pieces are there, and all have read the old list
    end_frame();
  }

  /// Times of the files so far, s.
  template <class F>
  void visit_state(F&& f) {
    f("times", times_);
  }
  /// Lists the files of an earlier part of the run, which must be there.
  template <class Scene>
  void follow_state(const Scene& scene) {
    piece_ = piece_of(scene);
    names_ = detail::frame_parts(scene, options_);
    part_ = 0;
    if (piece_.number == 0) follow_list();
  }

 private:
  /// The part of a frame that this series writes; number 0 writes the list.
  struct Piece {
    int number = 0, count = 1;
  };
  template <class Scene>
  static Piece piece_of([[maybe_unused]] const Scene& scene) {
    if constexpr (Scene::is_portion) return {scene.portion().number, scene.communicator().size()};
    return {};
  }
  void begin_frame(double time, detail::VtuNames names);
  void write_part(const VtuData& data);
  void end_frame();
  void follow_list();
  /// Adds the files of a frame: all pieces of its first parts.
  void add_files(std::vector<PvdEntry>& to, double time, std::size_t frame, std::size_t parts) const;
  /// The list of all files of the frames so far, and of the parts of this one.
  void write_list() const;
  std::string file_of(const std::string& name, std::size_t frame, int piece) const;

  std::string prefix_;
  VtuOptions options_;
  std::vector<double> times_;    // [frames] s
  std::vector<PvdEntry> files_;  // of these frames, as they were written: with other pieces and parts, too

  Piece piece_{};
  detail::VtuNames names_;            // of the parts of a frame
  double time_ = 0;                   // of the frame that is being written, s
  std::size_t frame_ = 0, part_ = 0;  // its number; how many parts it has so far
  bool again_ = false;                // whether it was written before: at the start of a resumed run
};

/// Observer that writes files `prefix`_..: see `VtuSeries`.
inline VtuSeries vtu(FilePath prefix, VtuOptions options = {}) {
  return VtuSeries(std::move(prefix), std::move(options));
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#if ARENITE_HAS_COLD

#include <algorithm>
#include <filesystem>

#include <arenite/core/error.hpp>
#include <arenite/io/output_file.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// Columns side by side; zeros for those that are not there.
template <class T, std::size_t N>
VtuArray side_by_side(std::string name, std::size_t count, const std::array<const T*, N>& columns) {
  return vtu_array(std::move(name), count, [columns](std::size_t p) {
    std::array<T, N> item{};
    for (std::size_t k = 0; k < N; ++k)
      if (columns[k] != nullptr) item[k] = columns[k][p];
    return item;
  });
}

template <class T>
ARENITE_COLD VtuData columns_vtu(const PointColumns<T>& columns, const VtuPoints& wanted,
                                 MorePoints<T> more) {
  const std::size_t n = columns.count;
  const auto& stress = columns.stress;
  VtuData data{side_by_side("position", n, columns.position), {vtu_vertices(n)}, {}, {}};
  auto& arrays = data.point_data;
  arrays.push_back(side_by_side("velocity", n, columns.velocity));
  arrays.push_back(side_by_side("stress", n, stress));
  arrays.push_back(vtu_array("pressure", n, [x = stress[0], y = stress[1], z = stress[2]](std::size_t p) {
    return T(-(x[p] + y[p] + z[p]) / 3);
  }));
  arrays.push_back(
      vtu_array("volume_ratio", n,
                [volume = columns.volume, mass = columns.mass, density = static_cast<T>(columns.density)](
                    std::size_t p) { return T(volume[p] * density / mass[p]); }));
  for (VtuArray& array : more.arrays) arrays.push_back(std::move(array));
  for (std::size_t k = 0; k < more.history.size(); ++k)
    if (const std::string_view name = more.names[k];
        !name.empty() && (!wanted.history || std::find(wanted.history->begin(), wanted.history->end(),
                                                       name) != wanted.history->end()))
      arrays.push_back(side_by_side(std::string(name), n, std::array{more.history[k]}));
  if (wanted.mass) arrays.push_back(side_by_side("mass", n, std::array{columns.mass}));
  require(more.id != nullptr || !wanted.id, "VtuPoints.id", wanted.id, "needs a scene with PointIds{}");
  if (wanted.id)
    arrays.push_back(
        vtu_array("id", n, [id = more.id](std::size_t p) { return static_cast<std::int64_t>((*id)[p]); }));
  return data;
}

ARENITE_COLD VtuNames frame_parts(const VtuOptions& options, std::size_t bodies,
                                  std::span<const std::string_view> body_names, bool has_mesh) {
  VtuNames names;
  for (std::size_t k = 0; k < bodies; ++k)
    names.push_back(k < options.body_names.size()                     ? options.body_names[k]
                    : k >= body_names.size() || body_names[k].empty() ? joined_text({"body", k})
                                                                      : std::string(body_names[k]));
  if (has_mesh && options.mesh) names.emplace_back("mesh");
  if (has_mesh && !options.region.empty()) names.push_back(options.region);
  return names;
}

#define ARENITE_INSTANCES(T) \
  template VtuData columns_vtu(const PointColumns<T>&, const VtuPoints&, MorePoints<T>);
ARENITE_FOR_NUMBERS(ARENITE_INSTANCES)
#undef ARENITE_INSTANCES

}  // namespace detail

ARENITE_COLD VtuSeries::VtuSeries(FilePath prefix, VtuOptions options)
    : prefix_(prefix.string()), options_(std::move(options)) {
  make_folder_of(prefix_, "vtu");
  check_pvd(prefix_ + ".pvd");  // a folder that cannot be written to shows at once
}

ARENITE_COLD void VtuSeries::begin_frame(double time, detail::VtuNames names) {
  names_ = std::move(names);
  part_ = 0;
  if (times_.empty()) {
    files_ = kept_entries(prefix_ + ".pvd", time, options_.resumed, piece_.number == 0);
    for (const PvdEntry& e : files_)
      if (times_.empty() || e.time > times_.back()) times_.push_back(e.time);
    if (piece_.count == 1) write_list();
  }
  time_ = time;
  again_ = !times_.empty() && times_.back() == time;
  frame_ = times_.size() - (again_ ? 1 : 0);
}

ARENITE_COLD void VtuSeries::write_part(const VtuData& data) {
  write_vtu(file_of(names_[part_], frame_, piece_.number), data);
  ++part_;
  if (!again_ && piece_.count == 1) write_list();
}

ARENITE_COLD void VtuSeries::end_frame() {
  part_ = 0;
  if (again_)
    while (!files_.empty() && files_.back().time == time_) files_.pop_back();
  else
    times_.push_back(time_);
  add_files(files_, time_, frame_, names_.size());
  if (piece_.number == 0 && (again_ || piece_.count > 1)) write_list();
}

ARENITE_COLD void VtuSeries::follow_list() {
  const auto there = pvd_entries(prefix_ + ".pvd");
  files_.clear();
  for (std::size_t frame = 0; frame < times_.size(); ++frame) {
    const std::size_t before = files_.size();
    for (const PvdEntry& e : there)
      if (e.time == times_[frame]) files_.push_back(e);
    if (files_.size() == before) add_files(files_, times_[frame], frame, names_.size());  // the list is lost
  }
  write_list();
}

ARENITE_COLD void VtuSeries::add_files(std::vector<PvdEntry>& to, double time, std::size_t frame,
                                       std::size_t parts) const {
  int number = 0;
  for (std::size_t part = 0; part < parts; ++part)
    for (int piece = 0; piece < piece_.count; ++piece)
      to.push_back({time, file_of(names_[part], frame, piece), number++});
}

ARENITE_COLD void VtuSeries::write_list() const {
  auto files = files_;
  add_files(files, time_, frame_, part_);
  write_pvd(prefix_ + ".pvd", files);
}

ARENITE_COLD std::string VtuSeries::file_of(const std::string& name, std::size_t frame, int piece) const {
  std::string digits = std::to_string(frame);
  digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
  const std::string of_piece = piece_.count > 1 ? joined_text({"_p", piece}) : "";
  return joined_text({prefix_, "_", name, of_piece, "_", digits, ".vtu"});
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
