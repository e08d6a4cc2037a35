// Transfers and orders of the stress update side by side: the tables of docs/transfers.md. Not built with the
// library, for it makes some fifty scenes:
//   g++ -std=c++20 -O2 -march=native -isystem include -I tests/support -isystem /usr/include/eigen3
//       docs/studies/transfers.cpp -o transfers -pthread && ./transfers disc && ./transfers orders
#include <cstdio>
#include <cstring>

#include "manufactured.hpp"
#include "meshes.hpp"

using namespace arenite;
using namespace arenite::test;

namespace {

// ---- an elastic disc of 0.3 m that spins freely, its rim at 0.16 of the wave speed ----

constexpr double radius = 0.3, rim_speed = 0.16, turns = 10;
const LinearElastic rubber{{.density = 1000, .young = 1e5, .poisson = 0.3}};
const double spin = rim_speed * std::sqrt(rubber.wave_modulus() / rubber.density()) / radius;  // rad/s
const double turn = 2 * pi / spin;                                                             // s

/// Of a scene: energy, J; angular momentum, kg m2/s, with what velocity gradients hand over; sum of x^2, m2.
struct State {
  double energy = 0, angular_momentum = 0, square = 0;
};
template <class Scene>
State state_of(const Scene& scene) {
  const auto& body = scene.body();
  const auto& points = body.points;
  State s{kinetic_energy(body) + strain_energy(body) +
              gradient_kinetic_energy<typename Scene::Shape>(scene.mesh, scene.blocks, body),
          0, 0};
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto x = points.position[p], v = points.velocity[p];
    s.angular_momentum += points.mass[p] * (x[0] * v[1] - x[1] * v[0]);
    if constexpr (Scene::NumericsType::Transfer::affine && !Scene::Shape::constant_gradient)
      s.angular_momentum += points.mass[p] *
                            (points.velocity_gradient[p](1, 0) - points.velocity_gradient[p](0, 1)) *
                            square(scene.mesh.edge()) / 4;
    s.square += x.squaredNorm();
  }
  return s;
}

template <class N, class Mesh>
void disc(const char* name, const Mesh& mesh, int per_cell, const N& numerics) {
  Scene scene{
      PlaneStrain{}, Mesh(mesh), numerics,
      bodies(fill(Inside{[](const auto& x) { return x.norm() - radius; }}, rubber, {.per_cell = per_cell}))};
  auto& points = scene.body().points;
  Mat<double, 2> gradient;
  gradient << 0, -spin, spin, 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    points.velocity.set(p, gradient * points.position[p]);
    if constexpr (N::Transfer::affine) points.velocity_gradient.set(p, gradient);
  }
  const State start = state_of(scene);
  const std::size_t count = points.size();
  double greatest = 1;
  try {
    while (scene.time < turns * turn) {
      step(scene, 0.5 * stable_step(scene));
      if (scene.steps % 20 != 0) continue;
      greatest = std::max(greatest, state_of(scene).energy / start.energy);
      if (greatest > 20 || scene.lost_points() > 0) break;
    }
  } catch (const error&) {
  }
  const State end = state_of(scene);
  std::printf(
      "| %s | %.1f | %.3f | %.3f | %.3f | %.3f | %.3f |\n", name, scene.time / turn,
      end.energy / start.energy, strain_energy(scene.body()) / start.energy, greatest,
      end.angular_momentum / start.angular_momentum,
      std::sqrt(end.square / static_cast<double>(points.size()) * static_cast<double>(count) / start.square));
  std::fflush(stdout);
}

template <class Order>
void discs(const std::string& order) {
  const CartesianGrid<2> grid{{.lower = {-0.45, -0.45}, .upper = {0.45, 0.45}, .cell = 0.0375}};
  const SimplexMesh<2> mesh(triangles({-0.45, -0.45}, {0.45, 0.45}, 24, 24));
  const auto spline = [&]<class T>(const char* name, const T& transfer) {
    disc(("B-splines; " + order + "; " + name).c_str(), grid, 4,
         Numerics<QuadraticBSpline, T, Order>{.transfer = transfer});
  };
  const auto simplex = [&]<class T>(const char* name, const T& transfer) {
    disc(("triangles; " + order + "; " + name).c_str(), mesh, 3,
         Numerics<LinearSimplex, T, Order>{.transfer = transfer});
  };
  spline("FLIP", Flip{});
  spline("FLIP, time of a turn", Flip{.time = turn});
  spline("APIC", Apic{});
  spline("AFLIP", Aflip{});
  spline("XPIC(2)", Xpic{});
  spline("XPIC(2), time of a turn", Xpic{.time = turn});
  spline("FMPM(2)", Fmpm{});
  spline("FMPM(4)", Fmpm{.order = 4});
  spline("FMPM(4), time of a turn", Fmpm{.order = 4, .time = turn});
  simplex("FLIP", Flip{});
  simplex("FLIP, time of a turn", Flip{.time = turn});
  simplex("TPIC", Tpic{});
  simplex("XPIC(2)", Xpic{});
  simplex("XPIC(2), time of a turn", Xpic{.time = turn});
  simplex("FMPM(2)", Fmpm{});
  simplex("FMPM(4)", Fmpm{.order = 4});
  simplex("FMPM(4), time of a turn", Fmpm{.order = 4, .time = turn});
}

