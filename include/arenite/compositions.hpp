// Compositions that are compiled once: a unit that includes this header gets scene, step and stable step of
// these types from the CMake target `arenite::compositions`, which it must link, and compiles in half the
// time. To add your own: docs/compile_time.md.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/arenite.hpp>

/// One composition: its alias in `compositions`, and its compiled parts, declared with `extern`, but in the
/// unit that defines ARENITE_COMPILE_<name> as `~,`: CMake writes it, one for each line below that begins with
/// this name (cmake/compiled.cmake). The type is spelled out: an explicit instantiation takes no alias.
#define ARENITE_COMPOSITION(name, ...)                                          \
  namespace compositions {                                                      \
  using name = __VA_ARGS__;                                                     \
  }                                                                             \
  ARENITE_SECOND(ARENITE_COMPILE_##name, extern, ) template struct __VA_ARGS__; \
  ARENITE_STEP(ARENITE_SECOND(ARENITE_COMPILE_##name, extern, ), compositions::name)
#define ARENITE_SECOND(...) ARENITE_SECOND_OF(__VA_ARGS__)
#define ARENITE_SECOND_OF(first, second, ...) second

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Sand between walls, in the plane.
ARENITE_COMPOSITION(PlaneSand, Scene<PlaneStrain, CartesianGrid<2>, Numerics<QuadraticBSpline, Apic>,
                                     Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity>);

/// Sand into which a rigid body of any shape is pushed, axisymmetric.
ARENITE_COMPOSITION(PushedIntoSand,
                    Scene<Axisymmetric, CartesianGrid<2>, Numerics<QuadraticBSpline>,
                          Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity, Rigid<DistanceSurface<>, Prescribed>>);

/// Sand between walls, in space.
ARENITE_COMPOSITION(Sand, Scene<ThreeDimensional, CartesianGrid<3>, Numerics<QuadraticBSpline, Apic>,
                                Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity>);

/// Sand into which a rigid body of any shape falls along a guide, in space.
ARENITE_COMPOSITION(DroppedIntoSand,
                    Scene<ThreeDimensional, CartesianGrid<3>, Numerics<QuadraticBSpline, Apic>,
                          Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity, Rigid<DistanceSurface<>, Guided>>);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
