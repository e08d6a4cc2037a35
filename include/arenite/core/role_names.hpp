// Names of roles: the optional members of a law, the members of a transfer and of a part by which a scene
// knows what they do, and what they say of themselves. They are looked for by name first and then by
// signature: a member with a role's name and another signature would else be left out in silence.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <type_traits>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// names_<role><P>: whether P, a class that is not final, has any member of that name. Beside a second base
/// with such a member the name is ambiguous.
#define ARENITE_ROLE(role)                                                        \
  namespace detail {                                                              \
  struct Has_##role {                                                             \
    int role;                                                                     \
  };                                                                              \
  template <class P>                                                              \
  struct With_##role : P, Has_##role {};                                          \
  }                                                                               \
  template <class P>                                                              \
  concept names_##role = std::is_class_v<P> && !std::is_final_v<P> && !requires { \
    &detail::With_##role<P>::role;                                                \
  };
// Of laws (law/roles.hpp).
ARENITE_ROLE(is_open)
ARENITE_ROLE(yield)
ARENITE_ROLE(greatest_volume_ratio)
ARENITE_ROLE(max_pack_width)
ARENITE_ROLE(two_packs_at_once)
ARENITE_ROLE(linear)
ARENITE_ROLE(names)
// Of transfers (transfer/transfer.hpp).
ARENITE_ROLE(in_step)
ARENITE_ROLE(sweeps)
ARENITE_ROLE(particle_field)
ARENITE_ROLE(gather)
// Of laws and parts.
ARENITE_ROLE(stable_step)
// Of parts (scene/roles.hpp).
ARENITE_ROLE(connect)
ARENITE_ROLE(constrain)
ARENITE_ROLE(driven_velocity)
ARENITE_ROLE(add_force)
ARENITE_ROLE(acceleration)
ARENITE_ROLE(apply_impulses)
ARENITE_ROLE(constrain_mapped)
ARENITE_ROLE(take_stress_work)
ARENITE_ROLE(take_wall_impulse)
ARENITE_ROLE(after_p2g)
ARENITE_ROLE(after_grid)
ARENITE_ROLE(take_mapped_momentum)
ARENITE_ROLE(given_impulse)
ARENITE_ROLE(follow_motion)
ARENITE_ROLE(renew_points)
ARENITE_ROLE(count_energy)
ARENITE_ROLE(holds_against)
ARENITE_ROLE(visit_state)
ARENITE_ROLE(follow_state)
#undef ARENITE_ROLE

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
