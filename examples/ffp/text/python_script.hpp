// The driver's Python scripts: where they are, and how they are run. POSIX.
#pragma once

#include <cerrno>
#include <filesystem>
#include <string>
#include <vector>

namespace arenite::ffp {

/// Debian's own Python by its path: another, without matplotlib, may come first.
inline constexpr const char* python = "/usr/bin/python3";

/// Where a script lies: in the folder that the environment's ARENITE_FFP_SCRIPTS names, beside the sources
/// that the program was built from, or installed in share/arenite/ffp beside the program's bin. Empty:
/// nowhere.
std::filesystem::path script_path(const std::string& name);

/// Runs a script with arguments and waits for it; what it prints on standard output is dropped. Says the
/// command that the user can give if it cannot be run or fails; returns whether it succeeded.
bool run_script(const std::string& name, const std::vector<std::string>& arguments);

}  // namespace arenite::ffp
