// The command line `arenite-ffp drop ...`, read with CLI11. Whatever is wrong with it becomes one `error` of
// one sentence that names option, value and rule.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <optional>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

#include "options.hpp"

namespace arenite::ffp {
namespace detail {

/// The whole text as a number; throws `error("--option = text: must be a number")`.
template <class Number>
Number parse_number(const std::string& option, const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [at, code] = std::from_chars(text.data(), end, value);
  const char* rule = std::is_integral_v<Number> ? "must be a whole number" : "must be a number";
  require(code == std::errc{} && at == end, option, text, rule);
  return value;
}

/// Adds the options of a drop to a CLI11 application, one line an option.
class DropOptionAdder {
 public:
  explicit DropOptionAdder(CLI::App& app) : app_{app} {}

  template <class Number>
  void number(const std::string& name, Number& to, const char* unit, const std::string& text) {
    const std::string standard = join(to);
    add(name, unit, text + " [" + standard + "]",
        [name, &to](const std::string& word) { to = parse_number<Number>(name, word); });
  }
  template <class Number>
  void number(const std::string& name, std::optional<Number>& to, const char* unit, const std::string& text) {
    add(name, unit, text, [name, &to](const std::string& word) { to = parse_number<Number>(name, word); });
  }
  void text(const std::string& name, std::string& to, const char* unit, const std::string& text) {
    add(name, unit, text + (to.empty() ? "" : " [" + to + "]"), [name, &to](const std::string& word) {
      require(!word.starts_with("--"), name, word, "must be a name, not the next option");
      to = word;
    });
  }
  template <class Words, class Value>
  void choice(const std::string& name, const Words& words, Value& to, const std::string& text) {
    std::string all, rule;
    for (const auto& [word, meaning] : words) {
      all += (all.empty() ? "" : "|") + std::string{word};
      rule += (rule.empty() ? "must be " : " or ") + std::string{word};
    }
    add(name, all.c_str(), text + " [" + word_of(words, to) + "]",
        [name, words, rule, &to](const std::string& given) {
          for (const auto& [word, meaning] : words)
            if (word == given) {
              to = meaning;
              return;
            }
          throw error(join(name, " = ", given, ": ", rule));
        });
  }
  void flag(const std::string& name, bool& to, const std::string& text) {
    app_.add_flag(name, to, text)->group(group);
  }

  std::string group;

 private:
  template <class Take>
  void add(const std::string& name, const char* unit, const std::string& text, Take take) {
    app_.add_option_function<std::string>(name, take, text)
        ->type_name(unit)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
        ->group(group);
  }

