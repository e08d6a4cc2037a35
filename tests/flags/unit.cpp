// One translation unit of the test of units with other flags: compiled several times, each time with flags of
// its own and with the name of its function in UNIT.
#include <arenite/arenite.hpp>
#include <arenite/io/csv.hpp>
#include <arenite/io/gmsh.hpp>
#include <arenite/observe/vtu.hpp>
#include <sstream>
#include <string>

#include "meshes.hpp"
#include "units.hpp"

using namespace arenite;

namespace {

// Functions, not objects: what is made before `main` runs on any processor, in each unit.
auto sand() {
  return MohrCoulomb{{.density = 1540, .young = 1_MPa, .poisson = 0.3, .friction = 35_deg, .cohesion = 100}};
}
auto rubber() { return LinearElastic{{.density = 1000, .young = 1_MPa, .poisson = 0.3}}; }

/// Runs a few steps on both threads, writes fields, returns the sum of the stresses, Pa.
template <class Scene>
double stresses_after(Scene scene, std::filesystem::path file) {
  run(scene, {.end = stable_step(scene), .courant = 0.2}, every(1, vtu(std::move(file))));
  double sum = 0;
  scene.for_each_body([&](const auto& body, const auto&) {
    for (const auto& s : body.points.stress) sum += trace(s);
  });
  return sum + energies(scene).kinetic;
}

double press_on_triangles(std::filesystem::path file) {
  auto data = test::triangles({0, 0}, {0.6, 0.6}, 24, 24);
  test::name_region(data, "block", [](const auto& x) { return x[0] < 0.2 && x[1] > 0.3 && x[1] < 0.5; });
  test::name_region(data, "layer", [](const auto& x) { return x[1] < 0.3; });
  return stresses_after(
      Scene{PlaneStrain{}, SimplexMesh<2>(data),
            Numerics<LinearSimplex, Flip, Musl, NodalAndElementAverage>{},
            bodies(fill(Cells("layer"), WithDeviatoricStrain(sand()), {.per_cell = 6})),
            walls(left(roller), right(roller), bottom(fixed)), gravity({0, -9.81}),
            rigids(rigid(MeshSurface{"block"}, Guided{.mass = 100, .velocity = -1}, Friction(20_deg))),
            MovingMesh<>{.fixed_below = 0, .moving_from = 0.3}, TrackEnergy{}},
      std::move(file));
}

double blocks_on_grid(std::filesystem::path file) {
  return stresses_after(
      Scene{ThreeDimensional{}, CartesianGrid<3>{{.lower = {0, 0, 0}, .upper = {1, 1, 1}, .cell = 0.125}},
            Numerics<QuadraticBSpline, Apic, Usl>{},
            bodies(fill(Box{{0, 0, 0}, {0.5, 1, 1}}, rubber(), {.per_cell = 8, .velocity = {1, 0, 0}}),
                   fill(Box{{0.5, 0, 0}, {1, 1, 1}},
                        DruckerPrager({.density = 1540, .young = 1_MPa, .poisson = 0.3, .friction = 35_deg}),
                        {.per_cell = 8})),
            walls(bottom(fixed)), gravity({0, -9.81, 0}), Coulomb{Friction(20_deg)}, TrackEnergy{}},
      std::move(file));
}

std::size_t cells_of_a_file() {
  std::istringstream file(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n$Elements\n1\n"
      "1 2 2 1 1 1 2 3\n$EndElements\n");
  return read_gmsh<2>(file).cells.size();
}

}  // namespace

Result UNIT(const char* name, int wanted) {
  const auto file = [&](const char* end) {
    std::filesystem::path path;
    return (path += name) += end;
  };
  set_threads(wanted);
  if (wanted > 0)
    on_warning([](const std::string& text) { heard += text.starts_with("of "); });  // not of previous files
  warn(joined_text({"of ", name}));
  CsvWriter(file(".csv"), {"a", "b"}).row({1, 2});
  try {
    LinearElastic({.density = -1, .young = 1_MPa, .poisson = 0.3});
    throw std::logic_error("a negative density was taken");
  } catch (const error&) {
  }
  return {{press_on_triangles(file("press")), blocks_on_grid(file("blocks"))}, cells_of_a_file(), threads()};
}
