// A part of a frame of all tiles as one: gathered where the first tile is, for files that one process writes.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <arenite/core/bytes.hpp>
#include <arenite/core/error.hpp>
#include <arenite/io/vtu.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace detail {

/// Arrays of a part in one order: points, those of points, those of cells.
template <class F>
void for_each_array(const VtuData& data, F&& f) {
  f(data.points);
  for (const VtuArray& a : data.point_data) f(a);
  for (const VtuArray& a : data.cell_data) f(a);
}

/// A part of one tile as bytes: of each array the number of items and these, then the corners of the cells.
inline std::string packed(const VtuData& data) {
  require(data.cells.size() == 1, "packed: kinds of cells", data.cells.size(), "must be one");
  std::string bytes;
  for_each_array(data, [&](const VtuArray& a) {
    append_bytes(bytes, a.items);
    const std::size_t at = bytes.size();
    bytes.resize(at + a.items * a.components * a.number_bytes);
    a.fetch(0, a.items, bytes.data() + at);
  });
  const VtuCells& cells = data.cells.front();
  append_bytes(bytes, cells.items);
  for (std::size_t c = 0; c < cells.items; ++c)
    for (std::size_t k = 0; k < cells.points; ++k) append_bytes(bytes, cells.point(c, k));
  return bytes;
}

/// The parts of all tiles, one after the other.
class VtuOfTiles {
 public:
  /// `of_tiles`: `packed`, by the tiles' numbers; `like`: the part of one of them, whose names and types all have.
  VtuOfTiles(const VtuData& like, const std::map<int, std::string>& of_tiles) {
    for_each_array(like, [&](const VtuArray& a) {
      arrays_.push_back(a);
      arrays_.back().items = 0;
    });
    numbers_.resize(arrays_.size());
    points_of_cell_ = like.cells.front().points;
    of_points_ = like.point_data.size();
    for (const auto& [tile, bytes] : of_tiles) add(bytes);
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      VtuArray& a = arrays_[k];
      a.fetch = [from = numbers_[k].data(), row = a.components * a.number_bytes](std::size_t begin,
                                                                                 std::size_t end, char* out) {
        if (end > begin) std::memcpy(out, from + begin * row, (end - begin) * row);
      };
    }
  }
  VtuOfTiles(const VtuOfTiles&) = delete;
  VtuOfTiles& operator=(const VtuOfTiles&) = delete;

  /// A view of it.
  VtuData data() const {
    const auto first = arrays_.begin() + 1, middle = first + static_cast<std::ptrdiff_t>(of_points_);
    return {arrays_.front(),
            {VtuCells{points_of_cell_, corners_.size() / points_of_cell_,
                      [this](std::size_t c, std::size_t k) { return corners_[c * points_of_cell_ + k]; }}},
            {first, middle},
            {middle, arrays_.end()}};
  }

 private:
  void add(std::string_view bytes) {
    const auto before = static_cast<Index>(arrays_.front().items);
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      const auto items = read_bytes<std::size_t>(bytes);
      const std::size_t size = items * arrays_[k].components * arrays_[k].number_bytes;
      arrays_[k].items += items;
      numbers_[k] += bytes.substr(0, size);
      bytes.remove_prefix(size);
    }
    const auto cells = read_bytes<std::size_t>(bytes);
    for (std::size_t n = 0; n < cells * points_of_cell_; ++n)
      corners_.push_back(before + read_bytes<Index>(bytes));
  }

  std::vector<VtuArray> arrays_;
  std::vector<std::string> numbers_;  // [arrays] as they lie in memory
  std::vector<Index> corners_;
  std::size_t points_of_cell_ = 1, of_points_ = 0;
};

}  // namespace detail
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
