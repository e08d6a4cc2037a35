// Every option of a drop: name, limits and help, in the order of `--help`. The command line, its help and
// the checks all read this table.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <arenite/core/error.hpp>
#include <arenite/io/mesh_input.hpp>

#include "../text/range.hpp"
#include "../text/words.hpp"
#include "options.hpp"

namespace arenite::ffp {

/// Material points that an element of sand can have.
inline constexpr std::array triangle_points{1, 3, 4, 6, 9, 10, 15, 16, 21, 25, 28, 36, 49};
inline constexpr std::array tetrahedron_points{1, 4, 10, 20, 35, 56, 84};
inline constexpr std::array grid_points{4, 9, 16, 25, 36, 49};
inline constexpr std::array space_points{8, 27, 64};

/// "1, 2 or 3".
template <std::size_t N>
std::string listed(const std::array<int, N>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < N; ++i)
    text += (i == 0 ? "" : i + 1 < N ? ", " : " or ") + std::to_string(numbers[i]);
  return text;
}

/// Largest cell of a drop with an error bar, m: half of the largest that --cell takes.
inline double largest_cell_with_bar(const DropOptions& o) { return 0.02 * o.size(); }

/// Sets of field files that a run may write.
inline constexpr double most_fields = 1000;

/// Shows the options one after the other to `v`, which provides group(title), choice(name, words, value,
/// help), number(name, value, metavar, range, help), counts(name, value, help), text(name, value, metavar,
/// help) and flag(name, value, help). `Options` is `DropOptions` or const.
template <class Options, class Visitor>
void visit_options(Options& o, Visitor& v) {
  v.group("Model");
  v.choice(
      "--kinematics", kinematics_words, o.kinematics,
      "Half-section of triangles, the 20-degree slice of tetrahedra, or in space, where the penetrometer "
      "turns, on a grid");
  v.choice("--device", device_words, o.device, "Penetrometer that moves as one, or one that deforms");
  v.number("--velocity", o.velocity, "M_S", above(0, 50, "m/s"), "Velocity at the impact");
  v.number("--tilt", o.tilt, "DEG", Range{0, 30, "deg"},
           "Angle of the penetrometer's axis to the vertical at the impact, with --kinematics space");
  v.number("--centre-of-mass", o.centre_of_mass, "M", Range{0.05 * o.size(), o.whole_length(), "m"},
           "Height of the centre of mass above the tip, with --kinematics space, of itself that of a "
           "homogeneous penetrometer");
  v.number("--gyration", o.gyration, "M", Range{0.02 * o.size(), o.whole_length(), "m"},
           "Radius of gyration about a line across the axis, with --kinematics space, of itself that of a "
           "homogeneous penetrometer");
  v.number("--chamber-radius", o.chamber_radius, "M", above(0, 100, "m"),
           "Radius of the chamber, at least five of the penetrometer's, of itself 4.57 diameters (0.4)");
  v.number("--soil-depth", o.soil_depth, "M", above(0, 100, "m"),
           "Depth of the sand, of itself 4.57 diameters (0.4)");
  v.group("Penetrometer");
  visit_device_options(o, v);
  v.number("--device-young", o.device_young, "PA", Range{1e5, 1e12, "Pa"},
           "Young's modulus of the elastic penetrometer");
  v.number("--device-poisson", o.device_poisson, "X", between(-1, 0.5),
           "Poisson's ratio of the elastic penetrometer");
  v.group("Sand (Mohr-Coulomb)");
  v.number("--friction", o.friction, "DEG", Range{1, 60, "deg"}, "Angle of friction");
  v.number("--dilatancy", o.dilatancy, "DEG", Range{0, 60, "deg"},
           "Angle of dilatancy, at most that of friction");
  v.number("--cohesion", o.cohesion, "PA", Range{0, 1e6, "Pa"}, "Cohesion");
  v.number("--young", o.young, "PA", Range{1e4, 1e10, "Pa"}, "Young's modulus");
  v.number("--poisson", o.poisson, "X", between(-1, 0.5), "Poisson's ratio");
  v.number("--unit-weight", o.unit_weight, "N_M3", Range{1000, 100000, "N/m^3"}, "Unit weight");
  v.number("--k0", o.k0, "X", Range{0, 3}, "Earth pressure at rest, of itself poisson / (1 - poisson)");
  visit_law_options(o.law, v);
  v.group("Contact");
  v.number("--delta", o.delta, "DEG", Range{0, 60, "deg"}, "Angle of friction between sand and penetrometer");
  v.flag("--no-slip", o.no_slip, "Sand sticks to the penetrometer, whatever --delta says");
  v.choice(
      "--contact", contact_words, o.contact,
      "Contact of the rigid penetrometer at nodes, through the centre-of-mass velocity (the paper's), or "
      "at material points (of itself rigid; with --mesh-kind grid points, but in space rigid)");
  v.number("--contact-offset", o.contact_offset, "M", Range{-0.02 * o.size(), 0.02 * o.size(), "m"},
           "The sand meets a surface this far outside of the penetrometer's, or inside if negative");
  v.group("Numerics");
  v.choice("--mesh-kind", mesh_kind_words, o.mesh_kind,
           "Elements fitted to the penetrometer, or a grid of quadratic B-splines that moves with it (of "
           "itself fitted; with --kinematics space grid)");
  v.choice(
      "--accuracy", accuracy_words, o.accuracy,
      "What --cell and --courant are of themselves: coarse 0.02 and 0.9, normal 0.01 and 0.5, fine 0.005 "
      "and 0.5");
  v.number("--cell", o.cell, "M", Range{0.0025 * o.size(), 0.04 * o.size(), "m"},
           "Edge of the cells around the cone, of itself that of --accuracy");
  v.number(
      "--cell-at-cone", o.cell_at_cone, "M", Range{0.0005 * o.size(), 0.04 * o.size(), "m"},
      "Edge of the cells at cone, tip and shoulder, which grow to --cell away from them, of itself --cell");
  v.number("--split", o.split, "N", Range{0, 100},
           "Split points of sand that stand for more than 1 / N of their cell, 0 for none, of itself 9 with "
           "--cell-at-cone (4 with --mesh-kind grid)");
  v.counts("--points-per-element", o.points_per_element,
           "Material points in each element of sand: " + listed(triangle_points) +
               " in triangles (default 28), " + listed(tetrahedron_points) + " in tetrahedra (default 10), " +
               listed(grid_points) + " in cells of a grid (default 9), " + listed(space_points) +
               " in space (default 8)");
  v.number("--jitter", o.jitter, "SHARE", Range{0, 1},
           "Move initial points of sand at random, within this share of the spacing between them");
  v.number("--jitter-seed", o.jitter_seed, "N", Range{0, 1e9}, "Seed of the random numbers of --jitter");
  v.number("--moving-depth", o.moving_depth, "M", Range{0.02 * o.size(), 0.15 * o.size(), "m"},
           "The mesh moves as one from this depth below the tip upward, of itself 0.06");
  v.text("--mesh", o.mesh, "FILE.msh", "Gmsh mesh in the place of the generated one");
  v.choice(
      "--anti-locking", switch_words, o.anti_locking,
      "Average volumetric strains over nodes and stresses over filled elements (of itself on; a grid has "
      "none)");
  v.number("--flip", o.flip, "SHARE", Range{0, 1}, "Share of FLIP in the velocity update, the rest is PIC");
  v.number(
      "--flip-time", o.flip_time, "S", Range{0, 100, "s"},
      "Time constant of the share of FLIP, which is then --flip exp(-dt / S) whatever the step; 0 for none, "
      "of itself 0; 0.1 with --mesh-kind grid");
  v.number("--courant", o.courant, "X", above(0, 1),
           "Time step over the stable one, h / c, of itself that of --accuracy");
  v.group("Run");
  v.number("--end", o.end, "S", above(0, 10, "s"), "End of the run");
  v.number("--threads", o.threads, "N", Range{0, 1024}, "Threads, 0 for all");
  v.number("--fields-every", o.fields_every, "S", Range{0, 10, "s"},
           joined_text({"Time between field files, 0 for none, at most ", most_fields, " sets in a run"}));
  v.number("--checkpoint-every", o.checkpoint_every, "S", Range{0, 10, "s"},
           "Time between saved states, 0 for none but when the run is interrupted");
  v.flag(
      "--resume", o.resume,
      "Go on from the state saved last in DIR, by a run of the same inputs; a finished one is left as it is");
  v.text("--out", o.out, "DIR", "Folder of the results; those of an earlier run in it are removed");
  v.number(
      "--watch-energy", o.watch_energy, "SHARE", above(0, 1e6),
      "Stop when energy that nothing put in exceeds this share of what was put in; warn past a tenth of it");
  v.number("--watch-volume", o.watch_volume, "X", above(0, 1e6),
           "Stop when the mean V/V0 of a body leaves 1 by more; warn past a tenth");
  v.number("--watch-lost", o.watch_lost, "SHARE", above(0, 1),
           "Stop when more of a body's points have left the mesh; warn past a tenth");
  v.flag("--no-watch", o.no_watch,
         "Do not stop or warn, whatever becomes of energy, volume, stress and points");
  v.flag("--error-bar", o.error_bar,
         "Run also coarser drops, and such with other numerics, and tell the uncertainty of depth and peak");
  v.flag("--force", o.force, "Run even if it takes more than 1e8 steps");
  v.flag("--quiet", o.quiet, "Nothing on the terminal but errors and warnings");
}

namespace detail {

/// Tests each number against its range.
struct RangeCheck {
  void group(const char*) {}
  template <class Number>
  void number(const char* name, const Number& value, const char*, const Range& range, std::string_view) {
    require(range.contains(value), name, exactly(value), "must lie in " + range.text());
  }
  template <class Number>
  void number(const char* name, const std::optional<Number>& value, const char* metavar, const Range& range,
              std::string_view help) {
    if (value) number(name, *value, metavar, range, help);
  }
  template <class Words, class Value>
  void choice(const char*, const Words&, const Value&, const char*) {}
  void counts(const char*, const std::optional<int>&, std::string_view) {}
  void text(const char*, const std::string&, const char*, const char*) {}
  void flag(const char*, bool, const char*) {}
};

}  // namespace detail

/// The rules of a penetrometer that turns.
void check_in_space(const DropOptions& o);

/// Throws `error("--option = value: rule")` at the first value that breaks a rule.
void check(const DropOptions& o);

}  // namespace arenite::ffp
