// The path of a file as an argument, without the header <filesystem>, which costs every unit that includes it.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <concepts>
#include <string>
#include <string_view>
#include <utility>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Text, or a `std::filesystem::path`.
class FilePath {
 public:
  FilePath(const char* path) : text_(path) {}
  FilePath(std::string_view path) : text_(path) {}
  FilePath(std::string path) : text_(std::move(path)) {}
  template <class Path>
  requires requires(const Path& path) {
    { path.string() } -> std::same_as<std::string>;
  }
  FilePath(const Path& path) : text_(path.string()) {}

  const std::string& string() const { return text_; }

 private:
  std::string text_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
