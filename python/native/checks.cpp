// Checks: see checks.hpp. Values are read as a scene reads them and passed to the same constructors; what
// goes together is decided by the same constants as in the library's static_asserts.
#include "checks.hpp"

#include <arenite/core/refusals.hpp>
#include <arenite/watch/watch.hpp>
#include <arenite_host/read_any_friction.hpp>
#include <arenite_host/read_recipes.hpp>
#include <cmath>
#include <map>
#include <type_traits>
#include <utility>

namespace arenite::python {
namespace {

// --- values

using Check = void (*)(const Value&);
using Checks = std::map<std::string, Check>;

template <class T>
void reads(const Value& values) {
  read<T>(values, ReadContext{.name = detail::display_name<T>()});
}
/// Read, and bound as in a scene in space, which allows whatever one in the plane does.
template <class Bound, class T>
void binds(const Value& values) {
  Bound(read<T>(values, ReadContext{.name = detail::display_name<T>()}));
}

/// In the plane the inertia is one number, in axisymmetry none.
void check_free(const Value& values) {
  Free body = read<Free>(values, ReadContext{.name = "Free"});
  if (values.find("inertia")) body.inertia.check<2>();
  body.inertia = 1.0;
  BoundFree<double, 3>{body};
}
void check_anchor(const Value& values) {
  Free body{.mass = 1, .inertia = 1.0, .centre = {0, 0, 0}};
  body.anchor = read<Anchor>(values, ReadContext{.name = "Anchor"});
  BoundFree<double, 3>{body};
}
void check_geostatic(const Value& values) {
  read<Geostatic>(*values.find("geostatic"), ReadContext{.name = "Geostatic"}).check();
}
void check_wall(const Value& values) {
  Wall wall = read<Wall>(values, ReadContext{.name = "Wall"});
  if (wall.axis < 0 && wall.set.empty()) wall.test = [](const auto&) { return true; };  // it is not called
  Walls::check<3>(wall);
}
void check_rigid(const Value& values) {
  read<Friction>(*values.find("friction"), ReadContext{.name = "Rigid.friction"});
  if (const Value* reach = values.find("surface")->find("reach")) {
    DistanceSurface<> surface{AnyDistance{},
                              read<double>(*reach, ReadContext{.name = "DistanceSurface.reach"})};
    BoundDistanceSurface<double, 3>{surface};
  }
}

/// Dimensions that a shape is meant for; 0: not known.
int dimension_of(const Value& shape) {
  for (const char* key : {"lower", "centre", "a", "of"}) {
    const Value* v = shape.find(key);
    if (v == nullptr) continue;
    if (v->find("shape")) return dimension_of(*v);
    if (detail::is_numbers(*v)) return detail::numbers(*v, ReadContext{.name = key}).size() == 2 ? 2 : 3;
  }
  const Value* kind = shape.find("shape");
  if (kind == nullptr) return 0;
  const auto* word = kind->get<std::string>();
  return *word == "Polygon" || *word == "ConeCylinder" ? 2 : 3;
}
void check_shape(const Value& shape) {
  const int dimension = dimension_of(shape);
  const ReadContext at{.name = "shape", .dimension = dimension};
  if (dimension == 2) detail::read_shape<2>(shape, at);
  if (dimension == 3) detail::read_shape<3>(shape, at);
}

template <template <int, class> class Mesh>
void check_grid(const Value& values) {
  const Value *lower = values.find("lower"), *z = values.find("z");
  const bool plane = lower ? detail::numbers(*lower, ReadContext{.name = "CartesianGrid.lower"}).size() == 2
                           : !z || detail::numbers(*z, ReadContext{.name = "RectilinearGrid.z"}).empty();
  if (plane)
    reads<Mesh<2, double>>(values);
  else
    reads<Mesh<3, double>>(values);
}
void check_simplex_mesh(const Value& values) {
  const HostArray* nodes = values.find("nodes")->array();
  if (nodes && nodes->columns() == 3)
    reads<SimplexMesh<3, double>>(values);
  else
    reads<SimplexMesh<2, double>>(values);
}

/// A law with all memories, and any friction; its stiffness is a separate recipe.
template <class Law>
void check_law(const Value& values) {
  Value::Dict of_law = *values.get<Value::Dict>();
  of_law.erase("stiffness_law");
  reads<Law>(Value(std::move(of_law)));
}
template <template <class, class, class> class Law>
void add_laws(Checks& checks, const char* name) {
  Memories::each([&]<class Memory>(std::type_identity<Memory>) {
    checks.emplace(joined_text({name, "<", detail::display_name<Memory>(), ", AnyFriction>"}),
                   &check_law<Law<Memory, AnyFriction, ConstantStiffness>>);
  });
}

// Options of parts, bodies and paths that hang on no scene. Their functions of place are called by the scene.
void check_fill(const Value& values) {
  const auto options = read<FillOptions>(values, ReadContext{.name = "FillOptions"});
  options.check();
  options.velocity.at<double, 3>(Vec<double, 3>::Zero());
  for (const auto& [name, number] : options.history)
    require(std::isfinite(number({})), {"FillOptions.history, ", name}, number({}), "must be finite");
}
void check_absorbing(const Value& values) {
  read<AbsorbingFaces>(values, ReadContext{.name = "Absorbing"}).options.check("Absorbing");
}
void check_stage(const Value& values) {
  read<DriveStage<3>>(values, ReadContext{.name = "Stage", .dimension = 3}).check();
}
void check_rigid_pair(const Value& values) {
  const auto pair = read<RigidPair>(values, ReadContext{.name = "RigidPair"});
  for (const auto& [member, word] : {std::pair("first", pair.first), std::pair("second", pair.second)})
    require(!word.empty() && word.find_first_not_of("0123456789") == std::string::npos,
            {"RigidPair.", member}, word, "must be the number of a rigid body, 0 or more");
  require(pair.first != pair.second, "RigidPair.second", pair.second, "must be another body than the first");
}
void check_ugimp(const Value& values) {
  const int points = read<int>(*values.find("points"), ReadContext{.name = "UGimp.points"});
  require(points >= 1, "UGimp.points", points, "must be at least 1");
}

template <class... T>
void add_read(Checks& checks) {
  (checks.emplace(detail::display_name<T>(), &reads<T>), ...);
}

/// Name of a recipe: that of its type without arguments; both of `CorrectedFlip` by their own.
template <class T>
std::string word() {
  const std::string all = type_words<T>();
  return all.substr(0, all.find('<'));
}
template <>
std::string word<Fmpm>() {
  return "Fmpm";
}
template <>
std::string word<Xpic>() {
  return "Xpic";
}

/// Those of a family that have parameters.
template <class Family>
void add_family(Checks& checks) {
  Family::each([&]<class P>(std::type_identity<P>) {
    if constexpr (!std::is_empty_v<P>) checks.emplace(word<P>(), &reads<P>);
  });
}

Checks made() {
  Checks checks;
  add_laws<MohrCoulomb>(checks, "MohrCoulomb");
  add_laws<DruckerPrager>(checks, "DruckerPrager");
  add_read<LinearElastic>(checks);
  add_family<Memories>(checks);
  add_family<Frictions>(checks);
  add_family<Stiffnesses>(checks);
  add_family<Transfers>(checks);
  add_read<ElementAverage, NodalAndElementAverage>(checks);
  add_read<ViscousDamping, LocalDamping, Coulomb<>, FrictionalWall, FaceTraction, BodyForce, PointLoad,
           Prescribed>(checks);
  checks.emplace("Watch", [](const Value& values) {
    Watch(read<WatchLimits>(values, ReadContext{.name = "WatchLimits"}));
  });
  checks.emplace("Geostatic", &check_geostatic);
  checks.emplace("SurfaceOptions", [](const Value& values) {
    read<SurfaceOptions>(values, ReadContext{.name = "SurfaceOptions"}).check();
  });
  checks.emplace("Fill", &check_fill);
  checks.emplace("AbsorbingFaces", &check_absorbing);
  checks.emplace("Stage", &check_stage);
  checks.emplace("RigidContact", &reads<RigidContact>);
  checks.emplace("RigidPair", &check_rigid_pair);
  checks.emplace("UGimp", &check_ugimp);
  checks.emplace("Guided", &binds<BoundGuided<double, 3>, Guided>);
  checks.emplace("PrescribedPose", &binds<BoundPrescribedPose<double, 3>, PrescribedPose>);
  checks.emplace("Free", &check_free);
  checks.emplace("Anchor", &check_anchor);
  checks.emplace("Rigid", &check_rigid);
  checks.emplace("MeshSurface", &binds<BoundMeshSurface<double, 3>, MeshSurface>);
  checks.emplace("MovingMesh", [](const Value& values) {
    check_moving_mesh<3>(read<MovingMesh<>>(values, ReadContext{.name = "MovingMesh"}));
  });
  checks.emplace("Wall", &check_wall);
  checks.emplace("Shape", &check_shape);
  checks.emplace("CartesianGrid", &check_grid<CartesianGrid>);
  checks.emplace("RectilinearGrid", &check_grid<RectilinearGrid>);
  checks.emplace("SimplexMesh", &check_simplex_mesh);
  for (const char* function : {"Ramp", "Table"}) checks.emplace(function, &reads<ScalarFunction>);
  checks.emplace("Scaled", &reads<VectorFunction>);
  return checks;
}
const Checks& checks() {
  static const Checks all = made();
  return all;
}

// --- what goes together

using Refusals = std::map<std::vector<std::string>, const char*>;

template <class Shape, class Transfer, class Order>
void refuse_order(Refusals& refused) {
  constexpr bool maps_back = Order::maps_back && !returns_unchanged<Transfer, Shape>;
  if (maps_back)
    refused[{"PointContact", word<Shape>(), word<Transfer>(), word<Order>()}] =
        ARENITE_SAYS_POINT_CONTACT_MUSL;
  if (maps_back && Shape::constant_gradient && Transfer::affine)
    refused[{word<Shape>(), word<Transfer>(), word<Order>()}] = ARENITE_SAYS_MUSL_WITHOUT_GRADIENT;
}
template <class Shape>
void refuse_transfers(Refusals& refused) {
  Transfers::each([&]<class T>(std::type_identity<T>) {
    if (!T::template fits<Shape>)
      refused[{word<Shape>(), word<T>()}] = ARENITE_SAYS_TRANSFER_SHAPE;
    else
      refuse_order<Shape, T, Musl>(refused);
  });
}
template <class Shape, class... AntiLocking>
void refuse_anti_locking(Refusals& refused) {
  ((AntiLocking::template fits<Shape>
        ? void()
        : void(refused[{word<Shape>(), word<AntiLocking>()}] = ARENITE_SAYS_AVERAGES_SHAPE)),
   ...);
}
template <class Shape, class... Mesh>
void refuse_meshes(Refusals& refused) {
  ((shape_function<Shape, Mesh> ? void()
                                : void(refused[{word<Shape>(), word<Mesh>()}] = ARENITE_SAYS_SHAPE_MESH)),
   ...);
}
void refuse_stiffness(Refusals& refused) {
  Stiffnesses::each([&]<class Stiffness>(std::type_identity<Stiffness>) {
    if constexpr (requires { requires Stiffness::reads_friction_history; })
      Frictions::each([&]<class Friction>(std::type_identity<Friction>) {
        if (!std::is_base_of_v<typename Stiffness::template History<double>,
                               typename Friction::template History<double>>)
          refused[{word<Stiffness>(), word<Friction>()}] = ARENITE_SAYS_STIFFNESS_HISTORY;
      });
  });
}

template <class Mesh>
void refuse_on_mesh(Refusals& refused) {
  if (!is_simplex_mesh<Mesh>) refused[{"MeshSurface", word<Mesh>()}] = ARENITE_SAYS_MESH_SURFACE_ON_GRID;
  if (!is_simplex_mesh<Mesh> && !is_rectilinear<Mesh>)
    refused[{"MovingMesh", word<Mesh>()}] = ARENITE_SAYS_RESTING_GRID;
}
template <class Surface, class Bound>
void refuse_surface(Refusals& refused) {
  const char* const through_centre = ARENITE_SAYS_CENTRE_OF_MASS;
  if (!Bound::has_volume_fractions) refused[{"CentreOfMass", word<Surface>()}] = through_centre;
  const auto of_motion = [&]<class Motion>(std::type_identity<Motion>, const char* name) {
    if (!Motion::has_mass) refused[{"CentreOfMass", name}] = through_centre;
    if (rotates<Motion> && !rigid_surface<Bound, LinearSimplex, SimplexMesh<2, double>, Pose<2>>)
      refused[{name, word<Surface>()}] = ARENITE_SAYS_RESTING_SURFACE;
  };
  of_motion(std::type_identity<BoundGuided<double, 2>>{}, "Guided");
  of_motion(std::type_identity<BoundPrescribed<double, 2>>{}, "Prescribed");
  of_motion(std::type_identity<BoundPrescribedPose<double, 2>>{}, "PrescribedPose");
  of_motion(std::type_identity<BoundFree<double, 2>>{}, "Free");
  if (!requires(const Bound surface) { surface.distance(); }) {
    refused[{"PointContact", word<Surface>()}] = ARENITE_SAYS_POINT_CONTACT_SURFACE;
    refused[{"RigidContact", word<Surface>()}] = ARENITE_SAYS_RIGID_CONTACT_SURFACE;
  }
}

Refusals refusals() {
  Refusals refused;
  refuse_on_mesh<CartesianGrid<2, double>>(refused);
  refuse_on_mesh<RectilinearGrid<2, double>>(refused);
  refuse_on_mesh<PeriodicGrid<CartesianGrid<2, double>, 1>>(refused);
  refuse_on_mesh<SimplexMesh<2, double>>(refused);
  refuse_surface<MeshSurface, BoundMeshSurface<double, 2>>(refused);
  refuse_surface<DistanceSurface<>, BoundDistanceSurface<double, 2>>(refused);
  refused[{"RigidContact", "CentreOfMass"}] = ARENITE_SAYS_RIGID_CONTACT_CENTRE;
  refused[{"RigidContact", "PointContact"}] = ARENITE_SAYS_RIGID_CONTACT_POINTS;
  const auto of_shape = [&]<class Shape>(std::type_identity<Shape>) {
    refuse_transfers<Shape>(refused);
    refuse_anti_locking<Shape, NoAntiLocking, NodalAveraging, ElementAverage, NodalAndElementAverage>(
        refused);
    refuse_meshes<Shape, CartesianGrid<2, double>, RectilinearGrid<2, double>,
                  PeriodicGrid<CartesianGrid<2, double>, 1>, SimplexMesh<2, double>>(refused);
  };
  of_shape(std::type_identity<LinearGrid>{});
  of_shape(std::type_identity<QuadraticBSpline>{});
  of_shape(std::type_identity<CubicBSpline>{});
  of_shape(std::type_identity<UGimp<2>>{});
  of_shape(std::type_identity<MlsGradient<QuadraticBSpline>>{});
  of_shape(std::type_identity<LinearSimplex>{});
  refuse_stiffness(refused);
  const auto in_space = [&]<class K>(std::type_identity<K>) {
    for (const int d : {2, 3})
      if (d != K::dimension) refused[{word<K>(), std::to_string(d)}] = ARENITE_SAYS_DIMENSIONS;
  };
  in_space(std::type_identity<PlaneStrain>{});
  in_space(std::type_identity<Axisymmetric>{});
  in_space(std::type_identity<ThreeDimensional>{});
  return refused;
}

/// A value without tests of places, which are called only with the mesh.
Value without_tests(const Value& values) {
  const auto* given = values.get<Value::Dict>();
  if (given == nullptr) return values;
  Value::Dict all;
  for (const auto& [key, value] : *given)
    if (key != "test") all.emplace(key, key == "where" ? without_tests(value) : value);
  return Value(std::move(all));
}

}  // namespace

void check_recipe(const std::string& recipe, const Value& values) {
  if (const auto found = checks().find(recipe); found != checks().end()) found->second(without_tests(values));
}
std::vector<std::string> checked_recipes() {
  std::vector<std::string> all;
  for (const auto& [recipe, check] : checks()) all.push_back(recipe);
  return all;
}
std::vector<std::pair<std::string, std::vector<std::string>>> frictions() {
  std::vector<std::pair<std::string, std::vector<std::string>>> all;
  const auto add = [&]<class P>(std::type_identity<P>) {
    const auto& names = history_names<typename P::template History<double>>;
    all.emplace_back(detail::display_name<P>(), std::vector<std::string>(names.begin(), names.end()));
  };
  Frictions::each(add);
  add(std::type_identity<AnyFriction>{});
  return all;
}
void check_together(const std::vector<std::string>& recipes) {
  static const Refusals refused = refusals();
  if (const auto found = refused.find(recipes); found != refused.end()) throw error(found->second);
}

}  // namespace arenite::python
