// The options of a push, and their defaults (a standard cone in clay). Names, limits and help: `visit_push_options`.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "../geometry/geometry.hpp"
#include "../geometry/mesh_axisymmetric.hpp"
#include "../text/words.hpp"
#include "device_options.hpp"
#include "option_table.hpp"

namespace arenite::ffp {

enum class Ground { clay, sand };

inline constexpr std::array<std::pair<std::string_view, Ground>, 2> ground_words{
    {{"clay", Ground::clay}, {"sand", Ground::sand}}};

/// Everything that decides a push. SI units; angles in degrees, as typed. Lengths are in proportion to the diameter D, and the
/// speed to that of shear waves, so that a scaled penetrometer in the same ground has the same resistance.
struct PushOptions : DeviceOptions {
  PushOptions() { penetrometer = of_itself = Penetrometer::cone_10cm2; }

  Ground ground = Ground::clay;
  double strength = 20e3;                 ///< undrained, of clay, Pa
  double rigidity_index = 100;            ///< shear modulus over strength of clay
  double roughness = 0;                   ///< of the penetrometer in clay: adhesion over strength
  double friction = 35;                   ///< of sand, deg
  double dilatancy = 5;                   ///< of sand, deg
  double cohesion = 100;                  ///< of sand, Pa
  double young = 20e6;                    ///< of sand, Pa
  double delta = 20;                      ///< friction angle between sand and penetrometer, deg
  std::optional<double> poisson;          ///< default: `poisson_ratio`
  std::optional<double> unit_weight, k0;  ///< default: `weight`, `earth_pressure`
  double overburden = 0;                  ///< pressure on the surface, Pa

  std::optional<double> speed;                       ///< m/s; default: `push_speed`
  std::optional<double> from;                        ///< depth of the tip at the start, m; default 4 D
  std::optional<double> distance;                    ///< way of the tip, m; default 3 D
  std::optional<double> chamber_radius, soil_depth;  ///< m; default 15 D, and 9 D below the end
  std::optional<double> cell;                        ///< edge of the cells around the tip, m; default 0.15 D
  int points_per_element = 10;
  std::optional<double> flip_time;  ///< s; default: `flip_time_constant`
  double courant = 0.5;             ///< time step over the stable estimate h / c
  int threads = 0;
  double fields_every = 0;  ///< way between field files, m; 0: none
  std::string out = "out/push";
  bool quiet = false, no_watch = false, no_picture = false, error_bar = false, is_companion = false;

