// The options of a drop, and their defaults (the paper's case). Names, limits and help: option_table.hpp;
// parsing: command_line.hpp.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <arenite/core/error.hpp>

#include "../geometry/geometry.hpp"
#include "../geometry/mass.hpp"
#include "../geometry/mesh_axisymmetric.hpp"
#include "../geometry/tilted.hpp"
#include "device_options.hpp"
#include "law_options.hpp"

namespace arenite::ffp {

enum class Kinematics { axisymmetric, slice, space };
enum class DeviceKind { rigid, elastic };
enum class MeshKind { fitted, grid };
enum class ContactKind { rigid, centre_of_mass, points };
enum class Accuracy { coarse, normal, fine };

/// Words of the options that choose: the command line, the summary and the checks share them.
inline constexpr std::array<std::pair<std::string_view, Kinematics>, 3> kinematics_words{
    {{"axisymmetric", Kinematics::axisymmetric}, {"slice", Kinematics::slice}, {"space", Kinematics::space}}};
inline constexpr std::array<std::pair<std::string_view, DeviceKind>, 2> device_words{
    {{"rigid", DeviceKind::rigid}, {"elastic", DeviceKind::elastic}}};
inline constexpr std::array<std::pair<std::string_view, MeshKind>, 2> mesh_kind_words{
    {{"fitted", MeshKind::fitted}, {"grid", MeshKind::grid}}};
inline constexpr std::array<std::pair<std::string_view, ContactKind>, 3> contact_words{
    {{"rigid", ContactKind::rigid},
     {"centre-of-mass", ContactKind::centre_of_mass},
     {"points", ContactKind::points}}};
inline constexpr std::array<std::pair<std::string_view, Accuracy>, 3> accuracy_words{
    {{"coarse", Accuracy::coarse}, {"normal", Accuracy::normal}, {"fine", Accuracy::fine}}};
inline constexpr std::array<std::pair<std::string_view, bool>, 2> switch_words{
    {{"on", true}, {"off", false}}};

/// Everything that decides a drop. SI units; angles in degrees, as typed. "ours": the paper gives no value.
struct DropOptions : DeviceOptions {
  Kinematics kinematics = Kinematics::axisymmetric;
  DeviceKind device = DeviceKind::rigid;
  double delta = 20;                     ///< friction angle between sand and device, deg
  bool no_slip = false;                  ///< sand sticks to the device; `delta` is not used
  double velocity = 5.6;                 ///< at the impact, downward, m/s
  double tilt = 0;                       ///< of the axis from the vertical at the impact, deg; in space
  std::optional<double> centre_of_mass;  ///< above the tip, m; default: `centre_height`; in space
  std::optional<double> gyration;  ///< radius about a line across the axis, m; default: `gyration_radius`
  double device_young = 20e6;      ///< of the elastic device, Pa
  double device_poisson = 0.33;    ///< of the elastic device (ours: the sand's)
  /// From the surface of the device outward to the contact surface, m: for error bars.
  double contact_offset = 0;
  double friction = 40;                  ///< of the sand, deg
  double young = 5e6;                    ///< of the sand, Pa
  double poisson = 0.33;                 ///< of the sand
  double unit_weight = 15100;            ///< of the sand, N/m^3
  double cohesion = 0;                   ///< of the sand, Pa
  double dilatancy = 0;                  ///< of the sand, deg
  LawOptions law;                        ///< of the sand's friction
  std::optional<double> k0;              ///< earth pressure at rest; default poisson / (1 - poisson) (ours)
  std::optional<MeshKind> mesh_kind;     ///< elements fitted to the device, or a grid under it
  Accuracy accuracy = Accuracy::normal;  ///< decides cells and time step that are not given
  std::optional<double> cell;            ///< edge of the cells around the cone, m; default: `cell_size`
  std::optional<double> cell_at_cone;    ///< edge of the cells at the cone itself, m; without: `cell_size`
  std::optional<double> split;  ///< points that represent more than 1 / split of their cell split; 0: none
  std::optional<double>
      moving_depth;  ///< the mesh moves as one from here below the tip upward, m; default: `moving_zone` (ours)
  std::optional<double> chamber_radius, soil_depth;  ///< m; default: the experiment's, in diameters
  std::string mesh;                       ///< Gmsh file in the place of the generated mesh; empty: none
  std::optional<int> points_per_element;  ///< in the sand; default: see `points_in_element`
  double jitter = 0;    ///< share of their sub-cells within which initial points are moved at random
  int jitter_seed = 0;  ///< of the random numbers
  /// Of a rigid device; an elastic one touches the sand by the centre of mass. Default: `contact_kind`.
  std::optional<ContactKind> contact;
  /// Strains averaged over nodes, stresses over filled elements; default: `averages`.
  std::optional<bool> anti_locking;
  double flip = 1;  ///< share of FLIP in the velocity update, the rest is PIC
  /// s: time constant of the share, flip exp(-dt / time); 0: none; default: `flip_time_constant`.
  std::optional<double> flip_time;
  std::optional<double> courant;  ///< time step over the stable estimate h / c; default: `courant_number`
  double end = 0.1;               ///< s
  int threads = 0;                ///< 0: the environment's ARENITE_THREADS, else one for each processor
  double fields_every = 0.02;     ///< s; 0: no fields
  double checkpoint_every = 0;    ///< s; 0: a state is saved only when the run is interrupted
  bool resume = false;            ///< resumes from the state saved last in `out`
  std::string out = "out/ffp";    ///< folder of the results
  bool quiet = false;             ///< nothing on the terminal but errors and warnings
  double watch_energy = 0.1;      ///< a run stops past it: energy that nothing put in, over all put in
  double watch_volume = 0.5;      ///< the same: |V/V0 - 1| of the sand or of an elastic device, mean
  double watch_lost = 0.1;        ///< the same: share of the points that left the mesh
  bool no_watch = false;          ///< nothing stops a run that cannot be right
  bool error_bar = false;         ///< also runs the drops around it, which show how far it can be trusted
  bool is_companion = false;      ///< of an error bar: its warnings are only in its summary
  bool force = false;             ///< runs however many steps it takes

