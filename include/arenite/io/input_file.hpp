// Files in: only regular ones, and of a size that is known before they are read. A pipe would be waited for
// without end, and a device be read without end.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include <arenite/core/cold.hpp>
#include <arenite/core/error.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// Largest size of a file that is only streamed: none.
inline constexpr std::uintmax_t any_size = std::numeric_limits<std::uintmax_t>::max();

/// "16 GiB", or bytes where it is no whole number of them.
std::string size_text(std::uintmax_t bytes);

/// Size of a file, bytes, that is to be read. Throws `error` "what = path: rule" if it cannot be opened, is a
/// folder, a pipe or a device, or is larger than `most`. A link is followed. `name`: the path as messages
/// show it; without, as it is.
std::uintmax_t check_input(const std::filesystem::path& path, std::string_view what,
                           std::uintmax_t most = any_size, std::string name = "");

/// An input file, open to be read.
std::ifstream open_input(const std::filesystem::path& path, std::string_view what,
                         std::uintmax_t most = any_size, const std::string& name = "");

/// All bytes of a file. Throws `error` as `check_input` does, and if the memory does not suffice.
std::string read_input(const std::filesystem::path& path, std::string_view what, std::uintmax_t most,
                       std::string name = "");

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

#if ARENITE_HAS_COLD

#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

ARENITE_COLD std::string size_text(std::uintmax_t bytes) {
  for (const auto& [shift, unit] : {std::pair{30, " GiB"}, std::pair{20, " MiB"}})
    if (bytes > 0 && bytes % (std::uintmax_t{1} << shift) == 0) return joined_text({bytes >> shift, unit});
  return joined_text({bytes, " bytes"});
}

ARENITE_COLD std::uintmax_t check_input(const std::filesystem::path& path, std::string_view what,
                                        std::uintmax_t most, std::string name) {
  if (name.empty()) name = path.string();
  std::uintmax_t size = 0;
  bool regular = false, folder = false;
  int reason = 0;
#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);  // waits for no writer
  struct stat found {};
  if (file < 0 || ::fstat(file, &found) != 0) reason = errno;
  if (file >= 0) ::close(file);
  regular = S_ISREG(found.st_mode);
  folder = S_ISDIR(found.st_mode);
  size = static_cast<std::uintmax_t>(found.st_size);
#else
  std::error_code status;
  const auto there = std::filesystem::status(path, status);
  regular = std::filesystem::is_regular_file(there);
  folder = std::filesystem::is_directory(there);
  if (regular) size = std::filesystem::file_size(path, status);
  reason = status.value();
#endif
  require(reason != static_cast<int>(std::errc::no_such_file_or_directory), what, name, "no such file");
  require(reason == 0, what, name, {"cannot be read (", std::generic_category().message(reason), ")"});
  require(regular, what, name, {"must be a regular file, not ", folder ? "a folder" : "a pipe or a device"});
  require(size <= most, what, name, {"has ", size, " bytes; must have at most ", size_text(most)});
  return size;
}

ARENITE_COLD std::ifstream open_input(const std::filesystem::path& path, std::string_view what,
                                      std::uintmax_t most, const std::string& name) {
  check_input(path, what, most, name);
  std::ifstream file(path, std::ios::binary);
  require(file.is_open(), what, name.empty() ? path.string() : name, "cannot be read");
  return file;
}

ARENITE_COLD std::string read_input(const std::filesystem::path& path, std::string_view what,
                                    std::uintmax_t most, std::string name) {
  if (name.empty()) name = path.string();
  const std::uintmax_t size = check_input(path, what, most, name);
#ifdef _SC_PHYS_PAGES
  const auto memory = static_cast<std::uintmax_t>(::sysconf(_SC_PHYS_PAGES)) *
                      static_cast<std::uintmax_t>(::sysconf(_SC_PAGESIZE));
  require(size < memory, what, name, {"has ", size, " bytes, and this machine's memory ", memory});
#endif
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  try {
    bytes.resize(static_cast<std::size_t>(size));
  } catch (const std::bad_alloc&) {
    require(false, what, name, {"has ", size, " bytes, which there is no memory for"});
  }
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require(file.is_open() && !file.bad(), what, name, "cannot be read");
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

#endif  // ARENITE_HAS_COLD
