// The version of the library. The three numbers are the one place where it is written: CMake and the Conan
// recipe read them here.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <string_view>

#define ARENITE_VERSION_MAJOR 0
#define ARENITE_VERSION_MINOR 1
#define ARENITE_VERSION_PATCH 0

/// The three as one number that grows with each version, major * 10000 + minor * 100 + patch:
/// `#if ARENITE_VERSION >= 200` asks for 0.2.0 or newer.
#define ARENITE_VERSION (ARENITE_VERSION_MAJOR * 10000 + ARENITE_VERSION_MINOR * 100 + ARENITE_VERSION_PATCH)

// The name of a namespace in this version: v0_1. Here and below two macros, so that the numbers' names are replaced first.
#define ARENITE_JOINED_NAME(major, minor, name) v##major##_##minor##name
#define ARENITE_VERSIONED_NAME(major, minor, name) ARENITE_JOINED_NAME(major, minor, name)
#define ARENITE_VERSION_NAMESPACE ARENITE_VERSIONED_NAME(ARENITE_VERSION_MAJOR, ARENITE_VERSION_MINOR, )

#define ARENITE_DOTTED_TEXT(major, minor, patch) #major "." #minor "." #patch
#define ARENITE_DOTTED(major, minor, patch) ARENITE_DOTTED_TEXT(major, minor, patch)

namespace arenite::inline ARENITE_VERSION_NAMESPACE {

/// As "0.1.0".
inline constexpr std::string_view library_version =
    ARENITE_DOTTED(ARENITE_VERSION_MAJOR, ARENITE_VERSION_MINOR, ARENITE_VERSION_PATCH);

}  // namespace arenite::inline ARENITE_VERSION_NAMESPACE

#undef ARENITE_DOTTED
#undef ARENITE_DOTTED_TEXT
