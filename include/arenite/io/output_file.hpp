// Files out, such that a run that dies leaves nothing broken behind: a file is written under a temporary name
// and takes its own when it is complete. Also what all writers share: numbers as text, and the message of a
// failed write.
#pragma once

#include <array>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <arenite/core/error.hpp>

#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace arenite {

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

namespace shared_detail {

/// Throws "output = path: what (reason of the operating system)".
[[noreturn]] inline void fail_output(const std::filesystem::path& path, std::string_view what, int reason) {
  throw output_error(
      joined_text("output = ", path.string(), ": ", what, " (",
                  reason != 0 ? std::generic_category().message(reason) : "unknown reason", ")"),
      reason);
}

/// How far a new file must have come before it takes the place of the old one.
enum class Sync {
  none,  ///< handed to the operating system: safe when the process dies
  disk   ///< written to the disk: safe when the machine stops (POSIX; elsewhere as `none`)
};

/// Waits until a file, or the entries of a folder, are on the disk. Returns the operating system's number for
/// the reason if they cannot be written, else 0; where the system does not tell, 0.
inline int sync_to_disk([[maybe_unused]] const std::filesystem::path& path) {
#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  const int reason = ::fsync(file) == 0 ? 0 : errno;
  ::close(file);
  return reason == EINVAL || reason == EROFS ? 0 : reason;  // no such thing there, for a folder
#else
  return 0;
#endif
}

/// Makes a file longer by bytes that the disk then has (POSIX). Returns the operating system's number for the
/// reason if it has not, with the file as it was, else 0; where the system cannot tell, 0.
inline int reserve_on_disk([[maybe_unused]] const std::filesystem::path& path,
                           [[maybe_unused]] std::uintmax_t bytes) {
#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return errno;
  const ::off_t size = ::lseek(file, 0, SEEK_END);
  int reason = ::posix_fallocate(file, size, static_cast<::off_t>(bytes));
  if (reason == EOPNOTSUPP || reason == EINVAL || reason == ENODEV) reason = 0;
  if (reason != 0 && ::ftruncate(file, size) != 0) reason = errno;
  ::close(file);
  return reason;
#else
  return 0;
#endif
}

/// Calls `write(std::ostream&)` on "path.part" and renames it to `path`, so that `path` is at any time
/// absent, the old file, or the new one. The folder must exist. Throws `output_error` if it cannot be
/// written; "path.part" is gone then.
template <class Write>
void replace_file(const std::filesystem::path& path, Write&& write, Sync sync = Sync::none) {
  std::filesystem::path part = path;
  part += ".part";
  errno = 0;
  std::ofstream file(part, std::ios::binary | std::ios::trunc);
  if (!file)
    fail_output(path, "cannot be opened for writing; does the folder exist, and may you write there?", errno);
  const auto discard = [&] {
    std::error_code ignored;
    file.close();
    std::filesystem::remove(part, ignored);
  };
  try {
    write(static_cast<std::ostream&>(file));
    file.close();
  } catch (...) {
    discard();
    throw;
  }
  int reason = file ? 0 : errno;
  if (file && sync == Sync::disk) reason = sync_to_disk(part);
  if (!file || reason != 0) {
    discard();
    fail_output(path, "cannot be written; is the disk full?", reason);
  }
  std::error_code status;
  std::filesystem::rename(part, path, status);
  if (status) {
    discard();
    fail_output(path, "cannot be put in place", status.value());
  }
  if (sync == Sync::disk)
    sync_to_disk(path.has_parent_path() ? path.parent_path() : ".");  // as far as it goes
}

/// Appends the shortest text that reads back as the same double ("nan", "inf" and "-inf" for what is no
/// number).
inline void append_number(std::string& text, double value) {
  std::array<char, 32> digits{};
  if (std::isnan(value)) value = std::abs(value);
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

/// Text as the value of an XML attribute.
inline std::string xml_escape(std::string_view text) {
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

/// "LittleEndian" or "BigEndian", as this machine is.
inline constexpr const char* vtk_byte_order() {
  return std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
}

}  // namespace shared_detail
}  // namespace arenite