  bool in_clay() const { return ground == Ground::clay; }
  /// Undrained clay keeps its volume. 0.45 and not more: strains averaged over nodes bring energy into nearly incompressible matter
  /// (in one mesh 5.6 % of what is put in within one diameter with 0.49, -0.8 % with 0.45). It lowers the limit of a cavity by 2 %.
  double poisson_ratio() const { return poisson.value_or(in_clay() ? 0.45 : 0.3); }
  double young_modulus() const { return in_clay() ? 2 * (1 + poisson_ratio()) * shear_modulus() : young; }
  double shear_modulus() const {
    return in_clay() ? rigidity_index * strength : young / (2 * (1 + poisson_ratio()));
  }
  double weight() const { return unit_weight.value_or(in_clay() ? 17e3 : 16e3); }  ///< N/m^3
  double density() const;                                                          ///< kg/m^3
  double earth_pressure() const { return k0.value_or(in_clay() ? 1 : 1 - std::sin(friction * pi / 180)); }
  /// m/s
  double shear_wave_speed() const { return std::sqrt(shear_modulus() / density()); }
  /// m/s. Clay and sand here feel no rate, so that 2 cm/s would be the same answer at twenty times the cost; what is left of inertia
  /// is `inertia_share` in the summary.
  double push_speed() const { return speed.value_or(0.0075 * shear_wave_speed()); }
  /// s. It takes the noise of FLIP, and acts as a viscosity of about density x cell^2 / time: in the first pushes 0.05 of the
  /// strength at this time.
  double flip_time_constant() const { return flip_time.value_or(outer_diameter() / shear_wave_speed()); }
  double start_depth() const { return from.value_or(4 * outer_diameter()); }
  double way() const { return distance.value_or(3 * outer_diameter()); }
  double cell_size() const { return cell.value_or(0.15 * outer_diameter()); }
  /// The speed grows to `push_speed` over this way, m.
  double ramp() const { return 0.2 * outer_diameter(); }
  /// Mean pressure of the ground on a horizontal plane at a depth, Pa.
  double vertical_stress(double depth) const { return overburden + weight() * depth; }
  Device body() const;
  Chamber chamber() const;
  MeshSizes mesh_sizes() const;
};

/// Shows the options to a visitor: see `visit_options` in option_table.hpp.
template <class Options, class Visitor>
void visit_push_options(Options& o, Visitor& v) {
  v.group("Push");
  v.number("--start-depth", o.from, "M", above(0, 100, "m"),
           "Depth of the tip at the start, in undisturbed ground, of itself 4 diameters");
  v.number("--distance", o.distance, "M", above(0, 100, "m"), "Way of the tip, of itself 3 diameters");
  v.number("--speed", o.speed, "M_S", Range{1e-4, 20, "m/s"},
           "Speed; of itself 0.0075 of that of shear waves, for the ground feels no rate (what inertia bears "
           "is told)");
  v.group("Penetrometer");
  visit_device_shape(o, v);
  v.group("Ground");
  v.choice("--ground", ground_words, o.ground, "Clay in total stress (Tresca), or dry sand (Mohr-Coulomb)");
  v.number("--strength", o.strength, "PA", Range{100, 1e7, "Pa"}, "Undrained shear strength of clay");
  v.number("--rigidity-index", o.rigidity_index, "X", Range{10, 2000},
           "Shear modulus of clay over its strength");
  v.number("--roughness", o.roughness, "X", Range{0, 1},
           "Of the penetrometer in clay, tip and mantle: adhesion over strength");
  v.number("--friction", o.friction, "DEG", Range{1, 60, "deg"}, "Angle of friction of sand");
  v.number("--dilatancy", o.dilatancy, "DEG", Range{0, 60, "deg"},
           "Angle of dilatancy of sand, at most that of friction");
  v.number("--cohesion", o.cohesion, "PA", Range{0, 1e6, "Pa"}, "Cohesion of sand");
  v.number("--young", o.young, "PA", Range{1e4, 1e10, "Pa"}, "Young's modulus of sand");
  v.number("--delta", o.delta, "DEG", Range{0, 60, "deg"}, "Angle of friction between sand and penetrometer");
  v.number("--poisson", o.poisson, "X", Range{0, 0.49},
           "Poisson's ratio, of itself 0.45 of clay and 0.3 of sand");
  v.number("--unit-weight", o.unit_weight, "N_M3", Range{1000, 100000, "N/m^3"},
           "Unit weight, of itself 17000 of clay and 16000 of sand");
  v.number("--k0", o.k0, "X", Range{0, 3},
           "Earth pressure at rest, of itself 1 in clay and 1 - sin(friction) in sand");
  v.number("--overburden", o.overburden, "PA", Range{0, 1e7, "Pa"},
           "Pressure on the surface, as of ground above");
  v.number("--chamber-radius", o.chamber_radius, "M", above(0, 100, "m"),
           "Radius of the ground, of itself 15 diameters");
  v.number("--soil-depth", o.soil_depth, "M", above(0, 200, "m"),
           "Depth of the ground below the tip at the start, of itself --distance and 9 diameters");
  v.group("Numerics");
  v.number("--cell", o.cell, "M", above(0, 10, "m"),
           "Edge of the cells around the tip, of itself 0.15 diameters");
  v.number("--points-per-element", o.points_per_element, "N", Range{3, 49},
           "Material points in each triangle: " + listed(triangle_points));
  v.number("--flip-time", o.flip_time, "S", above(0, 100, "s"),
           "Time constant of the share of FLIP, of itself that of a shear wave over a diameter");
  v.number("--courant", o.courant, "X", above(0, 1), "Time step over the stable one, h / c");
  v.group("Run");
  v.number("--threads", o.threads, "N", Range{0, 1024}, "Threads, 0 for all");
  v.number("--fields-every", o.fields_every, "M", Range{0, 100, "m"}, "Way between field files, 0 for none");
  v.text("--out", o.out, "DIR", "Folder of the results; those of an earlier run in it are removed");
  v.flag("--error-bar", o.error_bar,
         "Run also two pushes in coarser cells and one at twice the speed, and tell the uncertainty of the "
         "resistance");
  v.flag("--no-watch", o.no_watch,
         "Do not stop or warn, whatever becomes of energy, volume, stress and points");
  v.flag("--no-picture", o.no_picture, "Draw nothing");
  v.flag("--quiet", o.quiet, "Nothing on the terminal but errors and warnings");
}

/// Throws `error("--option = value: rule")` at the first value that breaks a rule.
void check(const PushOptions& o);

}  // namespace arenite::ffp
