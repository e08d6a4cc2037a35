#include "values.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "../options/option_table.hpp"
#include "../options/option_visitor.hpp"
#include "../text/words.hpp"
#include "input_file.hpp"

namespace arenite::ffp {

namespace {

/// Values by the names of their options, "--cell-at-cone": true or false, a number, a text.
using GivenValues = std::map<std::string, Json>;

/// Takes the values of one table's options, and lists the options.
class ValueReader : public detail::OptionVisitor<ValueReader> {
 public:
  explicit ValueReader(GivenValues given) : given_{std::move(given)} {}

  template <class Take>
  void add(const std::string& name, std::string_view takes, const std::string& help, Take take) {
    list(name, takes, help);
    if (const auto found = given_.extract(name)) take(text_of(found.mapped(), takes == "on|off"));
  }
  void flag(const std::string& name, bool& to, const std::string& help) {
    list(name, "", help);
    const auto found = given_.extract(name);
    if (!found) return;
    require(found.mapped().is_boolean(), name, shown(text_of(found.mapped())), "takes no value");
    to = found.mapped().get<bool>();
  }

  /// Throws `error` for a value that no option has taken.
  void finish(const std::string& command) const {
    for (const auto& [name, value] : given_)
      throw error(joined_text(
          {shown(value.is_boolean() ? name : name + "=" + text_of(value)), ": no such option of ", command}));
  }
  /// Objects of "option", "takes" (empty: a flag), "group" and "help".
  const Json& options() const { return options_; }

 private:
  static std::string text_of(const Json& value, bool on_off = false) {
    if (value.is_string()) return value.get<std::string>();
    if (on_off && value.is_boolean()) return value.get<bool>() ? "on" : "off";
    return json_text(value);
  }
  void list(const std::string& name, std::string_view takes, const std::string& help) {
    options_.push_back({{"option", name}, {"takes", takes}, {"group", group_}, {"help", help}});
  }

  GivenValues given_;
  Json options_ = Json::array();
};

/// Values by keywords, "cell_at_cone". null is an option that is not given.
GivenValues given_values(const Json& options) {
  require(options.is_object(), "values", "options", "must be an object");
  GivenValues given;
  for (const auto& [keyword, value] : options.items()) {
    if (value.is_null()) continue;
    std::string name = "--" + keyword;
    std::ranges::replace(name, '_', '-');
    require(value.is_primitive(), name, shown(json_text(value)), "must be a number, a text, true or false");
    if (value == "") throw error(shown(name) + " = : needs a value");
    given[name] = value;
  }
  return given;
}

/// Adds what stands in the file of `--input`, where there is no value yet.
void take_input(GivenValues& given) {
  const auto input = given.extract("--input");
  if (!input) return;
  require(input.mapped().is_string(), "--input", json_text(input.mapped()), "must be a name of a file");
  for (const std::string& word : words_of_input(input.mapped().get<std::string>())) {
    const auto sign = word.find('=');
    given.emplace(word.substr(0, sign), sign == std::string::npos ? Json(true) : Json(word.substr(sign + 1)));
  }
}

template <class Options, class Visit>
Options options_of(const std::string& command, GivenValues given, Visit visit, Options options = {}) {
  ValueReader reader{std::move(given)};
  visit(options, reader);
  reader.finish(command);
  if constexpr (std::is_base_of_v<DeviceOptions, Options>) read_device(options);
  check(options);
  return options;
}

}  // namespace

std::optional<Command> command_of_values(const Json& all, std::ostream& answer) {
  require(all.is_object(), "values", shown(json_text(all)), "must be an object: {\"command\": \"drop\", ..}");
  const auto text = [&](const char* name) {
    const Json found = all.value(name, Json(""));
    require(found.is_string(), "values", name, "must be a text");
    return found.get<std::string>();
  };
  const auto drop = [](auto& o, auto& reader) { visit_options(o, reader); };
  const auto push = [](auto& o, auto& reader) { visit_push_options(o, reader); };
  const auto reduce = [](auto& o, auto& reader) { visit_reduce_options(o, reader); };
  const auto paper = [](auto& o, auto& reader) { visit_paper_options(o, reader); };
  const std::string command = text("command");
  if (command == "options") {
    const auto tell = [&](auto options, auto visit) {
      ValueReader reader{{}};
      visit(options, reader);
      answer << json_text(reader.options()) << '\n';
      return std::nullopt;
    };
    const std::string of = text("of");
    if (of == "drop") return tell(DropOptions{}, drop);
    if (of == "push") return tell(PushOptions{}, push);
    if (of == "reduce") return tell(ReduceOptions{}, reduce);
    if (of == "paper") return tell(PaperOptions{}, paper);
    refuse_command(of);
  }
  auto given = given_values(all.value("options", Json::object()));
  if (command == "drop") {
    take_input(given);
    return options_of<DropOptions>(command, std::move(given), drop);
  }
  if (command == "push") return options_of<PushOptions>(command, std::move(given), push);
  if (command == "reduce") {
    ReduceOptions options;
    options.file = text("file");
    return options_of(command, std::move(given), reduce, std::move(options));
  }
  if (command == "paper") return options_of<PaperOptions>(command, std::move(given), paper);
  refuse_command(command);
}

std::optional<Command> read_values(std::istream& in, std::ostream& answer) {
  std::string text;
  for (int c = in.get(); c != std::istream::traits_type::eof(); c = in.get()) {
    text += static_cast<char>(c);
    require(text.size() <= most_json_bytes, "values", "standard input",
            "must have at most " + arenite::shared_detail::size_text(most_json_bytes));
  }
  return command_of_values(parse_json(text, "values"), answer);
}

}  // namespace arenite::ffp
