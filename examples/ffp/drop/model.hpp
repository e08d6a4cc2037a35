// The model of the drop, assembled from the library: which mesh, walls, bodies, contact and numerics make a
// penetrometer that falls into sand. Nothing here computes; it only names.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include <arenite/arenite.hpp>
#include <arenite/io/gmsh.hpp>

#include "../geometry/mesh_slice.hpp"
#include "../options/options.hpp"
#include "../text/words.hpp"
#include "history.hpp"
#include "sand_friction.hpp"

namespace arenite::ffp {

/// The half-section: the full circle, so that its masses and forces are those of the experiment.
struct AxisymmetricModel {
  static constexpr const char* name = "axisymmetric";
  using Kinematics = Axisymmetric;
  static constexpr int dimension = 2;
  static constexpr double whole =
      1;  ///< the experiment over the model: factor of masses, forces and energies

  static MeshData<2> generate(const DropOptions& o) {
    return mesh_axisymmetric(o.body(), o.chamber(), o.mesh_sizes()).data;
  }
  static Walls walls() { return arenite::walls(on("bottom", fixed), on("wall", free_along(1))); }
};

/// The slice of 20 degrees; its two faces are planes of symmetry.
struct SliceModel {
  static constexpr const char* name = "slice";
  using Kinematics = ThreeDimensional;
  static constexpr int dimension = 3;
  static constexpr double whole = 18;

