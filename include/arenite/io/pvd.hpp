// Time series of VTK files (.pvd): the list of files and times that ParaView opens as one.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite/core/warning.hpp>
#include <arenite/io/input_file.hpp>
#include <arenite/io/output_file.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// One file of a series.
struct PvdEntry {
  double time = 0;             ///< s
  std::filesystem::path file;  ///< as one would open it; the list names it relative to its own folder
  int part = 0;                ///< tells apart the files of one time: points, device, mesh
};

/// Writes a series to `path`, whose folder must exist. Throws `error` if a time is not finite or the disk
/// refuses.
inline void write_pvd(const std::filesystem::path& path, std::span<const PvdEntry> entries) {
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
    text += joined_text({"\" part=\"", e.part, "\" file=\"", shared_detail::xml_escape(file.generic_string()),
                        "\"/>\n"});
  }
  text += "</Collection>\n</VTKFile>\n";
  shared_detail::replace_file(path, [&](std::ostream& out) { out << text; });
}

/// Times of a series in ascending order, s; none if there is no list.
inline std::vector<double> pvd_times(const std::filesystem::path& path) {
  std::vector<double> times;
  std::error_code status;
  if (!std::filesystem::is_regular_file(path, status)) return times;
  const std::string text = shared_detail::read_input(path, "series", std::uintmax_t{1} << 30);
  constexpr std::string_view before = "<DataSet timestep=\"";
  for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
    double time = 0;
    at += before.size();
    std::from_chars(text.data() + at, text.data() + text.size(), time);
    if (times.empty() || time > times.back()) times.push_back(time);
  }
  return times;
}

/// What stays of a series `path`, with frames at the times `earlier`, s, under the name of a run that begins
/// at `time`, s: the frames before that, if the run goes on with them (`resumed`). A run that begins anew
/// replaces them, with a warning; one that begins behind their first is hardly meant to: throws `error`.
inline std::vector<double> kept_times(const std::filesystem::path& path, const std::vector<double>& earlier,
                                      double time, bool resumed) {
  if (earlier.empty()) return {};
  const std::string file = path.string();
  const auto end = std::lower_bound(earlier.begin(), earlier.end(), time);
  const std::string holds =
      joined_text({"series = ", file, ": holds ", earlier.size(),
                  " frames of an earlier run, t = ", earlier.front(), " to ", earlier.back(), " s"});
  if (end == earlier.begin())
    warn(joined_text({holds, ", which are replaced (another prefix keeps them)"}));
  else if (!resumed)
    throw error(joined_text({holds, ", which this one, from t = ", time,
                            " s on, would replace: to go on with them say resumed, else remove ",
                            file.substr(file.rfind('/') + 1), " or take another prefix"}));
  return {earlier.begin(), end};
}

/// A series that grows with a run: the list on disk is complete and readable after each step.
class PvdWriter {
 public:
  /// Writes the empty list, so that a folder that cannot be written to shows at once. Throws `error` then.
  /// `keep`: leaves a list that is there as it is for now.
  explicit PvdWriter(std::filesystem::path path, bool keep = false) : path_(std::move(path)) {
    std::error_code status;
    if (!keep || !std::filesystem::exists(path_, status)) write_pvd(path_, entries_);
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
