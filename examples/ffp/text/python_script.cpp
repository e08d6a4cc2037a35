#include "python_script.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <cstdlib>
#include <system_error>

#include <arenite/core/error.hpp>

#include "say.hpp"

namespace arenite::ffp {

std::filesystem::path script_path(const std::string& name) {
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

bool run_script(const std::string& name, const std::vector<std::string>& arguments) {
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
