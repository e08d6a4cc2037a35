// VTKHDF files out: an unstructured grid with all steps of a run in one HDF5 file, for ParaView 5.12 and
// newer. Format: "VTKHDF format specification", docs.vtk.org, version 2.0, UnstructuredGrid with the group
// Steps, one part a step. What did not change since the step before is not written again: the step refers to
// it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <arenite/core/hash.hpp>
#include <arenite/core/instruction_set.hpp>
#include <arenite/core/map.hpp>
#include <arenite/io/hdf5_sets.hpp>
#include <arenite/io/vtu.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// A file that grows with a run, complete after each step, and closed between them. A process that is killed
/// while it adds a step may leave a file that HDF5 does not read.
class VtkhdfWriter {
 public:
  /// Writes a file without steps, so that a folder that cannot be written to shows at once. Throws `error`
  /// then. `keep`: leaves a file that is there as it is for now.
  explicit VtkhdfWriter(std::filesystem::path path, bool keep = false) : path_{std::move(path)} {
    if (!keep) create();
  }

  /// Goes on with the first steps of the file that is there. Throws `error` if it has fewer.
  void keep(std::size_t steps) {
    const Hdf5File file(path_, Hdf5Access::change, "VTKHDF file");
    const std::size_t there = count_rows(file, "VTKHDF/Steps/Values");
    if (there < steps) file.refuse(joined_text({"has ", there, " steps, and must have ", steps}));
    put_rows(file, "VTKHDF/Steps/Values", real, steps, 0, nullptr);
    put_count(file, steps);
    steps_ = steps;
    begun_ = true;
  }

  /// Adds a step. Its arrays must have the names and types of those of the first. Throws `error` where
  /// `write_vtu` does; the file then has the former steps.
  void add(double time, const VtuData& data) {
    require(std::isfinite(time), "time of a step", time, "must be finite");
    shared_detail::check_vtu_data(data);
    if (!begun_) create();
    reserve(data);
    Hdf5File file(path_, Hdf5Access::change, "VTKHDF file");
    const std::int64_t part = put_cells(file, data);
    put_step(file, "PointOffsets", put(file, "Points", data.points));
    for (const VtuArray& a : data.point_data)
      put_step(file, "PointDataOffsets/" + a.name, put(file, "PointData/" + a.name, a));
    for (const VtuArray& a : data.cell_data)
      put_step(file, "CellDataOffsets/" + a.name, put(file, "CellData/" + a.name, a));
    put_step(file, "PartOffsets", part);
    put_step(file, "NumberOfParts", 1);
    put_rows(file, "VTKHDF/Steps/Values", real, steps_, 1, &time);
    put_count(file, steps_ + 1);
    file.close();
    ++steps_;
  }

