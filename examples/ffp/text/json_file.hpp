// JSON from files and into them. What is read may be anybody's: no content of it may do worse than throw.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace arenite::ffp {

/// Members of an object keep their order. Who makes or reads one includes <nlohmann/json.hpp>; units that compile scenes do not.
using Json = nlohmann::ordered_json;

/// The deepest that arrays and objects lie in each other; a summary has five levels.
inline constexpr int most_json_levels = 64;
/// Names in one object, each of which is compared with those before it; a summary has sixty.
inline constexpr std::size_t most_json_names = 1000;
/// Largest file; a summary has ten kilobytes.
inline constexpr std::uintmax_t most_json_bytes = std::uintmax_t{16} << 20;

Json or_null(const std::optional<double>& value);

/// As text, whatever bytes the names of files contain.
std::string json_text(const Json& value, int indent = -1);

/// The value of a text. Throws `error` "what: rule" if it is no JSON, nested too deeply, or gives a name
/// twice.
Json parse_json(std::string_view text, const std::string& what);

/// The value in a file. Throws `error` "what = path: rule" if the file cannot be read, is no regular one or
/// is too large, or is no JSON.
Json read_json(const std::filesystem::path& path, std::string_view what);

/// Throws `output_error` if the file cannot be written.
void write_json(const std::filesystem::path& path, const Json& value);

}  // namespace arenite::ffp
