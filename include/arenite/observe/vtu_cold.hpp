// Cold functions of vtu.hpp.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <filesystem>
#include <string>

#include <arenite/core/error.hpp>
#include <arenite/io/output_file.hpp>
#include <arenite/io/pvd.hpp>
#include <arenite/observe/vtu.hpp>

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
