// Energy that a part of a scene accounts for.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Terms of a part in the scene's energy balance (see `energies`), J.
struct PartEnergy {
  double kinetic = 0;     ///< of masses that the part carries
  double stored = 0;      ///< recoverable, as in a spring
  double dissipated = 0;  ///< since the start
  double external = 0;    ///< work that the part brought in since the start
  PartEnergy& operator+=(const PartEnergy& o) {
    kinetic += o.kinetic;
    stored += o.stored;
    dissipated += o.dissipated;
    external += o.external;
    return *this;
  }
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
