// Cost of contact: of bodies with normals from the gradient of mass, of a cone given by a signed distance
// and of the penetrometer's surface with the sand; and of finding the cell of a point.
#include "../examples/ffp/drop/model.hpp"
#include "stages.hpp"

namespace arenite::bench {
namespace {

/// A column of elastic ground and a block that slides on it: Coulomb contact on B-splines.
auto sliding_block(double points) {
  const double k = std::round(std::sqrt(points / 4)), h = 0.02, top = (k / 2 + 2) * h;
  const Box lower{{2 * h, 2 * h}, {(k + 2) * h, top}}, upper{{2 * h, top}, {(k + 2) * h, (k + 2) * h}};
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {(k + 4) * h, (k + 4) * h}, .cell = h}},
               Numerics<QuadraticBSpline, Apic, Usl>{},
               bodies(fill(lower, elastic(), {.per_cell = 4}),
                      fill(upper, elastic(), {.per_cell = 4, .velocity = {0.1, -0.1}})),
               walls(bottom(fixed)),
               Coulomb{Friction(20_deg)},
               gravity({0, -9.81})};
}

/// A cone that is pushed into a fine grid: 11,704 nodes, 30,000 points, of which few are near the cone.
auto cone_on_fine_grid() {
  const ConeCylinder cone{{.radius = 0.02, .apex = 60_deg, .length = 0.3, .tip = 0.19}};
  Scene scene{Axisymmetric{},
              CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.6, 0.3}, .cell = 0.004}},
              Numerics<QuadraticBSpline, Apic, Usl>{},
              bodies(fill(Box{{0, 0}, {0.6, 0.2}}, elastic(), {.per_cell = 4})),
              walls(bottom(fixed), right(roller)),
              gravity({0, -9.81}),
              rigid(DistanceSurface{cone}, Prescribed{[](double) {
                      return std::array{0.0, -1.0, 0.0};
                    }},
                    Friction(20_deg))};
  return scene;
}

/// A rigid box on elastic ground, 30,000 points; `others`: more rigid bodies, and their contact.
template <class Motion, class... Others>
auto box_on_ground(const Motion& motion, const Others&... others) {
  return Scene{PlaneStrain{},
               CartesianGrid<2>{{.lower = {0, 0}, .upper = {0.6, 0.3}, .cell = 0.004}},
               Numerics<QuadraticBSpline, Apic, Usl>{},
               bodies(fill(Box{{0, 0}, {0.6, 0.2}}, elastic(), {.per_cell = 4})),
               walls(bottom(fixed), left(roller), right(roller)),
               gravity({0, -9.81}),
               rigid(DistanceSurface{Box{{0.2, 0.2}, {0.4, 0.25}}}, motion, Friction(20_deg)),
               others...};
}
Free free_box(double height) {
  return {.mass = 20, .inertia = 20 * (0.04 + 0.0025) / 12, .centre = {0.3, height, 0}};
}
/// Two more boxes on top of it, which touch or pass through each other.
template <class... Contact>
auto three_boxes(const Contact&... contact) {
  return box_on_ground(
      free_box(0.225),
      rigid(DistanceSurface{Box{{0.2, 0.25}, {0.4, 0.3}}}, free_box(0.275), Friction(20_deg)),
      rigid(DistanceSurface{Box{{0.2, 0.3}, {0.4, 0.35}}}, free_box(0.325), Friction(20_deg)), contact...);
}

/// Cells of random points: found from a cell nearby, as relocation does for those that left, and anywhere.
void add_search(const std::string& name, int hops) {
  benchmark::RegisterBenchmark(
      (name + (hops < 0 ? "/search" : "/walk_" + std::to_string(hops))).c_str(),
      [=](benchmark::State& state) {
        SimplexMesh<3> mesh(tetrahedra(12, 0.02));
        std::mt19937 random(3);
        std::uniform_real_distribution<double> uniform(0, 12 * 0.02);
        std::vector<Vec<double, 3>> x(10000);
        std::vector<Index> from(x.size());
        for (std::size_t p = 0; p < x.size(); ++p) {
          x[p] = {uniform(random), uniform(random), uniform(random)};
          from[p] = mesh.search(x[p]);
          for (int hop = 0; hop < hops; ++hop) {
            const Index to = mesh.neighbour(from[p], static_cast<int>(random() % 4));
            if (to != none) from[p] = to;
          }
        }
        for (auto _ : state)
          for (std::size_t p = 0; p < x.size(); ++p)
            benchmark::DoNotOptimize(hops < 0 ? mesh.search(x[p]) : mesh.walk(x[p], from[p]));
        state.counters["points"] = static_cast<double>(x.size());
      })
      ->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace arenite::bench

int main(int argc, char** argv) {
  using namespace arenite;
  using namespace arenite::bench;
  add_stages("bspline_2d_apic_usl_coulomb_two_bodies", [] { return sliding_block(1e5); });
  add_stages("bspline_2d_cone_by_distance", [] { return cone_on_fine_grid(); });
  add_stages("bspline_2d_guided_box", [] { return box_on_ground(Guided{.mass = 20}); });
  add_stages("bspline_2d_free_box", [] { return box_on_ground(free_box(0.225)); });
  add_stages("bspline_2d_three_free_boxes", [] { return three_boxes(); });
  add_stages("bspline_2d_three_free_boxes_rigid_contact",
             [] { return three_boxes(RigidContact{Friction(20_deg)}); });
  add_stages("axisymmetric_rigid_penetrometer", [] {
    const ffp::DropOptions o;
    return ffp::rigid_scene<ffp::AxisymmetricModel, NodalAndElementAverage, RigidVelocity>(
        o, ffp::plain_sand(o));
  });
  for (const int hops : {0, 1, 4, -1}) add_search("tetrahedra_12960", hops);
  return run_benchmarks(argc, argv);
}
