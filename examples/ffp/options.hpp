// What a drop can be told, its defaults (the paper's case) and its limits. No parsing here: command_line.hpp
// does that.
#pragma once

#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <arenite/core/error.hpp>

#include "geometry.hpp"
#include "mesh_axisymmetric.hpp"

namespace arenite::ffp {

enum class Kinematics { axisymmetric, slice };
enum class DeviceKind { rigid, elastic };
enum class ContactKind { rigid, centre_of_mass };
enum class Shoulder { sharp, fillet };

/// Words of the options that choose: the command line, the summary and the checks share them.
inline constexpr std::array<std::pair<std::string_view, Kinematics>, 2> kinematics_words{
    {{"axisymmetric", Kinematics::axisymmetric}, {"slice", Kinematics::slice}}};
inline constexpr std::array<std::pair<std::string_view, DeviceKind>, 2> device_words{
    {{"rigid", DeviceKind::rigid}, {"elastic", DeviceKind::elastic}}};
inline constexpr std::array<std::pair<std::string_view, ContactKind>, 2> contact_words{
    {{"rigid", ContactKind::rigid}, {"centre-of-mass", ContactKind::centre_of_mass}}};
inline constexpr std::array<std::pair<std::string_view, Shoulder>, 2> shoulder_words{
    {{"sharp", Shoulder::sharp}, {"fillet", Shoulder::fillet}}};
inline constexpr std::array<std::pair<std::string_view, bool>, 2> switch_words{
    {{"on", true}, {"off", false}}};

template <class Words, class Value>
std::string word_of(const Words& words, Value value) {
  for (const auto& [word, meaning] : words)
    if (meaning == value) return std::string{word};
  throw error("word_of: a value without a word");
}

/// Everything that decides a drop. SI units; angles in degrees, as typed. "ours": the paper gives no value.
struct DropOptions {
  Kinematics kinematics = Kinematics::axisymmetric;
  DeviceKind device = DeviceKind::rigid;
  double delta = 20;                    ///< friction angle between sand and device, deg
  bool no_slip = false;                 ///< sand sticks to the device; `delta` is not used
  double velocity = 5.6;                ///< at the impact, downward, m/s
  double mass = 7.71;                   ///< of the whole device, kg; the slice carries its share
  double device_young = 20e6;           ///< of the elastic device, Pa
  double device_poisson = 0.33;         ///< of the elastic device (ours: the sand's)
  Shoulder shoulder = Shoulder::sharp;  ///< edge between cone and cylinder (ours)
  double fillet = 0.01;        ///< radius of the rounded edge, m; with `Shoulder::fillet` only (ours)
  double friction = 40;        ///< of the sand, deg
  double young = 5e6;          ///< of the sand, Pa
  double poisson = 0.33;       ///< of the sand
  double unit_weight = 15100;  ///< of the sand, N/m^3
  double cohesion = 0;         ///< of the sand, Pa
  double dilatancy = 0;        ///< of the sand, deg
  std::optional<double> k0;    ///< earth pressure at rest; default poisson / (1 - poisson) (ours)
  double cell = 0.01;          ///< edge of the cells around the cone, m
  double moving_depth = 0.06;  ///< the mesh moves as one from here below the tip upward, m (ours)
  std::string mesh;            ///< Gmsh file in the place of the generated mesh; empty: none
  std::optional<int> points_per_element;  ///< in the sand; default: see `points_in_element`
  ContactKind contact =
      ContactKind::rigid;    ///< of a rigid device; an elastic one meets the sand through the centre of mass
  bool anti_locking = true;  ///< strains averaged over nodes, stresses over filled elements
  double flip = 1;           ///< share of FLIP in the velocity update, the rest is PIC
  double courant = 0.5;      ///< time step over the stable estimate h / c
  double end = 0.1;          ///< s
  int threads = 0;           ///< 0: the environment's ARENITE_THREADS, else one for each processor
  double fields_every = 0.02;   ///< s; 0: no fields
  std::string out = "out/ffp";  ///< folder of the results
  bool quiet = false;

