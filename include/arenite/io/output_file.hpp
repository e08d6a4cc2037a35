// Output files, by one rule. A file is written under a temporary name, always as a new file, and renamed when
// it is complete: a run that dies leaves no broken file, and a symbolic link at either name is replaced, not
// followed. A file that is continued (a table, a lock) must be a regular one. A folder may be reached by
// links. Also shared by all writers: numbers as text, and the message of a failed write.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include <arenite/core/error.hpp>

namespace arenite {  // one for all instruction sets, as all errors

/// A file that the operating system does not take.
class output_error : public error {
 public:
  output_error(const std::string& text, int reason) : error{text}, reason_{reason} {}
  /// The operating system's number for the reason, 0 if it gave none.
  int reason() const { return reason_; }
  /// Whether there is no space left: on the disk, or of what the user may fill.
  bool disk_full() const {
    const std::errc code{reason_};
#ifdef EDQUOT
    if (reason_ == EDQUOT) return true;
#endif
    return code == std::errc::no_space_on_device || code == std::errc::file_too_large;
  }

 private:
  int reason_;
};

}  // namespace arenite

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// Throws "output = path: what (reason of the operating system)".
[[noreturn]] void fail_output(const std::filesystem::path& path, std::string_view what, int reason);

/// How far a new file must have come before it takes the place of the old one.
enum class Sync {
  none,  ///< passed to the operating system: safe when the process dies
  disk   ///< written to the disk: safe when the machine stops (POSIX; elsewhere as `none`)
};

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
/// An open file.
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

/// Throws `output_error` if something stands at `path` that is neither a regular file nor a symbolic link: a
/// file that is written replaces only those.
void check_place(const std::filesystem::path& path);

/// Makes the folder of a file if it is not there. Throws `error` that names it as that of `what`.
void make_folder_of(const std::filesystem::path& file, std::string_view what);

/// Makes a file; what stood at its name, a file or a link, is removed, not written to. Throws `output_error`
/// that names `shown`.
FileHandle make_file(const std::filesystem::path& path, const std::filesystem::path& shown);

/// Opens a file that is there to read and write it. Throws `output_error` if it is no regular file; a link is
/// none.
FileHandle open_to_change(const std::filesystem::path& path);

/// Cuts a file to its first bytes. Returns the operating system's number for the reason if it cannot, else 0.
int cut_file(std::FILE* file, const std::filesystem::path& path, std::uintmax_t bytes);

/// Waits until a file is on the disk. Returns the operating system's number for the reason if it cannot be
/// written, else 0; where the system does not report it, 0.
int sync_to_disk(std::FILE* file);

/// Waits until the entries of a folder are on the disk, as far as the system does.
void sync_folder(const std::filesystem::path& folder);

/// Makes a file longer by bytes that the disk then has (POSIX). Returns the operating system's number for the
/// reason if it has not, with the file unchanged, else 0; where the system cannot report it, 0.
int reserve_on_disk(const std::filesystem::path& path, std::uintmax_t bytes);

/// Calls `write(std::ostream&)` on "path.part" and renames it to `path`, so that `path` is at any time
/// absent, the old file, or the new one; a link at either name is replaced. The folder must exist. Throws
/// `output_error` if it cannot be written; "path.part" is gone then.
void replace_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write,
                  Sync sync = Sync::none);

/// Appends the shortest text that reads back as the same double ("nan", "inf" and "-inf" for what is no
/// number).
void append_number(std::string& text, double value);

/// Text as the value of an XML attribute.
std::string xml_escape(std::string_view text);
/// The text of such a value.
std::string xml_unescape(std::string_view value);

/// "LittleEndian" or "BigEndian", as this machine is.
inline constexpr const char* vtk_byte_order() {
  return std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

namespace arenite::inline ARENITE_INSTRUCTION_SET {
using shared_detail::append_number;
using shared_detail::make_folder_of;
using shared_detail::replace_file;
}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/io/output_file_cold.hpp>
#endif
