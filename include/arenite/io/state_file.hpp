// State files: named numbers of a run to be resumed later. A head of text lines, which `head` shows; then
// the numbers as they lie in memory; then a hash of all that.
//
//   arenite state 1                     the format's number
//   byte order: little
//   composition: ..                     what the writer says of itself, a line each
//   values: 123
//   f8 14400 bodies/sand/points/mass    kind, bytes, count and name of each value
//   ..
//   (an empty line)
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <bit>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/core/instruction_set.hpp>
#include <arenite/io/output_file.hpp>
#include <arenite/io/state_source.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace shared_detail {
inline constexpr std::string_view state_magic = "arenite state ", state_format = "1";
inline constexpr const char* byte_order() {
  return std::endian::native == std::endian::little ? "little" : "big";
}

/// The head. Throws `error` for a name or a term with a line break.
std::string state_head(const std::vector<StateTerm>& terms, const std::vector<StateSlot>& entries);

}  // namespace shared_detail

/// Writes a state file, such that at any time `path` is absent, the old file or the new one, on the disk as a
/// whole, whenever the process is killed or the machine stops. Throws `output_error` if it cannot be written,
/// `error` for a name or a term with a line break.
void write_state_file(const std::filesystem::path& path, const std::vector<StateTerm>& terms,
                      const std::vector<StateSlot>& entries);

/// A state file that is read: whole and undamaged, or the constructor throws.
class StateFile : public StateSource {
 public:
  /// Throws `error` that names the file and the reason: it cannot be read, is no state file, of another
  /// format or byte order, truncated, or damaged.
  explicit StateFile(const std::filesystem::path& path);

 private:
  void get(const StateSlot& entry, void* to) override;
  std::string next_line();
  void read_head();
  std::size_t number_in(std::string_view text) const;
  StateSlot entry_in(const std::string& line) const;
  /// Size and hash of the whole file; finds where each entry begins.
  void check_whole();

  static constexpr std::size_t longest_line = 1 << 16;

  std::ifstream file_;
  std::vector<std::size_t> begin_;  // [entries] bytes from the start of the file
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/io/state_file_cold.hpp>
#endif
