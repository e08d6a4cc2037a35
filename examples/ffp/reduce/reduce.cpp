// The reduction from file to files. No scene is included here, so that it compiles in seconds.
#include "reduce.hpp"

#include <filesystem>
#include <iostream>
#include <system_error>

#include "../text/python_script.hpp"
#include "../text/say.hpp"
#include "../text/words.hpp"
#include "read_measurement.hpp"
#include "reduction.hpp"
#include "reduction_files.hpp"

namespace arenite::ffp {

namespace {

std::filesystem::path folder_of(const ReduceOptions& o) {
  if (!o.out.empty()) return o.out;
  const std::filesystem::path file{o.file};
  if (std::filesystem::is_directory(file)) return file;
  return file.has_parent_path() ? file.parent_path() : ".";
}

void write(const std::filesystem::path& folder, const Reduction& r, const ReduceOptions& o) {
  write_reduced_csv(folder / "reduced.csv", r, o);
  write_reduced_json(folder / "reduced.json", r, o);
}

}  // namespace

void reduce(const ReduceOptions& o) {
  const Reduction r = reduce(read_measurement(o), o);
  for (const std::string& text : r.warnings) say("warning: " + text);
  const auto folder = folder_of(o);
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  require(!code, "--out", shown(folder.string()), "the folder cannot be made: " + code.message());
  write(folder, r, o);
  if (!o.quiet) {
    print_table(r, o, std::cout);
    std::cout << "\nFiles: " << shown((folder / "reduced.csv").string()) << ", reduced.json" << std::endl;
  }
  if (!o.no_picture && run_script("plot_reduced.py", {folder.string()}) && !o.quiet)
    std::cout << "Pictures: " << shown((folder / "reduced.png").string()) << ", reduced.svg" << std::endl;
}

void reduce_drop(const std::string& folder) {
  ReduceOptions o;
  o.file = folder;
  write(folder, reduce(read_measurement(o), o), o);
}

}  // namespace arenite::ffp
