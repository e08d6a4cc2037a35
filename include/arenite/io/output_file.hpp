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

#include <arenite/core/cold.hpp>
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

#if ARENITE_HAS_COLD

#include <array>
#include <charconv>
#include <cmath>
#include <ostream>
#include <streambuf>
#include <utility>

#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

ARENITE_COLD void fail_output(const std::filesystem::path& path, std::string_view what, int reason) {
  throw output_error(
      joined_text({"output = ", path.string(), ": ", what, " (",
                   reason != 0 ? std::generic_category().message(reason) : "unknown reason", ")"}),
      reason);
}

ARENITE_COLD void check_place(const std::filesystem::path& path) {
  std::error_code status;
  const auto there = std::filesystem::symlink_status(path, status);
  if (!std::filesystem::exists(there) || std::filesystem::is_regular_file(there) ||
      std::filesystem::is_symlink(there))
    return;
  const bool folder = std::filesystem::is_directory(there);
  throw output_error(
      joined_text({"output = ", path.string(), ": is ", folder ? "a folder" : "a device, pipe or socket",
                   "; must be a regular file, a link, or nothing"}),
      static_cast<int>(folder ? std::errc::is_a_directory : std::errc::invalid_argument));
}

ARENITE_COLD void make_folder_of(const std::filesystem::path& file, std::string_view what) {
  const std::filesystem::path folder = file.parent_path();
  std::error_code code;
  if (!folder.empty()) std::filesystem::create_directories(folder, code);
  require(!code, {what, ": folder"}, folder.string(), {"cannot be made: ", code.message()});
}

ARENITE_COLD FileHandle make_file(const std::filesystem::path& path, const std::filesystem::path& shown) {
  check_place(path);
  std::error_code status;
  std::filesystem::remove(path, status);
  errno = 0;
  FileHandle file{std::fopen(path.string().c_str(), "wbx")};  // x: the file must not be there, nor a link
  if (!file)
    fail_output(shown, "cannot be opened for writing; does the folder exist, and may you write there?",
                status ? status.value() : errno);
  return file;
}

ARENITE_COLD FileHandle open_to_change(const std::filesystem::path& path) {
  errno = 0;
#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
  const int number = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  struct stat found {};
  const bool regular = number >= 0 && ::fstat(number, &found) == 0 && S_ISREG(found.st_mode);
  FileHandle file{regular ? ::fdopen(number, "r+b") : nullptr};
  if (number >= 0 && !file) ::close(number);
#else
  const bool regular = std::filesystem::is_regular_file(std::filesystem::symlink_status(path));
  FileHandle file{regular ? std::fopen(path.string().c_str(), "r+b") : nullptr};
#endif
  if (!file)
    fail_output(path, "cannot be opened for writing; must be a regular file, and no link",
                errno != 0 ? errno : static_cast<int>(std::errc::invalid_argument));
  return file;
}

ARENITE_COLD int cut_file([[maybe_unused]] std::FILE* file,
                          [[maybe_unused]] const std::filesystem::path& path, std::uintmax_t bytes) {
#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
  return ::ftruncate(::fileno(file), static_cast<::off_t>(bytes)) == 0 ? 0 : errno;
#else
  std::error_code status;
  std::filesystem::resize_file(path, bytes, status);
  return status.value();
#endif
}

ARENITE_COLD int sync_to_disk([[maybe_unused]] std::FILE* file) {
#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
  const int reason = ::fsync(::fileno(file)) == 0 ? 0 : errno;
  return reason == EINVAL || reason == EROFS ? 0 : reason;  // no such thing there
#else
  return 0;
#endif
}

ARENITE_COLD void sync_folder([[maybe_unused]] const std::filesystem::path& folder) {
#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
  const int number = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY);
  if (number < 0) return;
  [[maybe_unused]] const int ignored = ::fsync(number);
  ::close(number);
#endif
}

ARENITE_COLD int reserve_on_disk([[maybe_unused]] const std::filesystem::path& path,
                                 [[maybe_unused]] std::uintmax_t bytes) {
#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
  const FileHandle file = open_to_change(path);
  const int number = ::fileno(file.get());
  const ::off_t size = ::lseek(number, 0, SEEK_END);
  int reason = ::posix_fallocate(number, size, static_cast<::off_t>(bytes));
  if (reason == EOPNOTSUPP || reason == EINVAL || reason == ENODEV) reason = 0;
  if (reason != 0 && ::ftruncate(number, size) != 0) reason = errno;
  return reason;
#else
  return 0;
#endif
}

/// Stream buffer that writes to an open file.
class FileBuffer : public std::streambuf {
 public:
  explicit FileBuffer(std::FILE* file) : file_{file} {}

 protected:
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    return std::fputc(c, file_) == EOF ? traits_type::eof() : c;
  }
  std::streamsize xsputn(const char* text, std::streamsize bytes) override {
    return static_cast<std::streamsize>(std::fwrite(text, 1, static_cast<std::size_t>(bytes), file_));
  }

 private:
  std::FILE* file_;
};

ARENITE_COLD void replace_file(const std::filesystem::path& path,
                               const std::function<void(std::ostream&)>& write, Sync sync) {
  check_place(path);
  std::filesystem::path part = path;
  part += ".part";
  FileHandle file = make_file(part, path);
  std::setvbuf(file.get(), nullptr, _IOFBF, std::size_t{1} << 16);
  const auto discard = [&] {
    std::error_code ignored;
    file.reset();
    std::filesystem::remove(part, ignored);
  };
  bool written = false;
  try {
    FileBuffer buffer(file.get());
    std::ostream out(&buffer);
    errno = 0;
    write(out);
    written = out.good() && std::fflush(file.get()) == 0;
  } catch (...) {
    discard();
    throw;
  }
  int reason = written ? 0 : errno;
  if (written && sync == Sync::disk) reason = sync_to_disk(file.get());
  if (!written || reason != 0) {
    discard();
    fail_output(path, "cannot be written; is the disk full?", reason);
  }
  file.reset();
  std::error_code status;
  std::filesystem::rename(part, path, status);
  if (status) {
    discard();
    fail_output(path, "cannot be put in place", status.value());
  }
  if (sync == Sync::disk) {
    std::filesystem::path folder = path.parent_path();
    if (folder.empty()) folder += ".";
    sync_folder(folder);  // as far as it goes
  }
}

ARENITE_COLD void append_number(std::string& text, double value) {
  std::array<char, 32> digits{};
  if (std::isnan(value)) value = std::abs(value);
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

ARENITE_COLD std::string xml_escape(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

ARENITE_COLD std::string xml_unescape(std::string_view value) {
  std::string out;
  while (!value.empty()) {
    std::size_t length = 1;
    char letter = value.front();
    for (const char escaped : {'&', '<', '>', '"'})
      if (const std::string text = xml_escape({&escaped, 1}); value.starts_with(text)) {
        letter = escaped;
        length = text.size();
      }
    out += letter;
    value.remove_prefix(length);
  }
  return out;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

#endif  // ARENITE_HAS_COLD