  std::size_t steps() const { return steps_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  static constexpr Hdf5Type real{'f', 8}, integer{'i', 8};
  /// The last write to a data set: its first row, and its hash.
  struct Last {
    std::int64_t begin = -1;
    std::uint64_t hash = 0;
  };

  void create() {
    Hdf5File file(path_, Hdf5Access::create, "VTKHDF file");
    file.make_group("VTKHDF/Steps");
    file.put_text("VTKHDF", "Type", "UnstructuredGrid");
    file.put_integers("VTKHDF", "Version", std::array<std::int64_t, 2>{2, 0});
    put_count(file, 0);
    make_rows(file, "VTKHDF/Steps/Values", real, 1, 256);
    file.close();
    begun_ = true;
  }
  static void put_count(const Hdf5File& file, std::size_t steps) {
    file.put_integers("VTKHDF/Steps", "NSteps", std::array{static_cast<std::int64_t>(steps)}, true);
  }

  static std::size_t rows_of_piece(std::size_t items) { return std::clamp<std::size_t>(items, 256, 65536); }

  /// Room on the disk for a step, for HDF5's library is not sound any more once it could not write.
  void reserve(const VtuData& data) const {
    std::uintmax_t bytes = std::uintmax_t{1} << 20;
    const auto add = [&](std::size_t items, std::size_t row) {
      bytes += (items + rows_of_piece(items)) * row;
    };
    const auto add_array = [&](const VtuArray& a) { add(a.items, a.components * a.number_bytes); };
    add_array(data.points);
    std::ranges::for_each(data.point_data, add_array);
    std::ranges::for_each(data.cell_data, add_array);
    for (const VtuCells& block : data.cells) add(block.items, 8 * block.points + 9);
    if (const int reason = shared_detail::reserve_on_disk(path_, bytes); reason != 0)
      shared_detail::fail_output(path_, "has no room for a step; is the disk full?", reason);
  }

  /// An offset, or a number, of this step.
  void put_step(const Hdf5File& file, const std::string& name, std::int64_t value) const {
    const std::string path = "VTKHDF/Steps/" + name;
    if (steps_ == 0 && !file.has(path)) make_rows(file, path, integer, 1, 256);
    put_rows(file, path, integer, steps_, 1, &value);
  }

  /// Writes an array unless it is that of the step before; returns its first row.
  std::int64_t put(const Hdf5File& file, const std::string& name, const VtuArray& array) {
    const std::size_t row = array.components * array.number_bytes;
    numbers_.resize(array.items * row);
    array.fetch(0, array.items, numbers_.data());
    Hash hash;
    hash.add(numbers_.data(), numbers_.size());
    auto& last = last_[name];
    if (last.begin >= 0 && last.hash == hash.value()) return last.begin;
    const char kind = static_cast<char>(std::tolower(static_cast<unsigned char>(array.type.front())));
    last = {append(file, name, {kind, array.number_bytes}, array.components, array.items, numbers_.data()),
            hash.value()};
    return last.begin;
  }
  static std::int64_t append(const Hdf5File& file, const std::string& name, Hdf5Type type,
                             std::size_t components, std::size_t items, const void* numbers) {
    const std::string path = "VTKHDF/" + name;
    if (!file.has(path)) make_rows(file, path, type, components, rows_of_piece(items));
    const std::size_t begin = count_rows(file, path);
    put_rows(file, path, type, begin, items, numbers);
    return static_cast<std::int64_t>(begin);
  }

  /// Writes cells, as a new part, unless they are those of the step before; returns the part.
  std::int64_t put_cells(const Hdf5File& file, const VtuData& data) {
    const auto topology = shared_detail::vtu_topology(data.cells, data.points.items, true);
    const std::size_t cells = topology[2].items, corners = topology[0].items;
    std::vector<std::int64_t> connectivity(corners), offsets(cells + 1);
    std::vector<std::uint8_t> types(cells);
    topology[0].fetch(0, corners, reinterpret_cast<char*>(connectivity.data()));
    topology[1].fetch(0, cells, reinterpret_cast<char*>(offsets.data() + 1));
    topology[2].fetch(0, cells, reinterpret_cast<char*>(types.data()));
    Hash hash;
    hash.add(&data.points.items, sizeof(data.points.items));
    hash.add(types.data(), cells);
    hash.add(connectivity.data(), corners * sizeof(std::int64_t));
    if (part_.begin < 0 || part_.hash != hash.value()) {
      const auto number = [&](const std::string& name, std::size_t value) {
        const auto count = static_cast<std::int64_t>(value);
        return append(file, name, integer, 1, 1, &count);
      };
      append(file, "Offsets", integer, 1, cells + 1, offsets.data());
      first_corner_ = append(file, "Connectivity", integer, 1, corners, connectivity.data());
      first_cell_ = append(file, "Types", {'u', 1}, 1, cells, types.data());
      number("NumberOfPoints", data.points.items);
      number("NumberOfCells", cells);
      part_ = {number("NumberOfConnectivityIds", corners), hash.value()};
    }
    put_step(file, "CellOffsets", first_cell_);
    put_step(file, "ConnectivityIdOffsets", first_corner_);
    return part_.begin;
  }

  std::filesystem::path path_;
  bool begun_ = false;
  std::size_t steps_ = 0;
  Map<std::string, Last> last_;
  Last part_;
  std::int64_t first_cell_ = 0, first_corner_ = 0;  // of the part
  std::vector<char> numbers_;
};

/// Times of the steps of a file, s; none if there is no file that can be read.
inline std::vector<double> vtkhdf_times(const std::filesystem::path& path) {
  std::error_code status;
  if (!std::filesystem::is_regular_file(path, status)) return {};
  try {
    const Hdf5File file(path, Hdf5Access::read, "VTKHDF file");
    std::vector<double> times(count_rows(file, "VTKHDF/Steps/Values"));
    get_numbers(file, "VTKHDF/Steps/Values", {'f', 8}, times.data());
    return times;
  } catch (const error&) {  // of a process that was killed
    return {};
  }
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