  CLI::App& app_;
};

inline void add_drop_options(CLI::App& app, DropOptions& o) {
  DropOptionAdder add{app};
  add.group = "Model";
  add.choice("--kinematics", kinematics_words, o.kinematics,
             "Half-section of triangles, or the 20-degree slice of tetrahedra");
  add.choice("--device", device_words, o.device, "Penetrometer that moves as one, or one that deforms");
  add.number("--velocity", o.velocity, "M_S", "Velocity at the impact, m/s");
  add.number("--mass", o.mass, "KG", "Mass of the whole penetrometer, kg");
  add.choice("--shoulder", shoulder_words, o.shoulder, "Edge between cone and cylinder");
  add.number("--fillet", o.fillet, "M", "Radius of the rounded edge, m, with --shoulder fillet");
  add.number("--device-young", o.device_young, "PA", "Young's modulus of the elastic penetrometer, Pa");
  add.number("--device-poisson", o.device_poisson, "X", "Poisson's ratio of the elastic penetrometer");
  add.group = "Sand (Mohr-Coulomb)";
  add.number("--friction", o.friction, "DEG", "Angle of friction, deg");
  add.number("--dilatancy", o.dilatancy, "DEG", "Angle of dilatancy, deg");
  add.number("--cohesion", o.cohesion, "PA", "Cohesion, Pa");
  add.number("--young", o.young, "PA", "Young's modulus, Pa");
  add.number("--poisson", o.poisson, "X", "Poisson's ratio");
  add.number("--unit-weight", o.unit_weight, "N_M3", "Unit weight, N/m^3");
  add.number("--k0", o.k0, "X", "Earth pressure at rest [poisson / (1 - poisson)]");
  add.group = "Contact";
  add.number("--delta", o.delta, "DEG", "Angle of friction between sand and penetrometer, deg");
  add.flag("--no-slip", o.no_slip, "Sand sticks to the penetrometer, whatever --delta says");
  add.choice("--contact", contact_words, o.contact,
             "Contact of the rigid penetrometer, or through the centre-of-mass velocity (the paper's)");
  add.group = "Numerics";
  add.number("--cell", o.cell, "M", "Edge of the cells around the cone, m");
  add.number("--points-per-element", o.points_per_element, "N",
             "Material points in each element of sand [28 in triangles, 10 in tetrahedra]");
  add.number("--moving-depth", o.moving_depth, "M",
             "The mesh moves as one from this depth below the tip upward, m");
  add.text("--mesh", o.mesh, "FILE.msh", "Gmsh mesh in the place of the generated one");
  add.choice("--anti-locking", switch_words, o.anti_locking,
             "Average volumetric strains over nodes and stresses over filled elements");
  add.number("--flip", o.flip, "SHARE", "Share of FLIP in the velocity update, the rest is PIC");
  add.number("--courant", o.courant, "X", "Time step over the stable one, h / c");
  add.group = "Run";
  add.number("--end", o.end, "S", "End of the run, s");
  add.number("--threads", o.threads, "N", "Threads, 0 for all");
  add.number("--fields-every", o.fields_every, "S", "Time between field files, s, 0 for none");
  add.text("--out", o.out, "DIR", "Folder of the results");
  add.flag("--quiet", o.quiet, "No progress on the terminal");
}

}  // namespace detail

/// Options of `arenite-ffp <words>`, checked; nothing if `--help` was asked for and written to `help`.
/// Throws `error` of one sentence for anything else; the caller prints "arenite-ffp: " and the sentence and
/// exits with 2.
inline std::optional<DropOptions> read_command_line(std::vector<std::string> words, std::ostream& help) {
  DropOptions options;
  CLI::App app{"Drops a free-fall penetrometer into dry sand, by the material point method.", "arenite-ffp"};
  CLI::App& drop =
      *app.add_subcommand("drop", "Run one drop; without options the paper's case (value in brackets)");
  drop.get_formatter()->column_width(46);
  detail::add_drop_options(drop, options);
  app.allow_extras();
  drop.allow_extras();
  drop.footer(
      "Writes DIR/history.csv, DIR/summary.json and DIR/fields_*.vtu with a .pvd.\n"
      "Exit code: 0 done, 1 the run failed physically, 2 an option or a mesh cannot be used.");
  for (const auto& word : words) {  // what CLI11 would take in silence
    for (const std::string flag : {"--no-slip=", "--quiet="})
      require(!word.starts_with(flag), flag.substr(0, flag.size() - 1),
              word.substr(std::min(word.size(), flag.size())), "takes no value");
    if (word.starts_with("--") && word.ends_with("="))
      throw error(word.substr(0, word.size() - 1) + " = : needs a value");
  }
  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    app.parse(reversed);
  } catch (const CLI::CallForHelp&) {
    help << (drop.parsed() ? drop.help("arenite-ffp") : app.help());
    return std::nullopt;
  } catch (const CLI::ArgumentMismatch&) {  // only the last word can be an option without its value
    throw error(words.back() + " = : needs a value");
  } catch (const CLI::ParseError& e) {
    throw error(detail::join("command line: ", e.what()));
  }
  for (const auto& word : app.remaining(true))
    throw error(detail::join(word, word.starts_with("-") ? ": no such option" : ": a word without an option",
                             "; see arenite-ffp drop --help"));
  if (!drop.parsed()) throw error("command: must be drop, as in arenite-ffp drop --help");
  check(options);
  return options;
}

}  // namespace arenite::ffp
