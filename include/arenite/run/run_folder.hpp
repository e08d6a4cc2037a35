// Run folder: where a run writes, locked so that no other run does, and without the results of an earlier one.
// POSIX.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/core/warning.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Names in the folders of a program's runs, and in messages about them.
struct RunFolderNames {
  std::string name = "RunFolder";      ///< name in messages of the folder: an option's, say
  std::string run = "run";             ///< name in messages of the program's run
  std::string lock = ".arenite.lock";  ///< file of the lock
  /// Whether a file of this name is a result, which a new run removes; none: nothing is removed
  std::function<bool(std::string_view)> is_result{};
  std::vector<std::string>
      first{};  ///< results that are removed before the others, in this order: those that claim something of others
};

/// Makes a folder, or uses one that exists, and locks it for the lifetime of the object. The lock is the
/// kernel's, on a file, so that a run that is killed leaves no folder locked; the file stays. During the run
/// it also reserves some disk space, with which a final message can be written on a full disk.
class RunFolder {
 public:
  /// Fate of the results of an earlier run.
  enum class Earlier { removed, kept };

  /// `shown`: the folder's name in messages, if it is not the path. Throws `error` that names the folder if it
  /// cannot be made or written to, or is in use.
  explicit RunFolder(std::filesystem::path path, Earlier earlier, RunFolderNames names = {},
                     std::string shown = {})
      : path_{std::move(path)},
        names_{std::move(names)},
        shown_{shown.empty() ? path_.string() : std::move(shown)} {
    std::error_code code;
    std::filesystem::create_directories(path_, code);
    require(!code, names_.name, shown_, {"the folder cannot be made: ", code.message()});
    const std::scoped_lock guard(held_mutex_);
    open_lock();
    try {
      lock();
      check_reserve();
      if (earlier == Earlier::removed && names_.is_result) remove_results();
    } catch (...) {
      if (lock_ >= 0) ::close(lock_);
      throw;
    }
    held_.push_back(place_);
    // Without the reserve the run works as well, until the disk is full.
    [[maybe_unused]] const int held = ::posix_fallocate(lock_, 0, reserve_bytes);
  }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder() {
    free_reserve();
    const std::scoped_lock guard(held_mutex_);
    std::erase(held_, place_);
    ::close(lock_);
  }

  const std::filesystem::path& path() const { return path_; }

  /// Frees the disk space that was reserved for the final message.
  void free_reserve() {
    if (::ftruncate(lock_, 0) != 0) return;  // then the final message finds no space either, and reports it
  }

 private:
  using Place = std::pair<::dev_t, ::ino_t>;
  static constexpr ::off_t reserve_bytes = 1 << 16;

  /// Opens the lock, or makes it. An existing one must have been made by a run: a link is not followed,
  /// and no file of another user is emptied.
  void open_lock() {
    const std::string lock = (path_ / names_.lock).string();
    // Another run of this process: the kernel's lock is the process's, and goes when any of its files is closed.
    struct stat there {};
    if (::stat(lock.c_str(), &there) == 0 &&
        std::ranges::find(held_, Place{there.st_dev, there.st_ino}) != held_.end())
      refuse_in_use(::getpid());
    lock_ = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    const int reason = lock_ < 0 ? errno : 0;
    if (reason == ELOOP || reason == ENXIO || reason == EISDIR) refuse_lock("is a link, a folder or a pipe");
    require(reason == 0, names_.name, shown_,
            {"no files can be made there: ", std::generic_category().message(reason)});
    struct stat lock_is {
    }, folder_is{};
    const bool known = ::fstat(lock_, &lock_is) == 0 && ::stat(path_.c_str(), &folder_is) == 0;
    if (!known || !S_ISREG(lock_is.st_mode)) refuse_lock("is no regular file");
    if (lock_is.st_uid != ::geteuid() && lock_is.st_uid != folder_is.st_uid)
      refuse_lock("belongs to another user");
    place_ = {lock_is.st_dev, lock_is.st_ino};
  }
  /// Refuses a lock with any content but the reserved space: zeros.
  void check_reserve() {
    std::array<char, 1 << 12> piece{};
    ::off_t at = 0;
    for (::ssize_t bytes = 1; bytes > 0 && at <= reserve_bytes; at += bytes) {
      bytes = ::pread(lock_, piece.data(), piece.size(), at);
      if (bytes < 0 || std::any_of(piece.begin(), piece.begin() + bytes, [](char c) { return c != 0; }))
        refuse_lock(joined_text({"holds what no ", names_.run, " has written"}));
    }
    if (at > reserve_bytes) refuse_lock(joined_text({"holds what no ", names_.run, " has written"}));
  }
  [[noreturn]] void refuse_lock(const std::string& what) {
    if (lock_ >= 0) ::close(std::exchange(lock_, -1));
    throw error(joined_text({names_.name, " = ", shown_, ": ", names_.lock, " ", what, ", and no lock of a ",
                             names_.run, "; remove it, or name another folder"}));
  }

  [[noreturn]] void refuse_in_use(::pid_t process) const {
    throw error(joined_text(
        {names_.name, " = ", shown_, ": is in use by the ", names_.run, " with process id ", process}));
  }

  void lock() const {
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    if (::fcntl(lock_, F_SETLK, &whole) == 0) return;
    const int reason = errno;
    if (reason == EACCES || reason == EAGAIN) {
      ::fcntl(lock_, F_GETLK, &whole);
      refuse_in_use(whole.l_type == F_UNLCK ? 0 : whole.l_pid);
    }
    warn(joined_text({names_.name, " = ", shown_, ": cannot be locked (",
                      std::generic_category().message(reason), "); nothing must write there meanwhile"}));
  }

  /// If interrupted, the files left claim nothing, and name no file that is gone (`RunFolderNames::first`).
  void remove_results() const {
    std::error_code code;
    for (const std::string& first : names_.first)
      if (!code) std::filesystem::remove(path_ / first, code);
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(path_, code))
      if (names_.is_result(entry.path().filename().string()) && !entry.is_directory())
        found.push_back(entry.path());
    for (const auto& file : found) {
      if (!code) std::filesystem::remove(file, code);
    }
    require(!code, names_.name, shown_,
            {"the results of an earlier run cannot be removed: ", code.message()});
  }

  std::filesystem::path path_;
  RunFolderNames names_;
  std::string shown_;
  int lock_ = -1;
  Place place_{};  // of the file of the lock
  static inline std::mutex held_mutex_;
  static inline std::vector<Place> held_;  // by this process
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
