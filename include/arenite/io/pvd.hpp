// Time series of VTK files (.pvd): the list of files and times that ParaView opens as one.
#pragma once

#include <cmath>
#include <filesystem>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/instruction_set.hpp>
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
      joined_text("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"",
                  shared_detail::vtk_byte_order(), "\">\n<Collection>\n");
  for (const PvdEntry& e : entries) {
    require(std::isfinite(e.time), "time of a step", e.time, "must be finite");
    const auto file =
        std::filesystem::absolute(e.file).lexically_normal().lexically_proximate(folder.lexically_normal());
    text += "<DataSet timestep=\"";
    shared_detail::append_number(text, e.time);
    text += joined_text("\" part=\"", e.part, "\" file=\"", shared_detail::xml_escape(file.generic_string()),
                        "\"/>\n");
  }
  text += "</Collection>\n</VTKFile>\n";
  shared_detail::replace_file(path, [&](std::ostream& out) { out << text; });
}

/// A series that grows with a run: the list on disk is complete and readable after each step.
class PvdWriter {
 public:
  /// Writes the empty list, so that a folder that cannot be written to shows at once. Throws `error` then.
  /// `keep`: leaves a list that is there as it is for now.
  explicit PvdWriter(std::filesystem::path path, bool keep = false) : path_(std::move(path)) {
    if (!keep) write_pvd(path_, entries_);
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
