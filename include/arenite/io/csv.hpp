// A table of numbers as comma-separated text (RFC 4180 with plain names), row by row while a run goes on.
#pragma once

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <arenite/io/output_file.hpp>

namespace arenite {

/// Writes a header, then rows. Numbers stand in the shortest form that reads back as the same double. Each
/// row goes to the operating system as a whole at once, so that the file of a run that is killed ends with a
/// complete row.
class CsvWriter {
 public:
  /// Creates or empties the file. Throws `error` if it cannot be written, or if a column's name is empty,
  /// given twice, or holds a comma, a quote or a line break.
  CsvWriter(std::filesystem::path path, std::vector<std::string> columns)
      : path_(std::move(path)), columns_(columns.size()) {
    require(columns_ > 0, "columns", columns_, "a table needs at least one");
    for (auto name = columns.begin(); name != columns.end(); ++name) {
      require(!name->empty() && name->find_first_of(",\"\r\n") == std::string::npos, "column", *name,
              "a name must not be empty, nor hold a comma, a quote or a line break");
      require(std::find(columns.begin(), name, *name) == name, "column", *name, "is given twice");
      line_ += (line_.empty() ? "" : ",") + *name;
    }
    errno = 0;
    file_.open(path_, std::ios::binary | std::ios::trunc);
    if (!file_)
      shared_detail::fail_output(
          path_, "cannot be opened for writing; does the folder exist, and may you write there?", errno);
    put_line();
  }

  /// Appends a row, shape [columns]. Throws `error` if the length differs or the disk does not take it.
  void row(std::span<const double> values) {
    if (values.size() != columns_)
      require(false, "values in a row", values.size(),
              shared_detail::join("must be ", columns_, ", the number of columns of ", path_.string()));
    line_.clear();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) line_ += ',';
      shared_detail::append_number(line_, values[i]);
    }
    put_line();
  }
  void row(std::initializer_list<double> values) { row(std::span(values.begin(), values.size())); }

  const std::filesystem::path& path() const { return path_; }

 private:
  void put_line() {
    line_ += '\n';
    errno = 0;
    file_.write(line_.data(), static_cast<std::streamsize>(line_.size())).flush();
    if (!file_) shared_detail::fail_output(path_, "cannot be written; is the disk full?", errno);
  }

  std::filesystem::path path_;
  std::size_t columns_;
  std::string line_;
  std::ofstream file_;
};

}  // namespace arenite
