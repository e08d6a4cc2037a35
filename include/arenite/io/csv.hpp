// A table of numbers as comma-separated text (RFC 4180 with plain names), row by row during a run.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/core/instruction_set.hpp>
#include <arenite/io/output_file.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Writes a header, then rows. Numbers stand in the shortest form that reads back as the same double. Each
/// row goes to the operating system as a whole at once. If the process is killed (SIGKILL) inside that call,
/// Linux may keep the part of the row up to the next memory page: a last line without a line break is to be
/// ignored.
class CsvWriter {
 public:
  /// Creates the file, replacing a file or link of its name, or keeps the first `kept` bytes of the existing
  /// one, for a run that is resumed; that must be a regular file. Throws `error` if it cannot be written, if
  /// it is shorter than that or begins with other columns, or if a column's name is empty, given twice, or
  /// contains a comma, a quote or a line break.
  CsvWriter(std::filesystem::path path, std::vector<std::string> columns, std::uintmax_t kept = 0)
      : path_(std::move(path)), columns_(columns.size()) {
    require(columns_ > 0, "columns", columns_, "a table needs at least one");
    for (auto name = columns.begin(); name != columns.end(); ++name) {
      require(!name->empty() && name->find_first_of(",\"\r\n") == std::string::npos, "column", *name,
              "a name must not be empty, nor hold a comma, a quote or a line break");
      require(std::find(columns.begin(), name, *name) == name, "column", *name, "is given twice");
      line_ += (line_.empty() ? "" : ",") + *name;
    }
    file_ = kept > 0 ? shortened(kept) : shared_detail::make_file(path_, path_);
    std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // a row is one write
    if (kept == 0) put_line();
    written_ = kept > 0 ? kept : written_;
  }

  /// Appends a row, shape [columns]. Throws `error` if the length differs, `output_error` if it
  /// cannot be written; the file then ends with the row before.
  void row(std::span<const double> values) { put_row(values); }
  /// Writes a row; a missing value is an empty field.
  void row(std::span<const std::optional<double>> values) { put_row(values); }
  void row(std::initializer_list<double> values) { row(std::span(values.begin(), values.size())); }

  const std::filesystem::path& path() const { return path_; }
  /// Length of the file so far.
  std::uintmax_t bytes() const { return written_; }

 private:
  /// Opens the file that is there, cut to its first bytes; it must have the same columns.
  shared_detail::FileHandle shortened(std::uintmax_t kept) const {
    shared_detail::FileHandle file = shared_detail::open_to_change(path_);
    std::string head(line_.size() + 1, '\0');
    const bool same =
        std::fread(head.data(), 1, head.size(), file.get()) == head.size() && head == line_ + '\n';
    std::fseek(file.get(), 0, SEEK_END);
    require(
        same && std::ftell(file.get()) >= 0 && static_cast<std::uintmax_t>(std::ftell(file.get())) >= kept,
        "table", path_.string(), {"must be there, with the columns ", line_, ", and hold ", kept, " bytes"});
    if (const int reason = shared_detail::cut_file(file.get(), path_, kept); reason != 0)
      shared_detail::fail_output(path_, "cannot be shortened", reason);
    std::fseek(file.get(), 0, SEEK_END);
    return file;
  }

  template <class Values>
  void put_row(const Values& values) {
    if (values.size() != columns_)
      require(false, "values in a row", values.size(),
              {"must be ", columns_, ", the number of columns of ", path_.string()});
    line_.clear();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) line_ += ',';
      const std::optional<double> value = values[i];
      if (value) shared_detail::append_number(line_, *value);
    }
    put_line();
  }

  void put_line() {
    line_ += '\n';
    errno = 0;
    const bool open = file_ != nullptr;  // not any more after a row that could not be written
    if (open && std::fwrite(line_.data(), 1, line_.size(), file_.get()) == line_.size()) {
      written_ += line_.size();
      return;
    }
    const int reason = errno;
    if (open) shared_detail::cut_file(file_.get(), path_, written_);  // the part of the row that fitted
    file_.reset();
    shared_detail::fail_output(path_, "cannot be written; is the disk full?", reason);
  }

  std::filesystem::path path_;
  std::size_t columns_;
  std::string line_;
  std::uintmax_t written_ = 0;  // bytes of whole lines
  shared_detail::FileHandle file_;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