  /// The paper's 10 in tetrahedra; 28 in triangles, from where on more change depth by 0.4 % and peak by 1 %:
  /// 9, 15, 21, 28, 36, 49 give 0.192, 0.189, 0.187, 0.186, 0.187, 0.187 m and 18.2 to 18.5 g; nine in cells
  /// of a grid, eight in space.
  int points_in_element() const {
    return points_per_element.value_or(in_space()                        ? 8
                                       : on_grid()                       ? 9
                                       : kinematics == Kinematics::slice ? 10
                                                                         : 28);
  }
  /// m; depth, peak, bars and times of each accuracy: docs/ffp_accuracy.md, Speed against accuracy.
  double cell_size() const {
    return cell.value_or(size() * (accuracy == Accuracy::coarse ? 0.02
                                   : accuracy == Accuracy::fine ? 0.005
                                                                : 0.01));
  }
  double courant_number() const { return courant.value_or(accuracy == Accuracy::coarse ? 0.9 : 0.5); }
  /// Whether the penetrometer moves and turns in space; otherwise along its axis.
  bool in_space() const { return kinematics == Kinematics::space; }
  MeshKind kind_of_mesh() const { return mesh_kind.value_or(in_space() ? MeshKind::grid : MeshKind::fitted); }
  bool on_grid() const { return kind_of_mesh() == MeshKind::grid; }
  ContactKind contact_kind() const {
    if (device == DeviceKind::elastic) return ContactKind::centre_of_mass;
    return contact.value_or(on_grid() && !in_space() ? ContactKind::points : ContactKind::rigid);
  }
  bool averages() const { return anti_locking.value_or(!on_grid()); }
  double flip_time_constant() const { return flip_time.value_or(on_grid() ? 0.1 : 0); }
  double earth_pressure() const { return k0.value_or(poisson / (1 - poisson)); }
  /// m; of themselves those of the penetrometer's file, or of a homogeneous one.
  double centre_height() const {
    if (centre_of_mass) return *centre_of_mass;
    return profile && profile->centre_of_mass ? *profile->centre_of_mass : mass_in(Device{shape()}).centre;
  }
  double gyration_radius() const {
    if (gyration) return *gyration;
    return profile && profile->gyration ? *profile->gyration : mass_in(Device{shape()}).gyration;
  }
  /// The contact surface, and with `instrument()` the penetrometer.
  Device body() const {
    DeviceShape with_offset = shape();
    with_offset.offset = contact_offset;
    return Device{with_offset};
  }
  DeviceStart start() const { return {body(), tilt * pi / 180}; }
  MeshSizes mesh_sizes() const {
    MeshSizes sizes;
    sizes.cell = cell_size();
    sizes.at_cone = cell_at_cone.value_or(0);
    sizes.refined *= size();
    sizes.fine_radius *= size();
    sizes.moving_depth = moving_zone();
    return sizes;
  }
  double moving_zone() const { return moving_depth.value_or(0.06 * size()); }
  Chamber chamber() const {
    Chamber c = chamber_for(outer_diameter(), whole_length());
    c.radius = chamber_radius.value_or(c.radius);
    c.soil_depth = soil_depth.value_or(c.soil_depth);
    return c;
  }
  /// Sand that comes from coarser cells would thin out in refined ones.
  double split_share() const { return split.value_or(!cell_at_cone ? 0 : on_grid() ? 4 : 9); }
};

}  // namespace arenite::ffp
