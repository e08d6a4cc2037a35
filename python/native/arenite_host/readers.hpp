// Readers of what many scenes have: compiled once for all scenes of a program that defines
// ARENITE_HOST_ELSEWHERE (arenite_host/reading.hpp), else where they are needed.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/arenite.hpp>
#include <arenite_host/read_any_friction.hpp>
#include <arenite_host/read_recipes.hpp>

#if defined(ARENITE_HOST_ELSEWHERE) || defined(ARENITE_HOST_HERE)

#ifdef ARENITE_HOST_HERE
#define ARENITE_READ(...) template __VA_ARGS__ read<__VA_ARGS__>(const Value&, const ReadContext&)
#else
#define ARENITE_READ(...) extern template __VA_ARGS__ read<__VA_ARGS__>(const Value&, const ReadContext&)
#endif

namespace arenite::inline ARENITE_INSTRUCTION_SET {

ARENITE_READ(FillOptions);
ARENITE_READ(Walls);
ARENITE_READ(WatchLimits);
ARENITE_READ(Section);

ARENITE_READ(CartesianGrid<2>);
ARENITE_READ(CartesianGrid<3>);
ARENITE_READ(SimplexMesh<2>);
ARENITE_READ(SimplexMesh<3>);
ARENITE_READ(Flip);

ARENITE_READ(LinearElasticParameters);
ARENITE_READ(MohrCoulombParameters);
ARENITE_READ(DruckerPragerParameters);
ARENITE_READ(MohrCoulomb<>);
ARENITE_READ(DruckerPrager<>);
ARENITE_READ(MohrCoulomb<ForgetsOpening, AnyFriction>);
ARENITE_READ(DruckerPrager<ForgetsOpening, AnyFriction>);

ARENITE_READ(Rigid<DistanceSurface<>, Prescribed>);
ARENITE_READ(Rigid<DistanceSurface<>, Guided>);
ARENITE_READ(Rigid<DistanceSurface<>, Free>);
ARENITE_READ(Coulomb<>);
ARENITE_READ(GravityInTime);
ARENITE_READ(LocalDamping);
ARENITE_READ(ViscousDamping);
ARENITE_READ(MovingMesh<>);

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET

#undef ARENITE_READ

#endif
