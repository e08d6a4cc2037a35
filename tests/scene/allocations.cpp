// A step allocates no memory once a scene has run for a while.
#include <arenite/arenite.hpp>
#include <atomic>
#include <cstdlib>
#include <new>

#include "catch.hpp"
#include "courant.hpp"
#include "meshes.hpp"

namespace {
std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  // aligned_alloc wants a multiple of the alignment.
  void* const p = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (!p) throw std::bad_alloc();
  return p;
}
}  // namespace

void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new[](std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return counted(size, alignof(std::max_align_t));
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return counted(size, alignof(std::max_align_t));
}
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

using namespace arenite;

namespace {

MohrCoulomb<> sand() {
  return MohrCoulomb{{.density = 1500, .young = 1e6, .poisson = 0.3, .friction = 35_deg}};
}

/// Allocations in 100 steps after 60 others.
template <class Scene>
long allocated(Scene&& scene) {
  for (int k = 0; k < 60; ++k) step(scene, test::courant(scene, 0.4) * stable_step(scene));
  const long before = allocations;
  for (int k = 0; k < 100; ++k) step(scene, test::courant(scene, 0.4) * stable_step(scene));
  return allocations - before;
}

}  // namespace

TEST_CASE("a step allocates nothing: triangles, averages, a rigid body that the mesh follows") {
  auto data = test::triangles({0, 0}, {0.6, 0.6}, 24, 24);
  test::name_region(data, "block", [](const auto& x) { return x[0] < 0.2 && x[1] > 0.4 && x[1] < 0.5; });
  test::name_region(data, "layer", [](const auto& x) { return x[1] < 0.4; });
  REQUIRE(
      allocated(Scene{Axisymmetric{}, SimplexMesh<2>(data),
                      Numerics<LinearSimplex, Flip, Musl, NodalAndElementAverage>{},
                      bodies(fill(Cells("layer"), sand(), {.per_cell = 10})),
                      walls(left(roller), right(roller), bottom(fixed)), gravity({0, -9.81}),
                      rigids(rigid(MeshSurface{"block"}, Guided{.mass = 50, .velocity = -1}, Friction(0.3))),
                      MovingMesh<>{.fixed_below = 0, .moving_from = 0.35}, TrackEnergy{}}) == 0);
}

TEST_CASE("a step allocates nothing: tetrahedra that cross cells") {
  REQUIRE(
      allocated(Scene{ThreeDimensional{}, SimplexMesh<3>(test::tetrahedra({0, 0, 0}, {1, 1, 1}, {6, 6, 6})),
                      Numerics<LinearSimplex, Tpic, Usl>{},
                      bodies(fill(Box{{0., 0.1, 0.}, {0.5, 0.6, 0.5}}, sand(),
                                  {.per_cell = 4, .velocity = {0.1, -2, 0}})),
                      walls(left(roller), right(roller), bottom(fixed), front(roller), back(roller)),
                      gravity({0, -9.81, 0})}) == 0);
}

TEST_CASE("a step allocates nothing: two bodies in contact on B-splines") {
  REQUIRE(allocated(Scene{PlaneStrain{}, CartesianGrid<2>{{.lower = {0, 0}, .upper = {1, 1}, .cell = 0.025}},
                          Numerics<QuadraticBSpline, Apic, Usl>{},
                          bodies(fill(Box{{0.2, 0.}, {0.8, 0.3}}, sand(), {.per_cell = 4}),
                                 fill(Box{{0.4, 0.35}, {0.6, 0.5}},
                                      LinearElastic{{.density = 2000, .young = 1e6, .poisson = 0.3}},
                                      {.per_cell = 4, .velocity = {0, -2, 0}})),
                          walls(left(roller), right(roller), bottom(fixed)), gravity({0, -9.81}),
                          Coulomb{Friction(0.3)}}) == 0);
}
