// Compositions that are compiled once: a unit that includes this header gets scene, step and stable step of
// these types from the CMake target `arenite::compositions`, which it must link, and compiles in half the
// time. To add your own: docs/compile_time.md.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/arenite.hpp>

// The types, as macros: the language allows no alias in an explicit instantiation.
#define ARENITE_PLANE_SAND                                                                                   \
  Scene<PlaneStrain, CartesianGrid<2>, Numerics<QuadraticBSpline, Apic>, Bodies<Fill<MohrCoulomb<>>>, Walls, \
        Gravity>
#define ARENITE_PUSHED_INTO_SAND                                                                        \
  Scene<Axisymmetric, CartesianGrid<2>, Numerics<QuadraticBSpline>, Bodies<Fill<MohrCoulomb<>>>, Walls, \
        Gravity, Rigid<DistanceSurface<>, Prescribed>>
#define ARENITE_SAND                                                                                       \
  Scene<ThreeDimensional, CartesianGrid<3>, Numerics<QuadraticBSpline, Apic>, Bodies<Fill<MohrCoulomb<>>>, \
        Walls, Gravity>
#define ARENITE_DROPPED_INTO_SAND                                                                          \
  Scene<ThreeDimensional, CartesianGrid<3>, Numerics<QuadraticBSpline, Apic>, Bodies<Fill<MohrCoulomb<>>>, \
        Walls, Gravity, Rigid<DistanceSurface<>, Guided>>

/// The compiled parts of a composition: declared here with `extern`, defined in src/compositions without it.
#define ARENITE_COMPOSITION(EXTERN, name, ...) \
  EXTERN template struct __VA_ARGS__;          \
  ARENITE_STEP(EXTERN, compositions::name)

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace compositions {
/// Sand between walls, in the plane.
using PlaneSand = ARENITE_PLANE_SAND;
/// Sand into which a rigid body of any shape is pushed, axisymmetric.
using PushedIntoSand = ARENITE_PUSHED_INTO_SAND;
/// Sand between walls, in space.
using Sand = ARENITE_SAND;
/// Sand into which a rigid body of any shape falls along a guide, in space.
using DroppedIntoSand = ARENITE_DROPPED_INTO_SAND;
}  // namespace compositions

ARENITE_COMPOSITION(extern, PlaneSand, ARENITE_PLANE_SAND);
ARENITE_COMPOSITION(extern, PushedIntoSand, ARENITE_PUSHED_INTO_SAND);
ARENITE_COMPOSITION(extern, Sand, ARENITE_SAND);
ARENITE_COMPOSITION(extern, DroppedIntoSand, ARENITE_DROPPED_INTO_SAND);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
