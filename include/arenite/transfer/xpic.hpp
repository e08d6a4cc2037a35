// XPIC: extended particle-in-cell.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/transfer/corrected_flip.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The vectors that XPIC iterates: the node velocities at the start of the step, from P2G.
struct XpicStart {
  static constexpr const char *order_name = "Xpic.order", *time_name = "Xpic.time";
  template <class Nodes>
  static const auto& of(const Nodes& nodes) {
    return nodes.start;
  }
};

/// Extended particle-in-cell of order m (Hammerquist and Nairn 2017, Comput. Methods Appl. Mech. Eng. 318,
/// 724-738): FLIP with damping of the noise that the nodes do not see; the higher the order, the weaker the
/// damping of anything else. Accelerations are those of FLIP.
///
///   v_p = v_p + sum w_i (v_i^new - v_i^old) - (I - S S+)^m v_p
using Xpic = CorrectedFlip<XpicStart>;

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
