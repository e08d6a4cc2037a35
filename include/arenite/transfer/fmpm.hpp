// FMPM: the full mass matrix, inverted approximately.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/transfer/corrected_flip.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// The vectors that FMPM iterates: the new velocities of the nodes.
struct FmpmStart {
  static constexpr const char *order_name = "Fmpm.order", *time_name = "Fmpm.time";
  template <class Nodes>
  static const auto& of(const Nodes& nodes) {
    return nodes.velocity;
  }
};

/// FMPM of order k (Nairn and Hammerquist 2021, Comput. Methods Appl. Mech. Eng. 377, 113667): points
/// interpolate the velocities that the momentum of the nodes gives with the full mass matrix M_ij = sum m w_i
/// w_j in place of the lumped one, its inverse approximated by the first k terms of the series (I - S+ S)^l.
/// Accelerations are corrected, too. Strains and positions follow the lumped velocities: with the corrected
/// ones the stable step would fall as 1 / sqrt(k), for they multiply the velocities of light nodes by k.
using Fmpm = CorrectedFlip<FmpmStart>;

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
