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

#if ARENITE_HAS_COLD

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <ostream>

#include <arenite/core/hash.hpp>
#include <arenite/io/input_file.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace shared_detail {

ARENITE_COLD std::string state_head(const std::vector<StateTerm>& terms,
                                    const std::vector<StateSlot>& entries) {
  std::string head = joined_text({state_magic, state_format, "\nbyte order: ", byte_order(), "\n"});
  const auto line = [&](const std::string& text) {
    require(text.find_first_of("\r\n") == std::string::npos, "state", text, "must not hold a line break");
    head.append(text).append("\n");
  };
  for (const auto& [key, value] : terms) line(joined_text({key, ": ", value}));
  line(joined_text({"values: ", entries.size()}));
  for (const auto& entry : entries) line(joined_text({entry.type(), " ", entry.count, " ", entry.name}));
  return joined_text({head, "\n"});
}

}  // namespace shared_detail

ARENITE_COLD void write_state_file(const std::filesystem::path& path, const std::vector<StateTerm>& terms,
                                   const std::vector<StateSlot>& entries) {
  const std::string head = shared_detail::state_head(terms, entries);
  shared_detail::replace_file(
      path,
      [&](std::ostream& out) {
        Hash hash;
        const auto put = [&](const void* data, std::size_t bytes) {
          hash.add(data, bytes);
          out.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
        };
        put(head.data(), head.size());
        for (const auto& entry : entries) put(entry.data, entry.size());
        const std::uint64_t sum = hash.value();
        out.write(reinterpret_cast<const char*>(&sum), sizeof(sum));
      },
      shared_detail::Sync::disk);
}

ARENITE_COLD StateFile::StateFile(const std::filesystem::path& path) : StateSource(path) {
  file_ = shared_detail::open_input(path, "state file");
  read_head();
  check_whole();
}

ARENITE_COLD void StateFile::get(const StateSlot& entry, void* to) {
  const auto number = static_cast<std::size_t>(&entry - entries_.data());
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(begin_[number]));
  file_.read(static_cast<char*>(to), static_cast<std::streamsize>(entry.size()));
  if (!file_) refuse("cannot be read any more");
}

ARENITE_COLD std::string StateFile::next_line() {
  std::string line(longest_line, '\0');
  file_.getline(line.data(), static_cast<std::streamsize>(line.size()));
  if (file_.eof()) refuse("is truncated within its head");
  if (!file_) refuse(joined_text({"is damaged: a line of its head has ", longest_line, " characters"}));
  line.resize(static_cast<std::size_t>(file_.gcount()) - 1);
  return line;
}

ARENITE_COLD void StateFile::read_head() {
  constexpr auto magic = shared_detail::state_magic;
  std::array<char, magic.size()> begin{};
  file_.read(begin.data(), begin.size());
  if (!file_ || std::string_view(begin.data(), begin.size()) != magic)
    refuse("is no state file of Arenite: it must begin with \"arenite state\"");
  if (const std::string format = next_line(); format != shared_detail::state_format)
    refuse(joined_text({"has the format ", format, "; this program reads ", shared_detail::state_format}));
  std::size_t values = 0;
  for (bool more = true; more;) {
    const std::string line = next_line();
    const auto colon = line.find(": ");
    if (colon == std::string::npos)
      refuse(joined_text({"is damaged: \"", line.substr(0, 60), "\" in its head"}));
    const std::string key = line.substr(0, colon), value = line.substr(colon + 2);
    if (key == "byte order" && value != shared_detail::byte_order())
      refuse(joined_text({"was written by a machine of the other byte order, ", value}));
    if (key == "values") {
      values = number_in(value);
      more = false;
    } else if (key != "byte order") {
      terms_.emplace_back(key, value);
    }
  }
  for (std::size_t k = 0; k < values; ++k) entries_.push_back(entry_in(next_line()));
  if (!next_line().empty()) refuse("is damaged: more values than its head says");
}

ARENITE_COLD std::size_t StateFile::number_in(std::string_view text) const {
  std::size_t number = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (code != std::errc{} || end != text.data() + text.size() || number > std::size_t{1} << 48)
    refuse(joined_text({"is damaged: \"", text.substr(0, 60), "\" is no number"}));
  return number;
}
ARENITE_COLD StateSlot StateFile::entry_in(const std::string& line) const {
  const auto type = line.find(' '), count = line.find(' ', type + 1);
  if (type == std::string::npos || type < 2 || count == std::string::npos)
    refuse(joined_text({"is damaged: \"", line.substr(0, 60), "\" is no value"}));
  StateSlot entry{line.substr(count + 1), line[0], number_in(line.substr(1, type - 1)),
                  number_in(line.substr(type + 1, count - type - 1))};
  if (entry.bytes == 0 || entry.bytes > 16)
    refuse(joined_text({"is damaged: numbers of ", entry.bytes, " bytes"}));
  return entry;
}

ARENITE_COLD void StateFile::check_whole() {
  std::size_t end = static_cast<std::size_t>(file_.tellg());
  const std::size_t there = static_cast<std::size_t>(std::filesystem::file_size(path_));
  for (const auto& entry : entries_) {
    begin_.push_back(end);
    end += entry.size();
    if (end > there) break;
  }
  end += sizeof(std::uint64_t);
  if (there < end) refuse(joined_text({"is truncated: ", there, " bytes are left"}));
  if (there > end) refuse(joined_text({"is damaged: ", there - end, " bytes follow its end"}));
  file_.seekg(0);
  Hash hash;
  std::vector<char> piece(1 << 20);
  for (std::size_t left = end - sizeof(std::uint64_t); left > 0;) {
    const std::size_t bytes = std::min(left, piece.size());
    file_.read(piece.data(), static_cast<std::streamsize>(bytes));
    if (!file_) refuse("cannot be read");
    hash.add(piece.data(), bytes);
    left -= bytes;
  }
  std::uint64_t sum = 0;
  file_.read(reinterpret_cast<char*>(&sum), sizeof(sum));
  if (!file_ || sum != hash.value()) refuse("is damaged: its hash does not fit what it holds");
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
