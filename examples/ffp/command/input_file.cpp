#include "input_file.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "../options/option_table.hpp"
#include "../text/json_file.hpp"

namespace arenite::ffp {

namespace {

/// Key of an option in a summary: "--device-young" with the unit Pa is "device_young_Pa", "N/m^3" is "N_m3".
std::string key_of(std::string_view option, std::string_view unit = "") {
  std::string key{option.substr(2)};
  if (!unit.empty()) key += "_" + std::string{unit};
  std::erase(key, '^');
  std::ranges::replace_if(
      key, [](char c) { return c == '-' || c == '/'; }, '_');
  return key;
}

/// Lists each option's key, and whether it is a flag.
struct KeyList {
  struct Option {
    std::string name;
    bool is_flag = false;
  };
  std::map<std::string, Option, std::less<>> of_key{};

  void group(const char*) {}
  template <class Number>
  void number(const char* name, const Number&, const char*, const Range& range, std::string_view) {
    of_key[key_of(name, range.unit)] = {name};
  }
  template <class Words, class Value>
  void choice(const char* name, const Words&, const Value&, const char*) {
    of_key[key_of(name)] = {name};
  }
  void counts(const char* name, const std::optional<int>&, std::string_view) {
    of_key[key_of(name)] = {name};
  }
  void text(const char* name, const std::string&, const char*, const char*) { of_key[key_of(name)] = {name}; }
  void flag(const char* name, bool, const char*) { of_key[key_of(name)] = {name, true}; }
};

/// Whether an entry of a summary is no option, or one that was not given: it becomes no word. Throws
/// `error` if the model cannot have this value.
bool is_no_option(const std::string& key, const Json& value, const Json& all) {
  if (value.is_null()) return true;
  if (key == "mesh") return value == "generated";
  if (key == "fillet_m") return value == 0 && all.value("shoulder", Json()) != "fillet";
  if (key != "gravity_m_s2") return false;
  require(value == standard_gravity, "gravity_m_s2", json_text(value), {"must be ", standard_gravity});
  return true;
}

}  // namespace

std::vector<std::string> words_of_input(const std::string& path) {
  const auto refuse = [&](const std::string& rule) -> void {
    throw error(joined_text({"--input = ", shown(path), ": ", rule}));
  };
  const Json all = read_json(path, "--input");
  if (!all.is_object()) refuse("must hold an object: {\"delta_deg\": 30, ..}");
  const auto& inputs = all.contains("inputs") ? all["inputs"] : all;
  if (!inputs.is_object()) refuse("\"inputs\" must be an object");
  const DropOptions defaults;
  KeyList keys;
  visit_options(defaults, keys);
  if (&inputs != &all && !all.contains("status"))  // by hand: a summary has results of such names
    for (const auto& [key, value] : all.items())
      if (keys.of_key.contains(key)) refuse(key + " stands beside \"inputs\"; put it there");
  std::vector<std::string> words;
  for (const auto& [key, value] : inputs.items()) {
    try {
      if (is_no_option(key, value, inputs)) continue;
    } catch (const error& e) {
      refuse(e.what());
    }
    if (key == "device_profile" && value.is_object()) {
      words.push_back("--device-file=" + json_text(value));
      continue;
    }
    const auto option = keys.of_key.find(key);
    if (option == keys.of_key.end()) {
      refuse(shown(key) + ": no such input; the keys are those of \"inputs\" in a summary.json");
    } else if (option->second.is_flag) {
      if (!value.is_boolean()) refuse(key + " = " + shown(json_text(value)) + ": must be true or false");
      if (value.get<bool>()) words.push_back(option->second.name);
    } else {
      if (!value.is_number() && !value.is_string())
        refuse(key + " = " + shown(json_text(value)) + ": must be a number or a word");
      words.push_back(option->second.name + "=" +
                      (value.is_string() ? value.get<std::string>() : json_text(value)));
    }
  }
  return words;
}

}  // namespace arenite::ffp
