// The options of the reduction of a measured or simulated deceleration: values, limits, help and checks.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "../text/range.hpp"
#include "device_options.hpp"
#include "option_table.hpp"

namespace arenite::ffp {

enum class Medium { air, water };
enum class Soil { sand, clay };
enum class Area { mantle, projected };
enum class TimeUnit { named, s, ms, us };
enum class DecelerationUnit { named, g, m_s2 };
enum class Reading { net, proper };

inline constexpr std::array<std::pair<std::string_view, Medium>, 2> medium_words{
    {{"air", Medium::air}, {"water", Medium::water}}};
inline constexpr std::array<std::pair<std::string_view, Soil>, 2> soil_words{
    {{"sand", Soil::sand}, {"clay", Soil::clay}}};
inline constexpr std::array<std::pair<std::string_view, Area>, 2> area_words{
    {{"mantle", Area::mantle}, {"projected", Area::projected}}};
inline constexpr std::array<std::pair<std::string_view, TimeUnit>, 4> time_unit_words{
    {{"named", TimeUnit::named}, {"s", TimeUnit::s}, {"ms", TimeUnit::ms}, {"us", TimeUnit::us}}};
inline constexpr std::array<std::pair<std::string_view, DecelerationUnit>, 3> deceleration_unit_words{
    {{"named", DecelerationUnit::named}, {"g", DecelerationUnit::g}, {"m_s2", DecelerationUnit::m_s2}}};
inline constexpr std::array<std::pair<std::string_view, Reading>, 2> reading_words{
    {{"net", Reading::net}, {"proper", Reading::proper}}};

/// Everything that decides a reduction beside the record itself. What is not given comes from a drop's
/// folder, or is the default that `visit_reduce_options` gives.
struct ReduceOptions : DeviceOptions {
  std::string file;                      ///< table, .bin, or folder of a drop
  std::string column, time_column;       ///< of a table: names, or numbers from 1; empty: by the header
  std::optional<double> rate;            ///< Hz, rows of a table; its time is then not read
  TimeUnit time_unit = TimeUnit::named;  ///< of a table whose header names none
  DecelerationUnit deceleration_unit = DecelerationUnit::named;
  Reading reads = Reading::net;
  bool invert = false;        ///< the record is positive when the penetrometer gets faster
  bool zero_at_rest = false;  ///< the level at rest is taken off
  std::string calibration;    ///< JSON of a BlueDrop's scales and offsets; empty: samples
  std::string scale, offset;  ///< "2g=1.62e6,18g=1.6e5": win over the file's
  std::optional<double> gravity;
  std::optional<int> drop;                             ///< of several in the record, from 1
  std::optional<double> impact_time, impact_velocity;  ///< s as in the record, m/s
  std::optional<double> threshold;                     ///< g, net
  double window = 2e-3;                                ///< s, of the mean; 0: none
  double from_depth = 0.02;                            ///< m
  Medium medium = Medium::air;
  Soil soil = Soil::sand;
  Area area = Area::mantle;               ///< of the columns of q_sbc
  double water_density = 1025;            ///< kg/m^3
  std::optional<double> volume;           ///< m^3, that the water lifts; default: `lifted_volume`
  std::optional<double> drag;             ///< drag coefficient on the base
  std::optional<double> unit_weight, k0;  ///< of the soil, N/m^3 (in water: submerged)
  std::string out;                        ///< empty: beside the file, or the drop's folder
  bool force = false;                     ///< also reduces what no drop does
  bool no_picture = false, quiet = false;

