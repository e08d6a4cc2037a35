// Time series of VTK files (.pvd): the list of files and times that ParaView opens as one.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include <arenite/core/cold.hpp>
#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One file of a series.
struct PvdEntry {
  double time = 0;             ///< s
  std::filesystem::path file;  ///< as one would open it; the list names it relative to its own folder
  int part = 0;                ///< distinguishes the files of one time: points, device, mesh
};

/// Writes a series to `path`, whose folder must exist. Throws `error` if a time is not finite or the disk
/// refuses.
void write_pvd(const std::filesystem::path& path, std::span<const PvdEntry> entries);

/// Files of a series in its order; none if there is no list.
std::vector<PvdEntry> pvd_entries(const std::filesystem::path& path);

/// Times of a series in ascending order, s; none if there is no list.
std::vector<double> pvd_times(const std::filesystem::path& path);

/// Times, s, of the frames of a series `path`, of those at the times `earlier`, s, that are kept by a run that
/// begins at `time`, s: those before that, if the run continues them (`resumed`). A new run replaces all frames, with a warning
/// (`warns`: set for one of the callers); if it begins after the first of them, that is hardly intended: throws `error`.
std::vector<double> kept_times(const std::filesystem::path& path, const std::vector<double>& earlier,
                               double time, bool resumed, bool warns = true);

/// The files of these frames, as the list names them: those of other ranks, or with other parts, too.
std::vector<PvdEntry> kept_entries(const std::filesystem::path& path, double time, bool resumed,
                                   bool warns = true);

/// Throws `error` if the list of a new series cannot be written. Ranks may call it at once: each tries its own file, and none
/// writes the list.
void check_pvd(const std::filesystem::path& path);

/// A series that grows with a run: the list on disk is complete and readable after each step.
class PvdWriter {
 public:
  /// Writes the empty list, so that a folder that cannot be written to shows at once. Throws `error` then.
  /// `keep`: leaves a list, or none, as it is for now (`check_pvd`).
  explicit PvdWriter(std::filesystem::path path, bool keep = false) : path_(std::move(path)) {
    keep ? check_pvd(path_) : write_pvd(path_, entries_);
  }

  /// Adds a file that is complete. Throws `error` if the list cannot be written; the former list stays then.
  void add(double time, std::filesystem::path file, int part = 0) {
    entries_.push_back({time, std::move(file), part});
    try {
      write_pvd(path_, entries_);
    } catch (...) {
      entries_.pop_back();
      throw;
    }
  }

  /// Writes another list in the place of this one. Throws as `add` does.
  void replace(std::vector<PvdEntry> entries) {
    write_pvd(path_, entries);
    entries_ = std::move(entries);
  }

  const std::filesystem::path& path() const { return path_; }
  const std::vector<PvdEntry>& entries() const { return entries_; }

 private:
  std::filesystem::path path_;
  std::vector<PvdEntry> entries_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/io/pvd_cold.hpp>
#endif
