// Names of roles: the optional members of a law, the members of a transfer and of a part by which a scene
// knows what they do, and constants that describe them. They are detected by name first and then checked by
// signature: a member with a role's name and another signature would otherwise be ignored silently.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <type_traits>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

// clang-format off
/// All roles: of laws (law/roles.hpp), transfers (transfer/transfer.hpp), both laws and parts, parts
/// (part/roles.hpp).
#define ARENITE_ROLES(role)                                                                           \
  role(is_open) role(yield) role(greatest_volume_ratio) role(max_pack_width) role(two_packs_at_once)  \
  role(linear) role(names)                                                                            \
  role(in_step) role(iterations) role(particle_field) role(gather)                                    \
  role(stable_step)                                                                                   \
  role(connect) role(constrain) role(driven_velocity) role(add_force) role(acceleration)              \
  role(apply_impulses) role(constrain_mapped) role(take_stress_work) role(take_wall_impulse)          \
  role(after_p2g) role(after_grid) role(take_mapped_momentum) role(given_impulse) role(follow_motion) \
  role(renew_points) role(count_energy) role(holds_against) role(visit_state) role(follow_state)      \
  role(hand) role(take) role(sweeps)
// clang-format on

namespace detail {
#define ARENITE_ROLE(role) int role;
struct AllRoles {
  ARENITE_ROLES(ARENITE_ROLE)
};
#undef ARENITE_ROLE
template <class P>
struct WithAllRoles : P, AllRoles {};
}  // namespace detail

/// names_<role><P>: whether P, a class that is not final, has any member of that name. Beside a second base
/// with such a member the name is ambiguous.
#define ARENITE_ROLE(role)                                                        \
  template <class P>                                                              \
  concept names_##role = std::is_class_v<P> && !std::is_final_v<P> && !requires { \
    &detail::WithAllRoles<P>::role;                                               \
  };
ARENITE_ROLES(ARENITE_ROLE)
#undef ARENITE_ROLE
#undef ARENITE_ROLES

/// Whether a part or a transfer may read, of the nodes, the velocity at the start of the step (`field.start`)
/// or the force (`field.sums[i].force()`). It may, unless it says `static constexpr bool
/// reads_start_state = false`. Where none does, B-splines sum momentum and force in one.
template <class P>
inline constexpr bool reads_start_state = [] {
  if constexpr (requires { P::reads_start_state; })
    return P::reads_start_state;
  else
    return true;
}();

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
