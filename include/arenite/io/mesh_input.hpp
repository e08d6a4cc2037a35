// The bytes of a mesh file, Gmsh or STL, read forwards as text or as binary numbers. Every number is checked
// against the end of the file, and whatever is wrong is reported with file, section, and line (text) or byte
// (binary): a file is a user's input, so no content of it may do worse than throw.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <istream>
#include <string>
#include <string_view>
#include <utility>

#include <arenite/core/error.hpp>
#include <arenite/core/instruction_set.hpp>
#include <arenite/io/input_file.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

class MeshInput {
 public:
  /// Views `bytes`, which must outlive this; `name`: of the file, for messages.
  MeshInput(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  bool binary() const { return binary_; }
  /// Says that what follows $MeshFormat is binary, with tags and counts of `size_bytes` (4 or 8) in
  /// format 4.1.
  void set_binary(std::size_t size_bytes) {
    binary_ = true;
    size_bytes_ = size_bytes;
  }

  /// Throws "file, section, place: name = value: rule" for the item that was read last; without bytes, where
  /// a mesh comes from arrays, as `refuse` does.
  template <class Value>
  [[noreturn]] void fail(std::string_view name, const Value& value, std::string_view rule) const {
    if (bytes_.empty() && !binary_) refuse(name, value, rule);
    const std::string place =
        binary_ ? joined_text({"byte ", last_})
                : joined_text({"line ",
                               1 + std::count(bytes_.begin(), bytes_.begin() + std::ptrdiff_t(last_), '\n')});
    const std::string section = section_.empty() ? "" : joined_text({", $", section_});
    throw error(joined_text({name_, section, ", ", place, ": ", name, " = ", value, ": ", rule}));
  }

  /// Refuses the mesh as a whole: "file: name = value: rule".
  template <class Value>
  [[noreturn]] void refuse(std::string_view name, const Value& value, std::string_view rule) const {
    throw error(joined_text({name_, ": ", name, " = ", value, ": ", rule}));
  }

  template <class Value>
  void check(bool holds, std::string_view name, const Value& value, std::string_view rule) const {
    if (!holds) fail(name, value, rule);
  }

  // --- sections of a Gmsh file ---

  /// Skips blanks and reads "$Name"; empty at the end of the file.
  std::string open_section() {
    section_.clear();
    skip_blanks();
    if (at_ == bytes_.size()) return {};
    const std::string_view line = rest_of_line();
    const auto shows = [](char c) { return c > ' ' && c <= '~'; };  // in messages, too
    check(line.size() > 1 && line.front() == '$' && std::all_of(line.begin(), line.end(), shows), "line",
          quote(line), "must be the $Name of a section");
    section_ = line.substr(1);
    return section_;
  }

  /// Expects "$EndName" of the open section.
  void close_section() {
    skip_blanks();
    last_ = at_;
    const std::string_view line = rest_of_line();
    check(line == joined_text({"$End", section_}), "line", quote(line),
          joined_text({"must be $End", section_}));
    section_.clear();
  }

  /// Goes past "$EndName" of the open section, whatever is in it.
  void skip_section() {
    const std::string end = joined_text({"$End", section_});
    std::size_t found = at_;
    while (true) {
      found = bytes_.find(end, found);
      check(found != std::string_view::npos, "section", joined_text({"$", section_}),
            joined_text({"ends without ", end}));
      const std::size_t after = found + end.size();
      if (after == bytes_.size() || is_blank(bytes_[after])) break;
      found = after;
    }
    at_ = found;
    close_section();
  }

  const std::string& section() const { return section_; }

  // --- text, in a binary file too ---

  /// The rest of the line, without blanks at its ends; the cursor goes to the next line.
  std::string_view rest_of_line() {
    last_ = at_;
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    std::string_view line = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    return line;
  }

  /// The next word, in this line or below; empty at the end of the file.
  std::string_view word() {
    skip_blanks();
    while (at_ < bytes_.size() && !is_blank(bytes_[at_])) ++at_;
    return bytes_.substr(last_, at_ - last_);
  }

  /// Refuses anything more on this line. (In a binary file lines contain the format, the names and the
  /// counts of 2.2.)
  void end_line(std::string_view name) {
    const std::string_view more = rest_of_line();
    check(more.empty(), name, quote(more), "is too much for this line (or the line before holds too little)");
  }

  /// Skips the rest of a line in a text file; does nothing in a binary one.
  void end_row(std::string_view name) {
    if (!binary_) end_line(name);
  }

  /// A number written as text.
  template <class T>
  T text(std::string_view name) {
    const std::string_view word = this->word();
    check(!word.empty(), name, "nothing", "the file ends before this number");
    T value{};
    const std::size_t sign = word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0;
    const char* const end = word.data() + word.size();
    const auto [stop, status] = std::from_chars(word.data() + sign, end, value);
    if (status == std::errc::result_out_of_range)
      fail(name, quote(word), "is too large or too small a number");
    if (status != std::errc{} || stop != end)
      fail(name, quote(word), std::integral<T> ? "must be a whole number" : "must be a number");
    return value;
  }

  // --- numbers, text or binary as the file has it ---

  /// A C int.
  int integer(std::string_view name) { return binary_ ? raw<std::int32_t>(name) : text<int>(name); }

  /// A C size_t (format 4.1).
  std::uint64_t size(std::string_view name) {
    if (!binary_) return text<std::uint64_t>(name);
    return size_bytes_ == 4 ? raw<std::uint32_t>(name) : raw<std::uint64_t>(name);
  }

  /// A double; NaN and infinity are numbers here.
  double real(std::string_view name) { return binary_ ? raw<double>(name) : text<double>(name); }

  /// Refuses a count of items of at least `least_bytes` each that do not fit in the rest of the file.
  void check_count(std::string_view name, std::uint64_t count, std::size_t least_bytes) const {
    check(count <= (bytes_.size() - at_) / least_bytes, name, count,
          "is more than the rest of the file can hold");
  }

  /// Bytes of a size_t in a binary file; in text at least a digit and a blank.
  std::size_t size_bytes() const { return binary_ ? size_bytes_ : 2; }

  /// A binary number in this machine's byte order.
  template <class T>
  T raw(std::string_view name) {
    last_ = at_;
    check(bytes_.size() - at_ >= sizeof(T), name, "nothing", "the file ends before this number");
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }

  /// A piece of the file as a message can show it.
  static std::string quote(std::string_view piece) {
    std::string shown = "\"";
    for (const char c : piece.substr(0, 40)) shown += c >= ' ' && c <= '~' ? c : '?';
    return shown + (piece.size() > 40 ? "...\"" : "\"");
  }

 private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  void skip_blanks() {
    while (at_ < bytes_.size() && is_blank(bytes_[at_])) ++at_;
    last_ = at_;
  }

  std::string_view bytes_;
  std::string name_;
  std::string section_;         // name of the open section
  std::size_t at_ = 0;          // next byte
  std::size_t last_ = 0;        // first byte of the item read last
  std::size_t size_bytes_ = 8;  // of a size_t in a binary file
  bool binary_ = false;
};

/// All bytes left in a stream; `name`: of the stream, for messages.
inline std::string read_all(std::istream& in, const std::string& name) {
  std::string bytes;
  std::size_t used = 0;
  while (in) {
    if (used == bytes.size()) bytes.resize(std::max<std::size_t>(std::size_t{1} << 16, 2 * used));
    in.read(bytes.data() + used, static_cast<std::streamsize>(bytes.size() - used));
    used += static_cast<std::size_t>(in.gcount());
  }
  if (in.bad()) throw error(joined_text({"mesh = ", name, ": cannot be read"}));
  bytes.resize(used);
  return bytes;
}

/// Largest mesh file: nodes are numbered in 32 bits, and a node takes more than four bytes.
inline constexpr std::uintmax_t most_mesh_bytes = std::uintmax_t{16} << 30;

/// All of a file. Throws `error` if it cannot be read.
inline std::string read_all(const std::filesystem::path& path) {
  return read_input(path, "mesh", most_mesh_bytes);
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail
