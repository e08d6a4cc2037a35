// The version of the driver, which is the project's; CMake gives it.
#pragma once

#ifndef ARENITE_FFP_VERSION
#define ARENITE_FFP_VERSION "unknown"
#endif

namespace arenite::ffp {

inline constexpr const char* version = ARENITE_FFP_VERSION;

}  // namespace arenite::ffp
