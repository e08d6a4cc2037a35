// Run status: a small JSON file on the state of a run that people, scripts and queues read during it. POSIX.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <arenite/io/output_file.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Now, as "2026-05-04T03:02:01Z".
inline std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

/// State of a run.
struct RunStatus {
  std::string_view status =
      "running";                     ///< or "finished", "stopped" (by an observer), "interrupted", "failed"
  std::string failure{};             ///< why it failed
  std::string started{}, updated{};  ///< UTC
  double time = 0, end = 0;          ///< s, of the scene
  std::size_t steps = 0, points = 0, lost_points = 0;
  double wall = 0;                   ///< s, since the start or the last resumption
  std::vector<double> resumed_at{};  ///< s, times of the scene
};

namespace shared_detail {

/// Text as a JSON string; bytes that are no ASCII stay, as UTF-8.
inline std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      std::array<char, 8> code{};
      std::snprintf(code.data(), code.size(), "\\u%04x", static_cast<unsigned>(c));
      out += code.data();
    } else {
      out += c;
    }
  }
  return out + '"';
}

}  // namespace shared_detail

/// Writes the status as JSON in place of the previous file. Throws `output_error` if it cannot.
inline void write_run_status(const std::filesystem::path& file, const RunStatus& run) {
  using shared_detail::json_string;
  const auto number = [](double x) {
    std::string text;
    append_number(text, x);
    return text;
  };
  std::string resumed;
  for (const double t : run.resumed_at) resumed += (resumed.empty() ? "" : ", ") + number(t);
  const std::string text = joined_text({"{\n  \"status\": ",
                                        json_string(run.status),
                                        ",\n  \"failure\": ",
                                        run.failure.empty() ? "null" : json_string(run.failure),
                                        ",\n  \"started\": ",
                                        json_string(run.started),
                                        ",\n  \"updated\": ",
                                        json_string(run.updated),
                                        ",\n  \"process\": ",
                                        ::getpid(),
                                        ",\n  \"time_s\": ",
                                        number(run.time),
                                        ",\n  \"end_s\": ",
                                        number(run.end),
                                        ",\n  \"steps\": ",
                                        run.steps,
                                        ",\n  \"points\": ",
                                        run.points,
                                        ",\n  \"lost_points\": ",
                                        run.lost_points,
                                        ",\n  \"wall_s\": ",
                                        number(run.wall),
                                        ",\n  \"resumed_at_s\": [",
                                        resumed,
                                        "]\n}\n"});
  replace_file(file, [&](std::ostream& out) { out << text; });
}

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
