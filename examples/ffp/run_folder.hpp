// The folder of a run: locked, so that no other run writes to it, and without the results of an earlier one.
// POSIX.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>

#include "words.hpp"

namespace arenite::ffp {

/// The state of a run that has not come to its end, in its folder.
inline constexpr const char* state_file_name = "checkpoint.state";

/// Whether a file of this name is one that a drop writes, or one of the pictures that plot.py draws of it:
/// what a new run removes. ".part" is what a killed run may leave of each.
inline bool is_result(std::string_view name) {
  if (name.ends_with(".part")) name.remove_suffix(5);
  for (const std::string_view own :
       {"summary.json", "history.csv", "fields.pvd", "histories.png", "strain.png", "reduced.csv",
        "reduced.json", "reduced.png", "reduced.svg", state_file_name})
    if (name == own) return true;
  for (const std::string_view part :
       {"fields_soil_", "fields_device_points_", "fields_mesh_", "fields_device_"})
    if (name.starts_with(part) && name.ends_with(".vtu") && name.size() >= part.size() + 8) {
      const auto number = name.substr(part.size(), name.size() - part.size() - 4);
      return number.find_first_not_of("0123456789") == std::string_view::npos;
    }
  return false;
}

/// Makes a folder, or takes one that is there, and holds it until the end of its life. The lock is the
/// kernel's, on the file `.arenite-ffp.lock`, so that a run that is killed leaves no folder locked; the file
/// stays. While the run goes on it also holds some disk space back, with which the summary can be written on
/// a disk that is full.
class RunFolder {
 public:
  /// What becomes of the results of an earlier run.
  enum class Earlier { removed, kept };

  /// Throws `error` that names `--out` if the folder cannot be made or written to, or is in use.
  explicit RunFolder(const std::string& out, Earlier earlier = Earlier::removed)
      : path_{out}, name_{shown(out)} {
    std::error_code code;
    std::filesystem::create_directories(path_, code);
    require(!code, "--out", name_, "the folder cannot be made: " + code.message());
    open_lock();
    try {
      lock();
      check_reserve();
      if (earlier == Earlier::removed) remove_results();
    } catch (...) {
      if (lock_ >= 0) ::close(lock_);
      throw;
    }
    // Without it the run works as well, until the disk is full.
    [[maybe_unused]] const int held = ::posix_fallocate(lock_, 0, reserve_bytes);
  }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder() {
    free_reserve();
    ::close(lock_);
  }

  const std::filesystem::path& path() const { return path_; }

  /// Gives the disk space back that was held for the summary.
  void free_reserve() {
    if (::ftruncate(lock_, 0) != 0) return;  // then it is not there for the summary either, which will tell
  }

 private:
  static constexpr ::off_t reserve_bytes = 1 << 16;

  /// Opens the lock, or makes it. One that is there must be one that a drop has made: a link is not followed,
  /// and nobody else's file is emptied.
  void open_lock() {
    const std::string lock = (path_ / ".arenite-ffp.lock").string();
    lock_ = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    const int reason = lock_ < 0 ? errno : 0;
    if (reason == ELOOP || reason == ENXIO || reason == EISDIR) refuse_lock("is a link, a folder or a pipe");
    require(reason == 0, "--out", name_,
            "no files can be made there: " + std::generic_category().message(reason));
    struct stat lock_is {
    }, folder_is{};
    const bool known = ::fstat(lock_, &lock_is) == 0 && ::stat(path_.c_str(), &folder_is) == 0;
    if (!known || !S_ISREG(lock_is.st_mode)) refuse_lock("is no regular file");
    if (lock_is.st_uid != ::geteuid() && lock_is.st_uid != folder_is.st_uid)
      refuse_lock("belongs to another user");
  }
  /// A lock holds nothing but the space that was held back: zeros.
  void check_reserve() {
    std::array<char, 1 << 12> piece{};
    ::off_t at = 0;
    for (::ssize_t bytes = 1; bytes > 0 && at <= reserve_bytes; at += bytes) {
      bytes = ::pread(lock_, piece.data(), piece.size(), at);
      if (bytes < 0 || std::any_of(piece.begin(), piece.begin() + bytes, [](char c) { return c != 0; }))
        refuse_lock("holds what no drop has written");
    }
    if (at > reserve_bytes) refuse_lock("holds what no drop has written");
  }
  [[noreturn]] void refuse_lock(const std::string& what) {
    if (lock_ >= 0) ::close(std::exchange(lock_, -1));
    throw error(joined_text({"--out = ", name_, ": .arenite-ffp.lock ", what,
                             ", and no lock of a drop; remove it, or name another folder"}));
  }

  void lock() const {
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    if (::fcntl(lock_, F_SETLK, &whole) == 0) return;
    const int reason = errno;
    if (reason == EACCES || reason == EAGAIN) {
      ::fcntl(lock_, F_GETLK, &whole);
      throw error(joined_text({"--out = ", name_, ": is in use by the drop with process id ",
                               whole.l_type == F_UNLCK ? 0 : whole.l_pid}));
    }
    std::fprintf(
        stderr,
        "arenite-ffp: warning: --out = %s: cannot be locked (%s); nothing must write there meanwhile\n",
        name_.c_str(), std::generic_category().message(reason).c_str());
  }

  /// The summary goes first, then the index of the fields: what is left if this is cut short claims nothing,
  /// and names no file that is gone.
  void remove_results() const {
    std::error_code code;
    for (const char* first : {"summary.json", "fields.pvd"})
      if (!code) std::filesystem::remove(path_ / first, code);
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(path_, code))
      if (is_result(entry.path().filename().string()) && !entry.is_directory()) found.push_back(entry.path());
    for (const auto& file : found) {
      if (!code) std::filesystem::remove(file, code);
    }
    require(!code, "--out", name_, "the results of an earlier run cannot be removed: " + code.message());
  }

  std::filesystem::path path_;
  std::string name_;
  int lock_ = -1;
};

}  // namespace arenite::ffp
