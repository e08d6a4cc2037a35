// arenite-ffp where it is built for many machines: starts the build of the driver beside it that has the
// widest registers which this processor knows. Whole programs, and not parts of one: an inline function
// compiled for a wide machine can then not be the one that the linker keeps for a narrow one.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

namespace {

/// Whether this processor computes in registers of `width` bytes.
bool processor_has(int width) {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (width == 64)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  if (width == 32) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
  return width == 16;
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
  const auto start = [&](const std::string& width) {
    return ::execv((self.parent_path() / ("arenite-ffp-" + width)).c_str(), argv);
  };
  // The width that the environment asks for (to compare), else the widest that is built and supported.
  if (const char* wanted = std::getenv("ARENITE_REGISTER_BYTES")) {
    start(wanted);
    std::cerr << "arenite-ffp: ARENITE_REGISTER_BYTES = " << wanted
              << ": there is no such build of the driver in " << self.parent_path().string() << '\n';
    return 2;
  }
  for (const int width : {64, 32, 16})
    if (processor_has(width)) start(std::to_string(width));
  std::cerr << "arenite-ffp: no build of the driver in " << self.parent_path().string()
            << " can be started on this processor\n";
  return 2;
}
