// State files as HDF5: the contents of a state file (io/state_file.hpp), for other programs. Its head is
// the file's attributes, the numbers of each name are the data set of that path. HDF5 leaves the first bytes
// of a file free for the program that writes it ("user block"): two lines with the hash of all that follows them, so that no
// damaged file comes to the library.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <arenite/core/hash.hpp>
#include <arenite/core/instruction_set.hpp>
#include <arenite/io/hdf5_sets.hpp>
#include <arenite/io/input_file.hpp>
#include <arenite/io/output_file.hpp>
#include <arenite/io/state_file.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {
namespace shared_detail {

/// The bytes before the HDF5 file proper.
inline std::string state_hdf5_lines(const Hash& hash) {
  std::string lines = joined_text({state_magic, state_format, " in HDF5\nhash of bytes from ",
                                   Hdf5File::image_start, " on: ", hash.digits(), "\n"});
  lines.resize(Hdf5File::image_start, '\0');
  return lines;
}

}  // namespace shared_detail

/// Writes a state file as HDF5, as whole at any time as `write_state_file` does, and with the same errors. It
/// takes twice the file's size in memory meanwhile.
inline void write_state_hdf5(const std::filesystem::path& path, const std::vector<StateTerm>& terms,
                             const std::vector<StateSlot>& entries) {
  shared_detail::state_head(terms, entries);  // refuses what is no name
  Hdf5File file(path, Hdf5Access::image, "state file");
  file.put_text("/", "byte order", shared_detail::byte_order());
  for (const auto& [key, value] : terms) file.put_text("/", key, value);
  for (const auto& entry : entries)
    put_numbers(file, entry.name, {entry.kind, entry.bytes}, entry.count, entry.data);
  const std::vector<char> image = file.image();
  Hash hash;
  hash.add(image.data(), image.size());
  shared_detail::replace_file(
      path,
      [&](std::ostream& out) {
        out << shared_detail::state_hdf5_lines(hash);
        out.write(image.data(), static_cast<std::streamsize>(image.size()));
      },
      shared_detail::Sync::disk);
}

/// An HDF5 state file that is read: whole and undamaged, or the constructor throws.
class StateHdf5 : public StateSource {
 public:
  /// Throws `error` that names the file and the reason: it cannot be read, is no state file, of another
  /// format or byte order, truncated, or damaged.
  explicit StateHdf5(const std::filesystem::path& path)
      : StateSource(path), file_(checked(path), Hdf5Access::read, "state file") {
    for (auto& [name, value] : file_.texts()) {
      if (name != "byte order")
        terms_.emplace_back(name, value);
      else if (value != shared_detail::byte_order())
        refuse("was written by a machine of the other byte order, " + value);
    }
    for (const std::string& name : names_of_sets(file_)) {
      const Hdf5Type type = type_of_numbers(file_, name);
      entries_.push_back({name, type.kind, type.bytes, count_of_numbers(file_, name)});
      if (entries_.back().size() > std::filesystem::file_size(path))
        refuse(joined_text({"is damaged: ", name, " is larger than the file"}));
    }
  }

 private:
  void get(const StateSlot& entry, void* to) override {
    get_numbers(file_, entry.name, {entry.kind, entry.bytes}, to);
  }

  /// The path of a file that is whole.
  static const std::filesystem::path& checked(const std::filesystem::path& path) {
    const auto refuse_it = [&](const std::string& rule) {
      throw error(joined_text({"state file = ", path.string(), ": ", rule}));
    };
    std::ifstream file = shared_detail::open_input(path, "state file");
    std::string lines(Hdf5File::image_start, '\0');
    file.read(lines.data(), static_cast<std::streamsize>(lines.size()));
    lines.resize(static_cast<std::size_t>(file.gcount()));
    constexpr auto magic = shared_detail::state_magic;
    if (!lines.starts_with(magic))
      refuse_it("is no state file of Arenite: it must begin with \"arenite state\"");
    const std::string kind = lines.substr(magic.size(), lines.find('\n') - magic.size()),
                      wanted = joined_text({shared_detail::state_format, " in HDF5"});
    if (lines.size() == Hdf5File::image_start && kind != wanted)
      refuse_it(joined_text({"has the format ", kind, "; this program reads here ", wanted}));
    Hash hash;
    std::vector<char> piece(1 << 20);
    while (file) {
      file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
      hash.add(piece.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (!file.eof()) refuse_it("cannot be read");
    if (lines != shared_detail::state_hdf5_lines(hash))
      refuse_it("is truncated or damaged: its hash does not fit what it holds");
    return path;
  }

  Hdf5File file_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
