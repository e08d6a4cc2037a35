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

#if ARENITE_HAS_COLD

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>

#include <arenite/core/warning.hpp>
#include <arenite/io/input_file.hpp>
#include <arenite/io/output_file.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_COLD void write_pvd(const std::filesystem::path& path, std::span<const PvdEntry> entries) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  std::string text =
      joined_text({"<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"",
                   shared_detail::vtk_byte_order(), "\">\n<Collection>\n"});
  for (const PvdEntry& e : entries) {
    require(std::isfinite(e.time), "time of a step", e.time, "must be finite");
    const auto file =
        std::filesystem::absolute(e.file).lexically_normal().lexically_proximate(folder.lexically_normal());
    text += "<DataSet timestep=\"";
    shared_detail::append_number(text, e.time);
    text += joined_text(
        {"\" part=\"", e.part, "\" file=\"", shared_detail::xml_escape(file.generic_string()), "\"/>\n"});
  }
  text += "</Collection>\n</VTKFile>\n";
  shared_detail::replace_file(path, [&](std::ostream& out) { out << text; });
}

ARENITE_COLD void check_pvd(const std::filesystem::path& path) {
  std::error_code status;
  const std::filesystem::path trial =  // the memory of ranks lies elsewhere
      joined_text({path.string(), ".", reinterpret_cast<std::uintptr_t>(&status), ".pvd"});
  try {
    write_pvd(trial, {});
  } catch (const error&) {
    if (!std::filesystem::exists(path, status)) write_pvd(path, {});  // says so of the list
  }
  std::filesystem::remove(trial, status);
}

ARENITE_COLD std::vector<PvdEntry> pvd_entries(const std::filesystem::path& path) {
  std::vector<PvdEntry> entries;
  std::error_code status;
  if (!std::filesystem::is_regular_file(path, status)) return entries;
  const std::string text = shared_detail::read_input(path, "series", std::uintmax_t{1} << 30);
  constexpr std::string_view begin = "<DataSet ";
  for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin, at + 1)) {
    const std::string_view tag(text.data() + at, std::min(text.find("/>", at), text.size()) - at);
    const auto value = [tag](std::string_view name) {
      const std::size_t found = tag.find(name), from = found + name.size();
      return found == tag.npos ? std::string_view{} : tag.substr(from, tag.find('"', from) - from);
    };
    PvdEntry& e = entries.emplace_back();
    const auto time = value(" timestep=\""), part = value(" part=\"");
    std::from_chars(time.data(), time.data() + time.size(), e.time);
    std::from_chars(part.data(), part.data() + part.size(), e.part);
    e.file = path.parent_path() / shared_detail::xml_unescape(value(" file=\""));
  }
  return entries;
}

ARENITE_COLD std::vector<double> pvd_times(const std::filesystem::path& path) {
  std::vector<double> times;
  for (const PvdEntry& e : pvd_entries(path))
    if (times.empty() || e.time > times.back()) times.push_back(e.time);
  return times;
}

ARENITE_COLD std::vector<double> kept_times(const std::filesystem::path& path,
                                            const std::vector<double>& earlier, double time, bool resumed,
                                            bool warns) {
  if (earlier.empty()) return {};
  const std::string file = path.string();
  const auto end = std::lower_bound(earlier.begin(), earlier.end(), time);
  const std::string holds =
      joined_text({"series = ", file, ": holds ", earlier.size(),
                   " frames of an earlier run, t = ", earlier.front(), " to ", earlier.back(), " s"});
  if (end == earlier.begin()) {
    if (warns) warn(joined_text({holds, ", which are replaced (another prefix keeps them)"}));
  } else if (!resumed) {
    throw error(joined_text({holds, ", which this one, from t = ", time,
                             " s on, would replace: to go on with them say resumed, else remove ",
                             file.substr(file.rfind('/') + 1), " or take another prefix"}));
  }
  return {earlier.begin(), end};
}

ARENITE_COLD std::vector<PvdEntry> kept_entries(const std::filesystem::path& path, double time, bool resumed,
                                                bool warns) {
  const auto times = kept_times(path, pvd_times(path), time, resumed, warns);
  auto entries = pvd_entries(path);
  while (!entries.empty() && (times.empty() || entries.back().time > times.back())) entries.pop_back();
  return entries;
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#endif  // ARENITE_HAS_COLD
