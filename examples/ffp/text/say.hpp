// Messages of the driver while it works: lines on standard error.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <string>

namespace arenite::ffp {

/// Writes "arenite-ffp: text" as a line; on a terminal it takes the place of a line of progress.
inline void say(const std::string& text) {
  std::fprintf(stderr, "%sarenite-ffp: %s\n", isatty(STDERR_FILENO) ? "\r\033[K" : "", text.c_str());
}

}  // namespace arenite::ffp
