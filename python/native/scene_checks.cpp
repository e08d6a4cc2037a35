// Checks of a scene before its composition is compiled: see checks.hpp. Mesh and recipes are read as the
// scene will read them; bodies are filled with a law that represents any, walls are checked with the mesh.
// Functions of Python are left to the scene: each is called once.
#include <algorithm>
#include <arenite_host/read_fill.hpp>
#include <arenite_host/read_recipes.hpp>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "checks.hpp"

namespace arenite::python {
namespace {

/// Whether a value is, or contains, a function or a signal, whose value is known only as the scene runs.
bool holds_function(const Value& value) {
  if (value.function() || value.get<HostSignal>()) return true;
  if (const auto* all = value.get<Value::Dict>())
    return std::ranges::any_of(*all, [](const auto& item) { return holds_function(item.second); });
  if (const auto* all = value.get<Value::List>()) return std::ranges::any_of(*all, holds_function);
  return false;
}

template <class Mesh>
class SceneCheck {
  static constexpr int D = Mesh::dimension;
  using Kinematics = std::conditional_t<D == 2, PlaneStrain, ThreeDimensional>;
  using Shape = std::conditional_t<is_simplex_mesh<Mesh>, LinearSimplex, LinearGrid>;
  using Place = Vec<double, D>;

 public:
  explicit SceneCheck(const Value& mesh) : mesh_{read<Mesh>(mesh, at_.renamed("mesh"))} {}

  void part(const std::string& type, const Value& value) const {
    const std::string word = type.substr(0, type.find('<'));
    if (word == "Bodies" || word == "BodyList")
      for (const Value& of : *value.get<Value::List>()) body(of);
    else if (word == "Walls")
      for (const Value& of : *value.find("list")->get<Value::List>()) wall(of, "Wall");
    else if (word == "Rigid")
      rigid(type, value);
    else if (word == "Gravity")
      bound<Gravity>(value, "gravity");
    else if (word == "GravityInTime")
      vector(value.find("g"), "gravity");
    else if (word == "Driven")
      wall(*value.find("wall"), "Driven.wall"), vector(value.find("velocity"), "Driven.velocity");
    else if (word == "BodyForce")
      vector(value.find("value"), "BodyForce.force");
    else if (word == "FaceTraction")
      faces(value), vector(value.find("load")->find("traction"), "Traction.traction");
    else if (word == "AbsorbingFaces" || word == "FrictionalWall")
      faces(value);
    else if (word == "PointLoad")
      vector(value.find("place"), "PointLoad.place"), vector(value.find("force"), "PointLoad.force");
  }

 private:
  template <class P>
  void bound(const Value& value, const char* name) const {
    if (holds_function(value)) return;
    const SceneTraits<Kinematics, Mesh, Numerics<Shape>, 1> traits{mesh_};
    bind_part(read<P>(value, at_.renamed(name)), traits);
  }
  void vector(const Value* value, const char* name) const {
    if (value == nullptr) return;
    const auto f = read<VectorFunction>(*value, at_.renamed(name));
    if (!holds_function(*value)) value_at<double, D>(f, Place::Zero(), 0, name);
  }
  void wall(const Value& value, const char* name) const {
    if (holds_function(value)) return;
    constrain(read<Wall>(value, at_.renamed(name)));
  }
  /// Faces of the mesh lie where a wall would.
  void faces(const Value& value) const {
    const Value& where = *value.find("where");
    if (holds_function(where)) return;
    const auto of = read<MeshFaces>(where, at_.renamed("faces"));
    constrain({of.axis, of.upper, of.set, {}, fixed});
  }
  void constrain(Wall wall) const {
    NodeConstraints<Shape, Mesh> nodes(mesh_);
    Walls{{std::move(wall)}}.constrain(nodes);
  }
  void body(const Value& value) const {
    const Value &region = *value.find("region"), &options = *value.find("options");
    Value::Dict known = *options.get<Value::Dict>();
    known.erase("history");  // it is the law's
    std::erase_if(known, [](const auto& item) { return holds_function(item.second); });
    Fill<LinearElastic> fill{{},
                             LinearElastic{{.density = 1, .young = 1, .poisson = 0}},
                             read<FillOptions>(known, at_.renamed("FillOptions"))};
    if (holds_function(region)) {
      fill.options.may_be_empty = true;
      fill.region.test = [](const auto&) { return false; };
    } else {
      fill.region = read<AnyRegion>(region, at_.renamed("region"));
    }
    auto& stress = fill.options.stress;
    if (stress && stress->geostatic()) stress.reset();  // it takes its gravity from the scene
    make_body<Kinematics>(mesh_, fill);
  }
  void rigid(const std::string& type, const Value& value) const {
    const Value &surface = *value.find("surface"), &motion = *value.find("motion");
    if (const Value* distance = surface.find("distance"); distance && !holds_function(*distance))
      read<AnyDistance>(*distance, at_.renamed("Rigid.surface"));
    const auto moves_by = [&](const char* word) { return type.find(word) != std::string::npos; };
    if (moves_by(", Prescribed>") || moves_by(", Prescribed,")) vector(&motion, "Prescribed.velocity");
    if (moves_by(", PrescribedPose")) {
      bound<PrescribedPose>(motion, "PrescribedPose");
      vector(motion.find("velocity"), "PrescribedPose.velocity");
      if (const Value* spin = motion.find("spin"); spin && detail::is_numbers(*spin))
        spin_argument<D>("PrescribedPose.spin", read<Triple>(*spin, at_.renamed("PrescribedPose.spin")));
    }
    if (moves_by(", Guided")) bound<Guided>(motion, "Guided");
    if (moves_by(", Free") && motion.find("inertia")) bound<Free>(motion, "Free");
  }

  ReadContext at_{.dimension = D};
  Mesh mesh_;
};

using Check = void (*)(const Value& mesh, const std::vector<std::string>& types, const Value::List& parts);

template <class Mesh>
void check_parts(const Value& mesh, const std::vector<std::string>& types, const Value::List& parts) {
  const SceneCheck<Mesh> check(mesh);
  for (std::size_t k = 0; k < types.size() && k < parts.size(); ++k) check.part(types[k], parts[k]);
}

}  // namespace

void check_scene(std::string mesh_type, const Value& mesh, const std::vector<std::string>& types,
                 const Value& parts) {
  if (constexpr std::string_view outer = "PeriodicGrid<"; mesh_type.starts_with(outer))
    mesh_type = mesh_type.substr(outer.size(), mesh_type.find(',') - outer.size());
  static const std::map<std::string, Check> checks{
      {"CartesianGrid<2>", &check_parts<CartesianGrid<2>>},
      {"CartesianGrid<3>", &check_parts<CartesianGrid<3>>},
      {"RectilinearGrid<2>", &check_parts<RectilinearGrid<2>>},
      {"RectilinearGrid<3>", &check_parts<RectilinearGrid<3>>},
      {"SimplexMesh<2>", &check_parts<SimplexMesh<2>>},
      {"SimplexMesh<3>", &check_parts<SimplexMesh<3>>},
  };
  if (const auto found = checks.find(mesh_type); found != checks.end())
    found->second(mesh, types, *parts.get<Value::List>());
}

}  // namespace arenite::python
