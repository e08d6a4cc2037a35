// Compositions that are compiled once: a unit that includes this header takes scene, step and stable step of
// these types from the CMake target `arenite::compositions`, which it must link, and compiles in half the
// time. To name one of your own: docs/compile_time.md.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/arenite.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

namespace compositions {

/// Sand between walls, in the plane.
using PlaneSand = Scene<PlaneStrain, CartesianGrid<2>, Numerics<QuadraticBSpline, Apic>,
                        Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity>;

/// Sand into which a rigid body of any shape is pushed, axisymmetric.
using PushedIntoSand =
    Scene<Axisymmetric, CartesianGrid<2>, Numerics<QuadraticBSpline>, Bodies<Fill<MohrCoulomb<>>>, Walls,
          Gravity, Rigid<DistanceSurface<>, Prescribed>>;

/// Sand between walls, in space.
using Sand = Scene<ThreeDimensional, CartesianGrid<3>, Numerics<QuadraticBSpline, Apic>,
                   Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity>;

/// Sand into which a rigid body of any shape falls along a guide, in space.
using DroppedIntoSand = Scene<ThreeDimensional, CartesianGrid<3>, Numerics<QuadraticBSpline, Apic>,
                              Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity, Rigid<DistanceSurface<>, Guided>>;

}  // namespace compositions

// A class must be spelled out here: the language takes no alias.
extern template struct Scene<PlaneStrain, CartesianGrid<2>, Numerics<QuadraticBSpline, Apic>,
                             Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity>;
extern template void step(compositions::PlaneSand&, double);
extern template double stable_step(const compositions::PlaneSand&);

extern template struct Scene<Axisymmetric, CartesianGrid<2>, Numerics<QuadraticBSpline>,
                             Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity,
                             Rigid<DistanceSurface<>, Prescribed>>;
extern template void step(compositions::PushedIntoSand&, double);
extern template double stable_step(const compositions::PushedIntoSand&);

extern template struct Scene<ThreeDimensional, CartesianGrid<3>, Numerics<QuadraticBSpline, Apic>,
                             Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity>;
extern template void step(compositions::Sand&, double);
extern template double stable_step(const compositions::Sand&);

extern template struct Scene<ThreeDimensional, CartesianGrid<3>, Numerics<QuadraticBSpline, Apic>,
                             Bodies<Fill<MohrCoulomb<>>>, Walls, Gravity, Rigid<DistanceSurface<>, Guided>>;
extern template void step(compositions::DroppedIntoSand&, double);
extern template double stable_step(const compositions::DroppedIntoSand&);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
