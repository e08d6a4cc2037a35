// Tally: what the exchange of impulses did in a step.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Dissipation and counts of contact in a step.
struct ContactTally {
  double dissipation = 0;       ///< energy lost, J
  std::size_t nodes = 0;        ///< node pairs that exchanged an impulse
  std::size_t limited = 0;      ///< node velocities scaled down by the velocity limit
  double limited_momentum = 0;  ///< sum of the magnitudes of momentum that the limit took, N s
  ContactTally& operator+=(const ContactTally& o) {
    dissipation += o.dissipation;
    nodes += o.nodes;
    limited += o.limited;
    limited_momentum += o.limited_momentum;
    return *this;
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
