#include "json_file.hpp"

#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <vector>

#include <arenite/core/error.hpp>
#include <arenite/io/input_file.hpp>
#include <arenite/io/output_file.hpp>

#include "words.hpp"

namespace arenite::ffp {

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

std::string json_text(const Json& value, int indent) {
  return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json parse_json(std::string_view text, const std::string& what) {
  const auto refuse = [&](const auto&... rule) { throw error(joined_text({what, ": ", rule...})); };
  std::vector<std::set<std::string>> names;  // of the objects that are open
  const auto watch = [&](int levels, Json::parse_event_t event, const Json& value) {
    using Event = Json::parse_event_t;
    if ((event == Event::object_start || event == Event::array_start) && levels >= most_json_levels)
      refuse("is nested deeper than ", most_json_levels, " levels");
    if (event == Event::object_start) names.emplace_back();
    if (event == Event::object_end) names.pop_back();
    if (event == Event::key) {
      const auto& name = value.get_ref<const std::string&>();
      if (!names.back().insert(name).second) refuse("gives ", shown(name), " twice");
      if (names.back().size() > most_json_names)
        refuse("has an object of more than ", most_json_names, " names");
    }
    return true;
  };
  try {
    return Json::parse(text, watch);
  } catch (const Json::exception& e) {
    refuse("is no JSON (", shown(e.what(), 200), ")");
    throw;
  }
}

Json read_json(const std::filesystem::path& path, std::string_view what) {
  const std::string name = shown(path.string());
  const std::string text = arenite::shared_detail::read_input(path, what, most_json_bytes, name);
  require(!text.empty(), what, name, "must be a file that is not empty");
  require(text.find('\0') == std::string::npos, what, name, "is UTF-16, or no text; save it as UTF-8");
  return parse_json(text, joined_text({what, " = ", name}));
}

void write_json(const std::filesystem::path& path, const Json& value) {
  arenite::shared_detail::replace_file(path, [&](std::ostream& out) { out << json_text(value, 2) << '\n'; });
}

}  // namespace arenite::ffp
