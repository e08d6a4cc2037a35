// Files out, such that a run that dies leaves nothing broken behind: a file is written under a temporary name
// and takes its own when it is complete. Also what all writers share: numbers as text, and the message of a
// failed write.
#pragma once

#include <array>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <arenite/core/error.hpp>

namespace arenite {

/// A file that the operating system does not take.
class output_error : public error {
 public:
  output_error(const std::string& text, int reason) : error{text}, reason_{reason} {}
  /// The operating system's number for the reason, 0 if it gave none.
  int reason() const { return reason_; }
  /// Whether there is no space left: on the disk, or of what the user may fill.
  bool disk_full() const {
    const std::errc code{reason_};
#ifdef EDQUOT
    if (reason_ == EDQUOT) return true;
#endif
    return code == std::errc::no_space_on_device || code == std::errc::file_too_large;
  }

 private:
  int reason_;
};

namespace shared_detail {

/// Throws "output = path: what (reason of the operating system)".
[[noreturn]] inline void fail_output(const std::filesystem::path& path, std::string_view what, int reason) {
  throw output_error(
      joined_text("output = ", path.string(), ": ", what, " (",
                  reason != 0 ? std::generic_category().message(reason) : "unknown reason", ")"),
      reason);
}

/// Calls `write(std::ostream&)` on "path.part" and renames it to `path`, so that `path` is at any time
/// absent, the old file, or the new one. The folder must exist. Throws `output_error` if it cannot be
/// written; "path.part" is gone then.
template <class Write>
void replace_file(const std::filesystem::path& path, Write&& write) {
  std::filesystem::path part = path;
  part += ".part";
  errno = 0;
  std::ofstream file(part, std::ios::binary | std::ios::trunc);
  if (!file)
    fail_output(path, "cannot be opened for writing; does the folder exist, and may you write there?", errno);
  const auto discard = [&] {
    std::error_code ignored;
    file.close();
    std::filesystem::remove(part, ignored);
  };
  try {
    write(static_cast<std::ostream&>(file));
    file.close();
  } catch (...) {
    discard();
    throw;
  }
  if (!file) {
    const int reason = errno;
    discard();
    fail_output(path, "cannot be written; is the disk full?", reason);
  }
  std::error_code status;
  std::filesystem::rename(part, path, status);
  if (status) {
    discard();
    fail_output(path, "cannot be put in place", status.value());
  }
}

/// Appends the shortest text that reads back as the same double ("nan", "inf" and "-inf" for what is no
/// number).
inline void append_number(std::string& text, double value) {
  std::array<char, 32> digits{};
  if (std::isnan(value)) value = std::abs(value);
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

/// Text as the value of an XML attribute.
inline std::string xml_escape(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// "LittleEndian" or "BigEndian", as this machine is.
inline constexpr const char* vtk_byte_order() {
  return std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
}

}  // namespace shared_detail
}  // namespace arenite
