// The driver's Python scripts: where they are, and how they are run. POSIX.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "say.hpp"

namespace arenite::ffp {

/// Debian's own Python by its path: another, without matplotlib, may come first.
inline constexpr const char* python = "/usr/bin/python3";

/// Where a script lies: in the folder that the environment's ARENITE_FFP_SCRIPTS names, beside the sources
/// that the program was built from, or installed in share/arenite/ffp beside the program's bin. Empty:
/// nowhere.
inline std::filesystem::path script_path(const std::string& name) {
  std::error_code code;
  std::vector<std::filesystem::path> folders;
  if (const char* given = std::getenv("ARENITE_FFP_SCRIPTS")) {
    folders.emplace_back(given);
  } else {
#ifdef ARENITE_FFP_SOURCE
    folders.emplace_back(ARENITE_FFP_SOURCE);
#endif
    const auto program = std::filesystem::read_symlink("/proc/self/exe", code);
    if (!code) folders.push_back(program.parent_path().parent_path() / "share" / "arenite" / "ffp");
  }
  for (const auto& folder : folders)
    if (std::filesystem::exists(folder / name, code)) return folder / name;
  return {};
}

/// Runs a script with arguments and waits for it; what it prints on standard output is dropped. Says the
/// command that the user can give if it cannot be run or fails; returns whether it succeeded.
inline bool run_script(const std::string& name, const std::vector<std::string>& arguments) {
  const auto script = script_path(name);
  std::string command = python + (" " + (script.empty() ? name : script.string()));
  for (const auto& argument : arguments) command += " '" + argument + "'";
  std::error_code code;
  if (script.empty() || !std::filesystem::exists(python, code)) {
    say(joined_text({script.empty() ? name : std::string{python},
                     " is not there, so nothing is drawn; the command: ", command}));
    return false;
  }
  std::vector<std::string> words{python, script.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    if (::freopen("/dev/null", "w", stdout) == nullptr) ::_exit(127);
    ::execv(python, argv.data());
    ::_exit(127);
  }
  int status = 0;
  while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
  say("nothing is drawn; the command, once what it misses is there: " + command);
  return false;
}

}  // namespace arenite::ffp