// ---- orders of convergence on manufactured solutions ----

template <class N>
void order(const char* name, const Motion& motion, double greatest, int cells, double courant,
           const N& numerics) {
  std::printf("| %s |", name);
  double last = 0;
  for (int n = cells; n <= 4 * cells; n *= 2) try {
      double error;
      if constexpr (N::Shape::constant_gradient) {
        const auto along = static_cast<Index>(n);
        error = error_of(motion, SimplexMesh<2>(triangles(motion.lower, motion.upper, along, along)), 3,
                         numerics, courant);
      } else {
        const double edge = (motion.upper[0] - motion.lower[0]) / n;
        error = error_of(motion,
                         CartesianGrid<2>({.lower = {motion.lower[0], motion.lower[1]},
                                           .upper = {motion.upper[0], motion.upper[1]},
                                           .cell = edge}),
                         4, numerics, courant);
      }
      std::printf(" %.4f", error / greatest);
      if (last > 0) std::printf(" (%.2f)", std::log2(last / error));
      std::printf(" |");
      std::fflush(stdout);
      last = error;
    } catch (const arenite::error&) {
      std::printf(" stopped |");
    }
  std::printf("\n");
}

void orders(const Motion& motion, double greatest, int cells, double courant) {
  const auto study = [&](const char* name, const auto& numerics) {
    order(name, motion, greatest, cells, courant, numerics);
  };
  study("linear; FLIP; MUSL", Numerics<LinearGrid, Flip, Musl>{});
  study("linear; APIC; MUSL", Numerics<LinearGrid, Apic, Musl>{});
  study("quadratic; FLIP; USL", Numerics<QuadraticBSpline, Flip, Usl>{});
  study("quadratic; FLIP; MUSL", Numerics<QuadraticBSpline, Flip, Musl>{});
  study("quadratic; FLIP; USF", Numerics<QuadraticBSpline, Flip, Usf>{});
  study("quadratic; APIC; USL", Numerics<QuadraticBSpline, Apic, Usl>{});
  study("quadratic; AFLIP; USL", Numerics<QuadraticBSpline, Aflip, Usl>{});
  study("quadratic; XPIC(2); USL", Numerics<QuadraticBSpline, Xpic, Usl>{});
  study("quadratic; FMPM(4); USL", Numerics<QuadraticBSpline, Fmpm, Usl>{.transfer = {.order = 4}});
  study("cubic; FLIP; USL", Numerics<CubicBSpline, Flip, Usl>{});
  study("cubic; APIC; USL", Numerics<CubicBSpline, Apic, Usl>{});
  study("triangles; FLIP; MUSL", Numerics<LinearSimplex, Flip, Musl>{});
  study("triangles; TPIC; USL", Numerics<LinearSimplex, Tpic, Usl>{});
  study("triangles; FMPM(4); USL", Numerics<LinearSimplex, Fmpm, Usl>{.transfer = {.order = 4}});
}

}  // namespace

int main(int argc, char** argv) {
  const bool all = argc < 2;
  if (all || std::strcmp(argv[1], "disc") == 0) {
    std::puts(
        "| composition | turns | energy | strain energy | greatest energy | angular momentum | radius |");
    std::puts("|---|---|---|---|---|---|---|");
    discs<Usl>("USL");
    discs<Musl>("MUSL");
    discs<Usf>("USF");
  }
  if (all || std::strcmp(argv[1], "orders") == 0) {
    std::puts("axis-aligned, amplitude 0.002 m, 8 to 32 cells");
    orders(axis_aligned(0.002), 0.002, 8, 0.1);
    std::puts("axis-aligned, amplitude 0.05 m, 8 to 32 cells");
    orders(axis_aligned(0.05), 0.05, 8, 0.1);
    std::puts("vortex, a quarter rad, 26 to 104 cells");
    orders(vortex(0.25), 0.25, 26, 0.25);
  }
}