  static MeshData<3> generate(const DropOptions& o) {
    return mesh_slice(mesh_axisymmetric(o.body(), o.chamber(), o.mesh_sizes()), o.body(), o.chamber(),
                      o.mesh_sizes());
  }
  static Walls walls() {
    const double half = SliceShape{}.angle / 2;
    return arenite::walls(on("bottom", fixed), on("wall", free_along(1)),
                          on("side_minus", symmetry({std::sin(half), 0, std::cos(half)})),
                          on("side_plus", symmetry({-std::sin(half), 0, std::cos(half)})));
  }
};

/// Lowest and highest node of a region, m.
template <class Mesh>
std::pair<double, double> height_of(const Mesh& mesh, const std::string& region) {
  const int number = mesh.region_number(region);
  std::pair<double, double> y{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
  for (Index c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region(c) == number)
      for (const Index i : mesh.nodes(c))
        y = {std::min(y.first, mesh.position(i)[1]), std::max(y.second, mesh.position(i)[1])};
  return y;
}

/// Throws `error` unless the device of a mesh that was read is the one of the options: areas, mass and pictures are theirs.
template <class Model, class Mesh>
void check_device_in(const Mesh& mesh, const DropOptions& o) {
  const int number = mesh.region_number("device");
  const Device told = o.body();
  const double near = 0.1 * o.outer_diameter();  // cells may be coarse
  double radius = 0, volume = 0;
  std::pair<double, double> outside{0, 0};  // a node outside of the outline: (r, y)
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    if (mesh.region(c) != number) continue;
    volume += Model::whole * arenite::full_volume<typename Model::Kinematics>(mesh, c);
    for (const Index i : mesh.nodes(c)) {
      const auto x = mesh.position(i);
      const double r = Mesh::dimension == 2 ? x[0] : std::hypot(x[0], x[Mesh::dimension - 1]);
      radius = std::max(radius, r);
      if (r > told.profile(x[1] + near) + near) outside = {r, x[1]};
    }
  }
  const auto [tip, top] = height_of(mesh, "device");
  const auto about = [](double a, double b, double share) { return std::abs(a - b) <= share * b; };
  const std::string cure = joined_text({"; give --diameter ", rounded(2 * radius), " --length ",
                                        rounded(top - tip), ", or is the mesh not in metres?"});
  require(about(2 * radius, o.outer_diameter(), 0.02), "diameter of the device in --mesh", 2 * radius,
          {"must be --diameter = ", o.outer_diameter(), " m within 2 %", cure});
  require(about(top - tip, o.whole_length(), 0.02), "length of the device in --mesh", top - tip,
          {"must be --length = ", o.whole_length(), " m within 2 %", cure});
  require(outside.first == 0, "radius of the device in --mesh", outside.first,
          {"must be that of ", o.device_name(), " at ", outside.second, " m above its tip, ",
           told.profile(outside.second), " m; see --tip, --cone-angle and --device-file"});
  require(about(volume, told.volume(), 0.05), "volume of the device in --mesh", volume,
          {"must be that of ", o.device_name(), ", ", told.volume(),
           " m^3, within 5 %; see --tip, --cone-angle and --device-file"});
}

/// The mesh of the drop: generated, or read. Throws `error` if it cannot be used.
template <class Model>
SimplexMesh<Model::dimension> mesh_of(const DropOptions& o) {
  if (o.mesh.empty()) return SimplexMesh<Model::dimension>(Model::generate(o));
  SimplexMesh<Model::dimension> mesh(read_gmsh<Model::dimension>(o.mesh));
  constexpr double close = 1e-6;  // m
  const auto [bottom, surface] = height_of(mesh, "soil");
  const auto [tip, top] = height_of(mesh, "device");
  require(std::abs(tip) < close, "tip of the device, y", tip, "must be 0 m");
  require(std::abs(surface) < close, "surface of the soil, y", surface, "must be 0 m, the tip's height");
  require(bottom < -o.moving_zone() - close, "bottom of the soil, y", bottom,
          "must lie below the zone that moves as one (--moving-depth)");
  check_device_in<Model>(mesh, o);
  for (const char* set : {"bottom", "wall"}) mesh.node_set(set);
  if constexpr (Model::dimension == 3)
    for (const char* set : {"side_minus", "side_plus"}) mesh.node_set(set);
  return mesh;
}

inline MohrCoulombParameters sand_of(const DropOptions& o) {
  return {.density = o.unit_weight / standard_gravity,
          .young = o.young,
          .poisson = o.poisson,
          .friction = o.friction * pi / 180,
          .cohesion = o.cohesion,
          .dilatancy = o.dilatancy * pi / 180};
}
inline MohrCoulomb<> plain_sand(const DropOptions& o) { return MohrCoulomb{sand_of(o)}; }
inline auto sand_with_law(const DropOptions& o) {
  return MohrCoulomb{sand_of(o), ForgetsOpening{}, friction_of(o.law, o.cell_size())};
}

template <int D, class Region, class Law>
auto soil_of(const DropOptions& o, const Region& region, const Law& law) {
  return fill<"soil">(region, WithDeviatoricStrain<Law, D>{law},
                      {.per_cell = o.points_in_element(),
                       .stress = Geostatic{.surface = 0, .k0 = o.earth_pressure()},
                       .jitter = o.jitter,
                       .seed = static_cast<std::uint64_t>(o.jitter_seed),
                       .even = o.on_grid() && o.cell_at_cone.has_value()});
}

inline Friction friction_of(const DropOptions& o) {
  return o.no_slip ? Friction::no_slip() : Friction(o.delta * pi / 180);
}

template <class Leader, class Mesh>
MovingMesh<Leader> motion_of(const DropOptions& o, const Mesh& mesh) {
  return {.leader = {}, .fixed_below = height_of(mesh, "soil").first, .moving_from = -o.moving_zone()};
}

inline Flip transfer_of(const DropOptions& o) {
  const double time = o.flip_time_constant();
  return {.fraction = o.flip, .time = time > 0 ? time : std::numeric_limits<double>::infinity()};
}
template <class AntiLocking>
Numerics<LinearSimplex, Flip, Musl, AntiLocking> numerics_of(const DropOptions& o) {
  return {.transfer = transfer_of(o), .anti_locking = {}};
}

inline SplitPoints<"soil"> splitting_of(const DropOptions& o) {
  return {.options = {.per_cell = std::max(1.0, o.split_share())},
          .every = o.split_share() > 0 ? std::size_t{10} : 0};
}

/// A rigid penetrometer in its mesh, which moves by `motion`; `Coupling`: its contact with the sand; `more`: parts before the last.
template <class Model, class AntiLocking, class Coupling, class Law, class Mesh, class... More>
auto rigid_scene_in(Mesh mesh, const MovingMesh<LedByRigid<"device">>& motion, const DropOptions& o,
                    const Law& law, const More&... more) {
  return Scene{typename Model::Kinematics{},
               std::move(mesh),
               numerics_of<AntiLocking>(o),
               bodies(soil_of<Model::Kinematics::dimension>(o, Cells("soil"), law)),
               Model::walls(),
               gravity(Triple{0, -standard_gravity, 0}),
               rigids(rigid<"device">(MeshSurface{"device"},
                                      Guided{.mass = o.device_mass() / Model::whole, .velocity = -o.velocity},
                                      friction_of(o), Coupling{})),
               motion,
               more...,
               TrackEnergy{}};
}
template <class Model, class AntiLocking, class Coupling, class Law>
auto rigid_scene(const DropOptions& o, const Law& law) {
  auto mesh = mesh_of<Model>(o);
  const auto motion = motion_of<LedByRigid<"device">>(o, mesh);
  return rigid_scene_in<Model, AntiLocking, Coupling>(std::move(mesh), motion, o, law, splitting_of(o));
}

/// A linear elastic penetrometer of one point an element, which the mesh follows.
template <class Model>
auto elastic_scene(const DropOptions& o) {
  auto mesh = mesh_of<Model>(o);
  double volume = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region(c) == mesh.region_number("device"))
      volume += arenite::full_volume<typename Model::Kinematics>(mesh, c);
  const auto motion = motion_of<LedByBody<"device">>(o, mesh);
  const LinearElastic metal{{.density = o.device_mass() / Model::whole / volume,
                             .young = o.device_young,
                             .poisson = o.device_poisson}};
  return Scene{
      typename Model::Kinematics{},
      std::move(mesh),
      numerics_of<NodalAndElementAverage>(o),
      bodies(soil_of<Model::Kinematics::dimension>(o, Cells("soil"), plain_sand(o)),
             fill<"device">(Cells("device"), metal, {.per_cell = 1, .velocity = {0, -o.velocity, 0}})),
      Model::walls(),
      gravity(Triple{0, -standard_gravity, 0}),
      Coulomb{friction_of(o), SurfaceOf{.region = "device", .body = "device"}},
      motion,
      TrackEnergy{}};
}

}  // namespace arenite::ffp
