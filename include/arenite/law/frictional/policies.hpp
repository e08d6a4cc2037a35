// Policies of frictional laws: the one list of each family. A new policy of the library is its header and its
// name here; from these lists come the laws whose policies are chosen at run time, what a host can read, and
// which rules are checked.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/type_family.hpp>
#include <arenite/law/frictional/inertial_friction.hpp>
#include <arenite/law/frictional/linear_rate_friction.hpp>
#include <arenite/law/frictional/logarithmic_friction.hpp>
#include <arenite/law/frictional/rate_softening_friction.hpp>
#include <arenite/law/frictional/rate_stiffness.hpp>
#include <arenite/law/frictional/separation.hpp>
#include <arenite/law/frictional/softening_friction.hpp>
#include <arenite/law/frictional/stiffness.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

using Memories = TypeFamily<ForgetsOpening, RemembersOpening>;
using Frictions = TypeFamily<ConstantFriction, LinearRateFriction, InertialFriction, LogarithmicFriction,
                             SofteningFriction, RateSofteningFriction>;
using Stiffnesses = TypeFamily<ConstantStiffness, PressureStiffness, RateStiffness>;

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
