// Files in: only regular ones, and of a size that is known before they are read. A pipe would be waited for
// without end, and a device be read without end.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include <arenite/core/error.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail {

/// Largest size of a file that is only streamed: none.
inline constexpr std::uintmax_t any_size = std::numeric_limits<std::uintmax_t>::max();

/// "16 GiB", or bytes where it is no whole number of them.
std::string size_text(std::uintmax_t bytes);

/// Size of a file, bytes, that is to be read. Throws `error` "what = path: rule" if it cannot be opened, is a
/// folder, a pipe or a device, or is larger than `most`. A link is followed. `name`: the path as messages
/// show it; without, as it is.
std::uintmax_t check_input(const std::filesystem::path& path, std::string_view what,
                           std::uintmax_t most = any_size, std::string name = "");

/// An input file, open to be read.
std::ifstream open_input(const std::filesystem::path& path, std::string_view what,
                         std::uintmax_t most = any_size, const std::string& name = "");

/// All bytes of a file. Throws `error` as `check_input` does, and if the memory does not suffice.
std::string read_input(const std::filesystem::path& path, std::string_view what, std::uintmax_t most,
                       std::string name = "");

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET::shared_detail

#ifndef ARENITE_COLD_LIBRARY
#include <arenite/io/input_file_cold.hpp>
#endif
