// The penetrometer as an option of drops and reductions: one that is known by name, and what differs from it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <arenite/core/error.hpp>

#include "../geometry/penetrometer.hpp"
#include "../text/range.hpp"
#include "device_profile.hpp"

namespace arenite::ffp {

enum class Shoulder { sharp, fillet };

inline constexpr std::array<std::pair<std::string_view, Shoulder>, 2> shoulder_words{
    {{"sharp", Shoulder::sharp}, {"fillet", Shoulder::fillet}}};

template <class Words, class Value>
std::string word_of(const Words& words, Value value) {
  for (const auto& [word, meaning] : words)
    if (meaning == value) return std::string{word};
  throw error("word_of: a value without a word");
}

/// SI units; angles in degrees, as typed. What is not given is the named penetrometer's.
struct DeviceOptions {
  Penetrometer of_itself = Penetrometer::bluedrop;  ///< the named one of a command, without --penetrometer
  Penetrometer penetrometer = of_itself;
  std::string device_file;               ///< in the place of a named one, or its content; empty: none
  std::optional<DeviceProfile> profile;  ///< its content: see `read_device`
  Tip tip = Tip::cone;
  std::optional<double> diameter;    ///< of the cylinder, m
  std::optional<double> length;      ///< tip to top, m
  std::optional<double> cone_angle;  ///< whole angle, deg; 60 of itself
  std::optional<double> flat;  ///< diameter of the flat end that cuts the cone, m; with `Tip::cone_truncated`
  std::optional<double> mass;  ///< of the whole penetrometer, kg; of itself the BlueDrop's with its tip
  Shoulder shoulder = Shoulder::sharp;  ///< edge between cone and cylinder (ours)
  std::optional<double> fillet;         ///< radius of the rounded edge, m; with `Shoulder::fillet` (ours)

  /// Diameter over the BlueDrop's: lengths that are in proportion to the penetrometer are the paper's times this.
  double size() const { return outer_diameter() / size_of(Penetrometer::bluedrop).diameter; }
  double outer_diameter() const {
    return profile ? 2 * profile->line.widest() : diameter.value_or(size_of(penetrometer).diameter);
  }
  double whole_length() const {
    if (!profile && penetrometer == Penetrometer::sphere) return outer_diameter();
    return profile ? profile->line.length() : length.value_or(size_of(penetrometer).length);
  }
  /// The outline, where it is no tip on a cylinder.
  std::optional<ProfileLine> outline() const {
    return profile ? profile->line : outline_of(penetrometer, outer_diameter(), whole_length());
  }
  double fillet_radius() const { return shoulder == Shoulder::fillet ? fillet.value_or(0.01 * size()) : 0; }
  /// The penetrometer itself, without an offset of its surface.
  DeviceShape shape() const;
  /// Whether shape and size are those that the BlueDrop's published masses belong to.
  bool is_bluedrop() const { return !profile && penetrometer == Penetrometer::bluedrop && !is_changed(); }
  bool is_changed() const { return diameter || length || cone_angle || flat; }
  /// Name for people: "bluedrop, cone", "cone-10cm2, changed", or that of the file.
  std::string device_name() const;
  /// kg. Throws `error` if it is not given and not known.
  double device_mass() const;
  /// kg/m^3, of the mass over the volume of the outline.
  double mean_density() const { return device_mass() / Device{shape()}.volume(); }
};

/// Reads the file of the penetrometer, if one is given. Throws `error` that names it.
void read_device(DeviceOptions& o);

/// Throws `error("--option = value: rule")` at the first value of the shape that breaks a rule.
void check(const DeviceOptions& o);

/// Throws `error` if the mass is not known, or gives a mean density that no penetrometer has.
void check_mass(const DeviceOptions& o);

/// Shows the options of the shape to a visitor: see `visit_options` in option_table.hpp.
template <class Options, class Visitor>
void visit_device_shape(Options& o, Visitor& v) {
  v.choice("--penetrometer", penetrometer_words, o.penetrometer,
           "The paper's free-fall penetrometer, a standard cone of 10 or 15 cm2 (35.7, 43.7 mm), a ball of "
           "100 cm2 "
           "on a rod, or a sphere of 25 cm; the options below change it");
  v.text("--device-file", o.device_file, "FILE.json",
         "Any other, by a file or the JSON itself: {\"name\": .., \"profile\": [[0, 0], [radius, height] "
         "..], \"mass_kg\": ..}, in m from "
         "the tip "
         "upward; an arc is {\"to\": [radius, height], \"arc\": its radius}");
  v.choice("--tip", tip_words, o.tip,
           "Cone, sharp or with the instrument's flat end, parabola, or a flat end alone");
  v.number("--diameter", o.diameter, "M", Range{0.01, 2, "m"},
           "Diameter of the cylinder; chamber, cells and zones of the mesh, and their limits, are in "
           "proportion to it");
  v.number("--length", o.length, "M", Range{0.02, 20, "m"}, "Length from the tip to the top");
  v.number("--cone-angle", o.cone_angle, "DEG", Range{20, 120, "deg"},
           "Whole angle of the cone, of itself 60");
  v.number("--flat", o.flat, "M", above(0, 2, "m"),
           "Diameter of the flat end that cuts the cone, with --tip cone-truncated, of itself 0.0044 in the "
           "BlueDrop's 0.0875");
  v.choice("--shoulder", shoulder_words, o.shoulder, "Edge between cone and cylinder");
  v.number("--fillet", o.fillet, "M", Range{0.0005 * o.size(), 0.03 * o.size(), "m"},
           "Radius of the rounded edge, with --shoulder fillet, of itself 0.01");
}
/// All of them.
template <class Options, class Visitor>
void visit_device_options(Options& o, Visitor& v) {
  visit_device_shape(o, v);
  v.number("--mass", o.mass, "KG", Range{0.001, 1e5, "kg"},
           "Mass of the whole penetrometer, of itself 7.71 with a cone, 9.15 parabolic, 10.30 blunt; to be "
           "given for another size or angle");
}

}  // namespace arenite::ffp