  /// The paper's 10 in tetrahedra; 28 in triangles, from where on more change depth by 2 % and peak by 7 %:
  /// 15, 21, 28, 36, 49 give 0.201, 0.196, 0.195, 0.194, 0.190 m and 15.1, 16.9, 16.8, 17.6, 17.9 g.
  int points_in_element() const {
    return points_per_element.value_or(kinematics == Kinematics::slice ? 10 : 28);
  }
  double earth_pressure() const { return k0.value_or(poisson / (1 - poisson)); }
  Device body() const { return Device{{.fillet = shoulder == Shoulder::fillet ? fillet : 0}}; }
  MeshSizes mesh_sizes() const { return {.cell = cell, .moving_depth = moving_depth}; }
};

namespace detail {

using arenite::shared_detail::join;

template <class T, std::size_t N>
bool one_of(const T& value, const std::array<T, N>& allowed) {
  for (const T& a : allowed)
    if (value == a) return true;
  return false;
}

/// `require` for a closed range; NaN fails.
inline void in_range(std::string_view name, double value, double low, double high,
                     std::string_view unit = "") {
  require(value >= low && value <= high, name, value,
          join("must lie in [", low, ", ", high, "]", unit.empty() ? "" : " ", unit));
}

}  // namespace detail

/// Throws `error("--option = value: rule")` at the first value out of its range.
inline void check(const DropOptions& o) {
  using detail::in_range;
  in_range("--delta", o.delta, 0, 60, "deg");
  require(o.velocity > 0 && o.velocity <= 50, "--velocity", o.velocity, "must lie in (0, 50] m/s");
  in_range("--mass", o.mass, 0.1, 1000, "kg");
  in_range("--device-young", o.device_young, 1e5, 1e12, "Pa");
  require(o.device_poisson > -1 && o.device_poisson < 0.5, "--device-poisson", o.device_poisson,
          "must lie in (-1, 0.5)");
  in_range("--fillet", o.fillet, 0.001, 0.03, "m");
  in_range("--friction", o.friction, 1, 60, "deg");
  in_range("--young", o.young, 1e4, 1e10, "Pa");
  require(o.poisson > -1 && o.poisson < 0.5, "--poisson", o.poisson, "must lie in (-1, 0.5)");
  in_range("--unit-weight", o.unit_weight, 1000, 100000, "N/m^3");
  in_range("--cohesion", o.cohesion, 0, 1e6, "Pa");
  require(
      o.dilatancy >= 0 && o.dilatancy <= o.friction, "--dilatancy", o.dilatancy,
      detail::join("must lie in [0, ", o.friction, "] deg, from nothing to the sand's angle of friction"));
  if (o.k0) in_range("--k0", *o.k0, 0, 3);
  in_range("--cell", o.cell, 0.0025, 0.04, "m");
  in_range("--moving-depth", o.moving_depth, 0.02, 0.15, "m");
  if (!o.mesh.empty())
    require(std::ifstream{o.mesh}.peek() != std::ifstream::traits_type::eof(), "--mesh", o.mesh,
            "must be a file that can be read");
  const int n = o.points_in_element();
  if (o.kinematics == Kinematics::slice)
    require(detail::one_of(n, std::array{1, 4, 10, 20, 35, 56, 84}), "--points-per-element", n,
            "must be 1, 4, 10, 20, 35, 56 or 84 in the slice's tetrahedra");
  else
    require(detail::one_of(n, std::array{1, 3, 4, 6, 9, 10, 15, 16, 21, 25, 28, 36, 49}),
            "--points-per-element", n,
            "must be 1, 3, 4, 6, 9, 10, 15, 16, 21, 25, 28, 36 or 49 in triangles");
  in_range("--flip", o.flip, 0, 1);
  require(o.courant > 0 && o.courant <= 1, "--courant", o.courant, "must lie in (0, 1]");
  require(o.end > 0 && o.end <= 10, "--end", o.end, "must lie in (0, 10] s");
  in_range("--threads", o.threads, 0, 1024);
  require(o.fields_every >= 0 && o.fields_every <= 10, "--fields-every", o.fields_every,
          "must lie in [0, 10] s, where 0 writes no fields");
  require(!o.out.empty(), "--out", "\"\"", "must name a folder");
}

}  // namespace arenite::ffp
