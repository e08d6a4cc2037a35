// What a `Watch` looks at: its limits, and what it saw of each quantity.
#pragma once
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

#include <arenite/core/instruction_set.hpp>

namespace arenite::inline ARENITE_INSTRUCTION_SET {

/// Limits of a `Watch`. Past a limit the run stops, past a tenth of it comes one warning. Infinity switches a
/// quantity off: it is not computed. The watch that a run has of its own has an `energy_gain` of 1, a `volume`
/// of 5 and `lost` 1.
struct WatchLimits {
  /// Energy that nothing put in, over all that was put in, -, positive. Put in are the energy there was, that
  /// of points inserted, and the work of gravity, loads and prescribed motions. Counted are the balance's
  /// residual, and dissipation that is negative, above their lowest value at a look, so that energy that
  /// transfers took hides no gain. Without
  /// `TrackEnergy` what was dissipated is not known: then only a gain beyond it since the first look shows,
  /// and none at the end of a run between two looks. An elastic law stretched by 0.1, beyond the small strains
  /// that it is made for, shows 0.03.
  double energy_gain = 0.1;
  /// Energy that the transfer took, over all that was put in, -, positive; needs the energy balance
  /// (`TrackEnergy`). More than 1 cannot be;
  /// the warning comes at a tenth: APIC takes 0.17 of a column of sand that collapses in cells of a tenth of
  /// its width, and the heap stays short by a fifth.
  double transfer = 1;
  /// What is left of the energy balance, over all that was put in, -, positive; needs `TrackEnergy`. Errors of
  /// time steps, contact and laws. It stays below 0.01 in a sound run; contact with MUSL leaves 0.02.
  double residual = 0.5;
  /// Change of a body's mean volume, |V/V0 - 1|, voids included, -, positive.
  double volume = 0.5;
  /// Greatest speed of a point over the wave speed of its body, -, positive. Above 1 matter cannot give way to what
  /// comes: strains become large in one blow, for which laws of small strains are not made.
  double speed = 10;
  /// How far a stress lies outside the yield surface of its law, -, positive. As `yield(stress)` of the law has
  /// it, for laws with that member. A law that returns to its surface stays within round-off (1e-13, in float
  /// 5e-5).
  double strength = 0.1;
  /// Share of a body's points that left the mesh, -, positive.
  double lost = 0.1;
  /// Steps from one look to the next, -, >= 1.
  std::size_t every = 100;

  /// Of the watch that `run` has of its own. It warns past a tenth of the energy put in gained from nothing
  /// or taken by the transfer, a twentieth of it booked nowhere, half of the volume, the wave speed and a
  /// tenth of the points lost. It stops a run whose energy doubles from nothing, or of whose energy half is
  /// booked nowhere, and no other.
  static WatchLimits of_runs() { return {.energy_gain = 1, .volume = 5, .lost = 1}; }
};

/// What a `Watch` saw of one quantity: its greatest value so far.
struct Watched {
  static constexpr std::array<double, 3> nowhere{std::numeric_limits<double>::quiet_NaN(),
                                                 std::numeric_limits<double>::quiet_NaN(),
                                                 std::numeric_limits<double>::quiet_NaN()};

  std::string_view name;     ///< the limit's name in `WatchLimits`
  std::string_view meaning;  ///< in words
  double limit = 0;
  double worst = std::numeric_limits<double>::quiet_NaN();  ///< -; NaN: not looked at
  double time = std::numeric_limits<double>::quiet_NaN();   ///< of the worst value, s
  int body = -1;                                            ///< of the worst value; -1: the whole scene
  /// Position of the point that shows it most, m; NaN below a tenth of the limit, and where no point does.
  std::array<double, 3> place = nowhere;
  bool warned = false;
};

}  // namespace arenite::inline ARENITE_INSTRUCTION_SET