  /// m^3: the BlueDrop's published one, or that of the outline.
  double lifted_volume(const Device& device) const {
    return volume.value_or(is_bluedrop() ? 0.002473 : device.instrument().volume());
  }
  /// Net deceleration that counts as the impact, g: in air the end of free fall; in water the fall may have
  /// come to its terminal speed, 0 g.
  double impact_threshold() const { return threshold.value_or(medium == Medium::air ? -0.8 : 0.5); }
};

/// Shows the options to a visitor: see `visit_options` in option_table.hpp.
template <class Options, class Visitor>
void visit_reduce_options(Options& o, Visitor& v) {
  v.group("Record");
  v.text("--column", o.column, "NAME",
         "Column of a table that is the deceleration, by its name in the header, or else its number from 1; "
         "X,Y,Z: the magnitude of three, with --reads proper");
  v.text("--time-column", o.time_column, "NAME", "Column of a table that is the time, by name or number");
  v.number("--rate", o.rate, "HZ", Range{10, 1e6, "Hz"},
           "Rows a second of a table whose time is not to be read");
  v.choice("--time-unit", time_unit_words, o.time_unit, "Unit of the time of a table; named: by its header");
  v.choice("--deceleration-unit", deceleration_unit_words, o.deceleration_unit,
           "Unit of the deceleration of a table; named: by its header");
  v.choice("--reads", reading_words, o.reads,
           "net: 0 at rest and -1 g in free fall; proper: 1 g at rest and 0 in free fall");
  v.flag("--invert", o.invert, "The record is positive when the penetrometer gets faster");
  v.flag("--zero-at-rest", o.zero_at_rest,
         "Take off what the accelerometer reads at rest before the release, or without it after the end");
  v.text("--calibration", o.calibration, "FILE.json",
         "Scales and offsets of a BlueDrop's accelerometers, {\"2g\": {\"scale\": S, \"offset\": O}, ..}; "
         "without, "
         "sample values that belong to no probe");
  v.text("--scale", o.scale, "RANGE=S,..", "Counts a g by range of a BlueDrop, 2g, 18g, 50g, 200g, 250g");
  v.text("--offset", o.offset, "RANGE=O,..", "Counts that are added before the division, by range");
  v.number("--drop", o.drop, "N", Range{1, 1000}, "Which drop, of a record with several");
  v.number("--impact-time", o.impact_time, "S", Range{-1e9, 1e9, "s"},
           "Time of the impact in the record; without, where the deceleration leaves the fall");
  v.number("--impact-velocity", o.impact_velocity, "M_S", above(0, 100, "m/s"),
           "Velocity at the impact; without, integrated from the release, or back from rest");
  v.number("--threshold", o.threshold, "G", Range{-1, 10, "g"},
           "Net deceleration that ends the fall, of itself -0.8 in air and 0.5 in water");
  v.number("--window", o.window, "S", Range{0, 0.1, "s"},
           "Window of the moving mean of the deceleration, 0 for none");
  v.group("Penetrometer");
  visit_device_options(o, v);
  v.group("Surroundings");
  v.number("--gravity", o.gravity, "M_S2", Range{0.1, 100, "m/s^2"},
           "Gravity, which is also the g of the record, of itself 9.81 or the drop's");
  v.choice("--medium", medium_words, o.medium, "What it falls through; in air buoyancy and drag are 0");
  v.number("--water-density", o.water_density, "KG_M3", Range{900, 1300, "kg/m^3"}, "Density of the water");
  v.number("--volume", o.volume, "M3", Range{0, 1, "m^3"},
           "Volume that the water lifts, of itself 0.002473 for the BlueDrop, else that of the outline");
  v.number("--drag", o.drag, "X", Range{0, 10},
           "Drag coefficient on the base in water; without, drag is left out");
  v.group("Soil");
  v.choice("--soil", soil_words, o.soil, "Which bands of K are said to be within their range");
  v.choice("--area", area_words, o.area, "Area of the columns of q_sbc: mantle (sands) or projected (clays)");
  v.number("--from-depth", o.from_depth, "M", Range{0, 1, "m"},
           "Bearing resistance from this depth on; above it the area is tiny");
  v.number("--unit-weight", o.unit_weight, "N_M3", Range{1000, 100000, "N/m^3"},
           "Unit weight of the soil (in water: submerged), for density and strength; without, they are left "
           "out, or "
           "the drop's");
  v.number("--k0", o.k0, "X", Range{0, 3}, "Earth pressure at rest, of itself 0.5 or the drop's");
  v.group("Run");
  v.text("--out", o.out, "DIR", "Folder of the results; without, that of FILE");
  v.flag("--force", o.force, "Reduce a motion that no drop can have, too");
  v.flag("--no-picture", o.no_picture, "Draw nothing");
  v.flag("--quiet", o.quiet, "Nothing on the terminal but errors and warnings");
}

/// Throws `error("--option = value: rule")` at the first value that breaks a rule.
void check(const ReduceOptions& o);

}  // namespace arenite::ffp
