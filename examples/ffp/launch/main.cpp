// arenite-ffp where it is built for many machines: starts the build of the driver beside it that has the
// widest registers which this processor knows. Whole programs, and not parts of one: an inline function
// compiled for a wide machine can then not be the one that the linker keeps for a narrow one.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

namespace {

/// Bytes of the registers to compute in: what the environment asks for (to compare), else the most there are.
std::string width() {
  if (const char* wanted = std::getenv("ARENITE_REGISTER_BYTES")) return wanted;
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
    return "64";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "32";
#endif
  return "16";
}

}  // namespace

int main(int, char** argv) {
  std::error_code code;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", code);
  if (code) {
    std::cerr << "arenite-ffp: /proc/self/exe cannot be read (" << code.message()
              << "), so its parts are not found\n";
    return 1;
  }
  const auto program = self.parent_path() / ("arenite-ffp-" + width());
  ::execv(program.c_str(), argv);
  std::cerr << "arenite-ffp: " << program.string()
            << " cannot be started; ARENITE_REGISTER_BYTES must be 16, 32 or 64\n";
  return 2;
}
